//! `clipscope export`: figures to files.

use std::{collections::HashSet, path::PathBuf, str::FromStr};

use clap::builder::{PossibleValuesParser, TypedValueParser};

use crate::{
    app::{App, Page, Places, Settings},
    export::{
        Content, Failure, Format, Job, Letters, Options, Source, Steps, Studio, Way, between,
        in_format, jobs, jobs_of, run,
    },
    figure::Moment,
    lesson::Course,
    paint::{Headless, ThemeKind},
    text::{Lang, Message},
};

use super::{
    Outcome, Progress, lang_parser,
    lessons::{Chosen, choose, is_error},
    say, slides,
    usage::Expected,
    written::{Names, made, told},
};

const EXAMPLES: &str = "\
Examples:
  clipscope export --out figures
  clipscope export 03-outcodes --out slides --theme projector --scale 2
  clipscope export --out figuras --lang pt-BR --steps all
  clipscope export scene.toml --out figures
  clipscope export 03-outcodes --out handout --questions --alt
  clipscope export 05-intervals --out book --format svg,pdf
  clipscope export 03-outcodes --out site --format apng,gif --size 1280x720
  clipscope export 05-intervals --out film --format frames --steps start..end
  clipscope export scene.toml --out part --format apng --steps \"row left..row top\"
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
    /// The figures that lessons name, every step of every run (all), or those from one moment to another, as lesson files write them (FROM..TO)
    #[arg(long, value_name = "STEPS", default_value = "figures")]
    pub steps: Which,
    /// The whole window of the app instead of the stage alone
    #[arg(long)]
    pub window: bool,
    /// Beside each picture a text file of its name: title and sentence, for who cannot see it
    #[arg(long)]
    pub alt: bool,
    /// In SVG files letters as shapes: for programs that take no fonts from a file
    #[arg(long)]
    pub outlines: bool,
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

/// Which steps are drawn.
#[derive(Clone, PartialEq, Debug)]
pub(super) enum Which {
    Figures,
    All,
    Between([Moment; 2]),
}

impl Which {
    const fn steps(&self) -> Steps {
        match self {
            Self::Figures => Steps::Figures,
            Self::All | Self::Between(_) => Steps::All,
        }
    }
}

impl FromStr for Which {
    type Err = Expected;

    fn from_str(text: &str) -> Result<Self, Expected> {
        let expected = || Expected(Message::new("usage-expected-steps"));
        match text {
            "figures" => Ok(Self::Figures),
            "all" => Ok(Self::All),
            _ => {
                let (from, to) = text.split_once("..").ok_or_else(expected)?;
                let moment = |text: &str| text.parse().map_err(|_| expected());
                Ok(Self::Between([moment(from)?, moment(to)?]))
            }
        }
    }
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
        steps: args.steps.steps(),
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
    let (sum, failures) = if args.slides {
        let decks: Vec<&[Job<'_>]> = jobs.chunk_by(Job::is_beside).collect();
        let failures = slides::write(&decks, options, &args.out);
        (("cli-exported-slides", decks.len()), failures)
    } else {
        let course = Course {
            lessons: chosen.lessons.clone(),
        };
        let failures = drawn(args, options, &course, &jobs);
        (("cli-exported", jobs.len()), failures)
    };
    told(args.lang, &args.out, sum, failures, read)
}

/// Draws and writes them all; those that could not be written.
fn drawn(args: &Args, options: Options, course: &Course, jobs: &[Job<'_>]) -> Vec<Failure> {
    let way = Way {
        letters: if args.outlines {
            Letters::Outlines
        } else {
            Letters::Fonts
        },
        page: args.link.as_deref(),
        ..Way::of(options)
    };
    let mut progress = Progress::new(jobs.len() as u64);
    let draw = |job: &Job<'_>, studio: &mut Studio| Content {
        alternative: args.alt.then(|| studio.alternative(&job.picture(options))),
        made: if args.window {
            window_png(job, course, studio.table(), args).into()
        } else {
            job.made(studio, way)
        },
    };
    run(jobs, options.theme, &args.out, draw, || progress.advance(1))
}

/// What is drawn in each format. Whole windows are pixels; questions and windows stand still.
fn all_jobs<'a>(chosen: &'a Chosen, args: &Args) -> Result<Vec<Job<'a>>, Message> {
    let mut all = Vec::new();
    for &format in &args.format {
        if format.is_loop() && (args.window || args.questions) {
            return Err(
                Message::new("export-no-loop").with("format", format.extension().to_owned())
            );
        }
        if format != Format::Png && args.window {
            let message = Message::new("export-window-is-pixels");
            return Err(message.with("format", format.extension().to_owned()));
        }
        let steps = match format {
            Format::Frames => Steps::All,
            _ if format.is_loop() => Steps::Figures,
            _ => args.steps.steps(),
        };
        let jobs = in_format(drawn_once(chosen, steps)?, format);
        all.extend(match &args.steps {
            Which::Between(moments) => between(jobs, moments).map_err(|missing| {
                let message = Message::new("export-no-moment");
                let message = message.with("moment", missing.moment.to_string());
                message.with("path", missing.path)
            })?,
            Which::Figures | Which::All => jobs,
        });
    }
    // The frames of a film are the pictures of all steps.
    let mut paths = HashSet::new();
    all.retain(|job: &Job<'_>| paths.insert(job.path.clone()));
    Ok(all)
}

/// All figures. Two that would be one file are refused before anything is drawn.
fn drawn_once(chosen: &Chosen, steps: Steps) -> Result<Vec<Job<'_>>, Message> {
    let lessons = chosen.lessons.iter().map(|lesson| jobs([lesson], steps));
    let scenes = chosen.scenes.iter();
    let scenes = scenes.map(|(name, scene)| jobs_of(Source::File(scene), name, steps));
    let mut names = Names::default();
    let mut all = Vec::new();
    for (own, asked) in lessons.chain(scenes).zip(&chosen.asked) {
        for job in own {
            names.take(&job.path, asked)?;
            all.push(job);
        }
    }
    Ok(all)
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
