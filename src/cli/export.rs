//! `clipscope export`: figures to files.

use std::{
    collections::BTreeMap,
    fs, io,
    path::{Path, PathBuf},
    str::FromStr,
};

use clap::{
    ValueEnum,
    builder::{PossibleValuesParser, TypedValueParser},
};

use crate::{
    app::{App, Page, Places, Settings},
    export::{Content, Failure, Job, Options, Source, Steps, Studio, jobs, jobs_of, loops, run},
    lesson::Course,
    paint::{Headless, ThemeKind},
    text::{Diagnostic, Lang, Message},
};

use super::{
    Outcome, Progress, lang_parser,
    lessons::{Chosen, choose, is_error},
    say, slides,
    usage::Expected,
};

const EXAMPLES: &str = "\
Examples:
  clipscope export --out figures
  clipscope export 03-outcodes --out slides --theme projector --scale 2
  clipscope export --out figuras --lang pt-BR --steps all
  clipscope export scene.toml --out figures
  clipscope export 03-outcodes --out handout --questions --alt
  clipscope export 03-outcodes --out site --format apng --size 1280x720
  clipscope export 03-outcodes --out talk --slides --theme projector
  clipscope export 03-outcodes --out slides --link=https://example.org/clipscope/

The same input gives the same bytes on every machine. A file is written whole or not at all.";

#[allow(
    clippy::struct_excessive_bools,
    reason = "each is a flag, given or not whatever the others are"
)]
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Args {
    /// Lessons of the embedded course by name, lesson folders, or scene files; all of the course where none is given
    #[arg(value_name = "LESSON")]
    pub lessons: Vec<PathBuf>,
    /// The folder to write to; it is made where it is not there
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// File formats
    #[arg(long, value_enum, value_delimiter = ',', default_value = "png")]
    pub format: Vec<Format>,
    /// Width and height; text keeps its proportion to the picture
    #[arg(long, value_name = "WxH", default_value = "1920x1080")]
    pub size: Size,
    /// Multiplies both sides, for screens and printers of high density
    #[arg(long, value_name = "N", default_value_t = 1.0, value_parser = scale)]
    pub scale: f32,
    /// Colours
    #[arg(long, value_name = "THEME", default_value_t = ThemeKind::Light, value_parser = theme_parser())]
    pub theme: ThemeKind,
    /// Language of labels and captions
    #[arg(long, value_name = "LANG", default_value_t = Lang::En, value_parser = lang_parser())]
    pub lang: Lang,
    /// The figures that lessons name, or every step of every run
    #[arg(long, value_enum, default_value_t = Steps::Figures)]
    pub steps: Steps,
    /// The whole window of the app instead of the stage alone
    #[arg(long)]
    pub window: bool,
    /// Beside each picture a text file of its name: title and sentence, for who cannot see it
    #[arg(long)]
    pub alt: bool,
    /// Prints in each figure's foot the link that opens it, behind the address of a page where one is given
    #[arg(long, value_name = "ADDRESS", num_args = 0..=1, require_equals = true, default_missing_value = "", conflicts_with = "window")]
    pub link: Option<String>,
    /// What is asked instead of what is answered: the step before, and what might come
    #[arg(long, conflicts_with = "window")]
    pub questions: bool,
    /// One page for each lesson, to be paged through: where a step asks, its question first, its answer on the next press
    #[arg(long, conflicts_with_all = ["window", "questions", "format", "link", "alt", "steps"])]
    pub slides: bool,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
pub(super) enum Format {
    /// Pixels
    Png,
    /// The whole run of each figure as a loop of pictures: an animated PNG
    Apng,
}

fn theme_parser() -> impl TypedValueParser<Value = ThemeKind> {
    PossibleValuesParser::new(ThemeKind::ALL.map(ThemeKind::id))
        .map(|id| ThemeKind::from_id(&id).unwrap_or_default())
}

/// Width and height in pixels at scale 1.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Size([u32; 2]);

impl FromStr for Size {
    type Err = Expected;

    fn from_str(text: &str) -> Result<Self, Expected> {
        let expected = || {
            let most = format!("{MAX_SIDE}x{MAX_SIDE}");
            Expected(Message::new("usage-expected-size").with("most", most))
        };
        let (width, height) = text.split_once(['x', '×']).ok_or_else(expected)?;
        let side = |text: &str| match text.parse() {
            Ok(side @ 64..=MAX_SIDE) => Ok(side),
            _ => Err(expected()),
        };
        Ok(Self([side(width)?, side(height)?]))
    }
}

/// A picture of this side at scale 1 takes 1 GiB in memory: nothing prints larger.
const MAX_SIDE: u32 = 16_384;

fn scale(text: &str) -> Result<f32, Expected> {
    match text.parse() {
        Ok(scale) if (0.25..=8.0).contains(&scale) => Ok(scale),
        _ => Err(Expected(Message::new("usage-expected-scale"))),
    }
}

pub(super) fn export(args: &Args) -> Outcome {
    let chosen = choose(&args.lessons, Course::load);
    let read = chosen.report(args.lang, is_error);
    if chosen.is_empty() {
        return read;
    }
    let options = Options {
        size_px: args.size.0.map(|side| (side as f32 * args.scale) as u32),
        theme: args.theme,
        lang: args.lang,
        steps: args.steps,
        asks: args.questions,
    };
    let jobs = match all_jobs(&chosen, args) {
        Ok(jobs) => jobs,
        Err(message) => {
            say(args.lang, &message);
            return Outcome::Unusable;
        }
    };
    if let Err(message) = made(&args.out) {
        say(args.lang, &message);
        return Outcome::Unusable;
    }
    if args.slides {
        let decks: Vec<&[Job<'_>]> = jobs.chunk_by(Job::is_beside).collect();
        let failures = slides::write(&decks, options, &args.out);
        return told(args, ("cli-exported-slides", decks.len()), failures, read);
    }
    let course = Course {
        lessons: chosen.lessons.clone(),
    };
    let mut progress = Progress::new(jobs.len() as u64);
    let draw = |job: &Job<'_>, studio: &mut Studio| Content {
        alternative: args.alt.then(|| studio.alternative(&job.picture(options))),
        picture: if args.window {
            window_png(job, &course, studio.table(), args)
        } else if job.is_loop {
            job.animation(studio, options, args.link.as_deref())
        } else {
            job.png(studio, options, args.link.as_deref())
        },
    };
    let done = || progress.advance(1);
    let failures = run(&jobs, options.theme, &args.out, draw, done);
    drop(progress);
    told(args, ("cli-exported", jobs.len()), failures, read)
}

/// The folder, where it was not there.
fn made(out: &Path) -> Result<(), Message> {
    fs::create_dir_all(out).map_err(|error| {
        // What is there already is something else.
        let error = match error.kind() {
            io::ErrorKind::AlreadyExists => io::ErrorKind::NotADirectory.into(),
            _ => error,
        };
        failed(out.display().to_string(), error)
    })
}

/// Says why files were not written, and how many were.
fn told(
    args: &Args,
    (key, n_files): (&'static str, usize),
    failures: Vec<Failure>,
    read: Outcome,
) -> Outcome {
    let is_whole = failures.is_empty();
    let n_written = n_files - failures.len();
    for Failure { path, error } in failures {
        say(args.lang, &failed(path, error));
    }
    let sum = Message::new(key)
        .with("count", n_written)
        .with("path", args.out.display().to_string());
    say(args.lang, &sum);
    match (is_whole, n_written) {
        (true, _) => read,
        (false, 0) => Outcome::Unusable,
        (false, _) => Outcome::Refused,
    }
}

/// What is drawn in each format. Loops are of figures: whole windows and questions stand still.
fn all_jobs<'a>(chosen: &'a Chosen, args: &Args) -> Result<Vec<Job<'a>>, Message> {
    let mut all = Vec::new();
    if args.format.contains(&Format::Png) {
        all = drawn_once(chosen, args.steps)?;
    }
    if args.format.contains(&Format::Apng) {
        if args.window || args.questions {
            return Err(Message::new("export-no-loop"));
        }
        all.extend(loops(drawn_once(chosen, Steps::Figures)?));
    }
    Ok(all)
}

/// All figures. Two that would be one file are refused before anything is drawn.
fn drawn_once(chosen: &Chosen, steps: Steps) -> Result<Vec<Job<'_>>, Message> {
    let lessons = chosen.lessons.iter().map(|lesson| jobs([lesson], steps));
    let scenes = chosen.scenes.iter();
    let scenes = scenes.map(|(name, scene)| jobs_of(Source::File(scene), name, steps));
    let mut known: BTreeMap<String, &str> = BTreeMap::new();
    let mut all = Vec::new();
    for (own, asked) in lessons.chain(scenes).zip(&chosen.asked) {
        for job in own {
            // Many systems take capitals and small letters for one.
            if let Some(first) = known.insert(job.path.to_lowercase(), asked) {
                let message = Message::new("export-same-name").with("path", job.path);
                let message = message.with("first", first.to_owned());
                return Err(message.with("second", asked.clone()));
            }
            all.push(job);
        }
    }
    Ok(all)
}

fn failed(path: String, error: io::Error) -> Message {
    let reason = Message::new("error-at").with("place", path);
    let reason = reason.with("problem", Diagnostic::from(error));
    Message::new("status-export-failed").with("reason", reason)
}

fn window_png(job: &Job<'_>, course: &Course, table: &mut Headless, args: &Args) -> Vec<u8> {
    let settings = Settings {
        lang: args.lang,
        theme: args.theme,
        places: Places {
            page: match job.source {
                Source::Step(lesson, step) => Some(Page::Step(lesson.id.clone(), step.id.clone())),
                Source::File(_) => None,
            },
            ..Places::default()
        },
        // The picture is of the step itself.
        asks: false,
        ..Settings::default()
    };
    let size: egui::Vec2 = args.size.0.map(|side| side as f32).into();
    let mut app = App::new(course.clone(), settings);
    if let Source::File(file) = job.source {
        app = app.with_scene(&job.path, file.clone());
    }
    // The figure of a step may show another scene than the window begins with.
    let own = match job.source {
        Source::Step(_, step) if step.drawn().scene != step.scene => step.position(),
        Source::Step(..) | Source::File(_) => None,
    };
    app.seek(own.unwrap_or(job.position));
    let image = table.draw(size, args.scale, |ui| app.ui(ui));
    image.to_linked_png(app.link().fitting().as_deref())
}
