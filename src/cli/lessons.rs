//! The lessons and scene files that a command names, and `clipscope check`: are they in order?

use std::{
    collections::BTreeSet,
    path::{Path, PathBuf},
};

use crate::{
    export::write_whole,
    lesson::{
        Course, Embedded, Files, Folder, Lesson, Loaded, MAX_FILE_BYTES, MAX_SCENE_BYTES, Problem,
        SceneFile, SceneFormats, Severity, TRANSLATED_FILE, read_file, translated,
    },
    text::{Catalog, Diagnostic, Lang, Message, printable},
};

use super::{
    Outcome, lang_parser, say,
    say::{print, say_text},
};

#[derive(Default)]
pub(super) struct Chosen {
    pub lessons: Vec<Lesson>,
    /// Of each lesson, then of each scene, the name that it was asked for by.
    pub asked: Vec<String>,
    /// The scenes of files, each with its name without the ending.
    pub scenes: Vec<(String, SceneFile)>,
    problems: Vec<Problem>,
    /// Why something that was named was not found, or could not be read.
    unread: Vec<Message>,
}

/// Each name is a path to a lesson, to a folder of lessons or to a scene file, else a lesson of the embedded course; without
/// names it is that course, read by `embedded`: it has been checked already, unless that is what was asked for.
pub(super) fn choose(names: &[PathBuf], embedded: fn(&dyn Files) -> Loaded) -> Chosen {
    let mut chosen = Chosen::default();
    if names.is_empty() {
        let loaded = embedded(&Embedded);
        chosen.asked = loaded
            .course
            .lessons
            .iter()
            .map(|it| it.id.clone())
            .collect();
        chosen.lessons = loaded.course.lessons;
        chosen.problems = loaded.problems;
        return chosen;
    }
    let mut course = None;
    let mut scenes = Vec::new();
    for name in names {
        // A pipe, a device or a link that leads nowhere is no scene either, and is told what it is.
        if !name.is_dir() && name.symlink_metadata().is_ok() {
            scenes.extend(chosen.read_scene(name).then(|| shown(name)));
            continue;
        }
        if name.exists() {
            let loaded = Course::check(&Folder::new(name));
            let n_lessons = loaded.course.lessons.len();
            chosen
                .asked
                .extend(std::iter::repeat_n(shown(name), n_lessons));
            chosen.lessons.extend(loaded.course.lessons);
            chosen.problems.extend(loaded.problems);
            continue;
        }
        let course = course.get_or_insert_with(|| embedded(&Embedded).course);
        match name.to_str().and_then(|id| course.lesson(id)) {
            Some(lesson) => {
                chosen.asked.push(shown(name));
                chosen.lessons.push(lesson.clone());
            }
            None => {
                let message = Message::new("cli-no-lesson");
                chosen.unread.push(message.with("name", shown(name)));
            }
        }
    }
    chosen.asked.extend(scenes);
    chosen
}

impl Chosen {
    pub const fn is_empty(&self) -> bool {
        self.lessons.is_empty() && self.scenes.is_empty()
    }

    /// Is it one?
    fn read_scene(&mut self, path: &Path) -> bool {
        let read = read_file(path, MAX_SCENE_BYTES).map_err(|error| {
            Message::new("cli-unreadable")
                .with("path", shown(path))
                .with("reason", Diagnostic::from(error))
        });
        let stem = path.file_stem().unwrap_or_default().to_string_lossy();
        match read.map(|bytes| SceneFormats::standard().read(&shown(path), &bytes)) {
            Ok(Ok(scene)) => {
                self.scenes.push((stem.into_owned(), scene));
                return true;
            }
            Ok(Err(problems)) => self.problems.extend(problems),
            Err(message) => self.unread.push(message),
        }
        false
    }

    /// Names on standard error what is wrong.
    pub fn report(&self, lang: Lang, is_told: fn(&Problem) -> bool) -> Outcome {
        let told = self.problems.iter().filter(|problem| is_told(problem));
        let (untranslated, told): (Vec<_>, Vec<_>) = told.partition(|it| is_untranslated(it));
        for problem in told {
            say_text(&problem.render(Catalog::of(lang)));
        }
        if !untranslated.is_empty() {
            say(lang, &without_translation(&untranslated));
        }
        let errors: Vec<&Problem> = self.problems.iter().filter(|p| is_error(p)).collect();
        for message in &self.unread {
            say(lang, message);
        }
        let nothing_read = |problem: &Problem| {
            problem.place.is_none() && matches!(problem.code(), "no-lessons" | "unreadable")
        };
        match errors.len() + self.unread.len() {
            0 => Outcome::Done,
            _ if self.is_empty() && errors.iter().all(|p| nothing_read(p)) => Outcome::Unusable,
            _ => Outcome::Refused,
        }
    }
}

fn is_untranslated(problem: &Problem) -> bool {
    problem.code() == "missing-language"
}

/// Other languages than English are optional: said once for all lessons, by the files that are not there.
fn without_translation(missing: &[&Problem]) -> Message {
    let files = || missing.iter().map(|problem| Path::new(&problem.file));
    let lessons: BTreeSet<Option<&Path>> = files().map(Path::parent).collect();
    let is_missing = |lang: &Lang| files().any(|file| file.ends_with(format!("{lang}.md")));
    let languages = Lang::ALL.into_iter().filter(is_missing);
    let languages: Vec<&str> = languages.map(Lang::native_name).collect();
    Message::new("cli-untranslated")
        .with("count", lessons.len())
        .with("languages", languages.join(", "))
}

pub(super) fn is_error(problem: &Problem) -> bool {
    problem.severity == Severity::Error
}

fn shown(path: &Path) -> String {
    path.display().to_string()
}

const EXAMPLES: &str = "\
Examples:
  clipscope check                          the embedded course
  clipscope check my-course/01-outcodes    one lesson
  clipscope check my-course                every lesson of a folder
  clipscope check scene.toml               a scene file
  clipscope check 05-intervals --names     what its text can refer to
  clipscope check 05-intervals --filled    its text as it is read
  clipscope check my-course --translated   its translations are up to date";

#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Args {
    /// Lesson folders, folders of lessons, scene files, or lessons of the embedded course by name
    #[arg(value_name = "LESSON")]
    lessons: Vec<PathBuf>,
    /// Print the texts as they are read, with the numbers of their runs in place of references
    #[arg(long)]
    filled: bool,
    /// Print what the text of each step can refer to, with its value there
    #[arg(long, conflicts_with = "filled")]
    names: bool,
    /// Write down, in each lesson's folder, that its translations are made from the English as it is
    #[arg(long)]
    translated: bool,
    /// Language of messages, and of the texts that are printed
    #[arg(long, value_name = "LANG", default_value_t = Lang::En, value_parser = lang_parser())]
    lang: Lang,
}

/// The texts of lessons with references filled in, one after the other.
fn filled(chosen: &Chosen, lang: Lang) -> String {
    let read = |(lesson, asked): (&Lesson, &String)| {
        let path = format!("{}/{lang}.md", lesson.id);
        // Each from where it was found: a folder of one lesson answers to any lesson's name.
        let found = Folder::new(asked).read(&path).ok();
        let bytes = found.or_else(|| Embedded.read(&path).ok())?;
        let source = String::from_utf8(bytes).ok()?;
        Some(lesson.filled(source.trim_start_matches('\u{feff}'), lang))
    };
    let lessons = chosen.lessons.iter().zip(&chosen.asked);
    lessons.filter_map(read).collect()
}

/// What the texts of lessons can refer to, step by step.
fn names(lessons: &[Lesson], catalog: &Catalog) -> String {
    let steps = lessons
        .iter()
        .flat_map(|lesson| lesson.steps.iter().map(move |step| (lesson, step)));
    let said = steps.map(|(lesson, step)| {
        let named = lesson.names(step, catalog).into_iter();
        let named = named.map(|(name, value)| format!("  {name} = {value}\n"));
        format!(
            "{}/{} @ {}\n{}",
            lesson.id,
            step.id,
            step.moment,
            named.collect::<String>()
        )
    });
    said.collect()
}

/// Of each lesson that stands in a folder of its own.
fn note_translated(names: &[PathBuf]) -> Result<(), Message> {
    for name in names {
        let inner = name.read_dir().into_iter().flatten().flatten();
        let folders = inner.map(|entry| entry.path()).chain([name.clone()]);
        for folder in folders {
            let Ok(english) = read_file(&folder.join("en.md"), MAX_FILE_BYTES as u64) else {
                continue;
            };
            let langs = Lang::ALL.into_iter().filter(|lang| *lang != Lang::En);
            let langs = langs.filter(|lang| folder.join(format!("{lang}.md")).exists());
            let langs: Vec<Lang> = langs.collect();
            let written = translated(&String::from_utf8_lossy(&english), &langs);
            let path = folder.join(TRANSLATED_FILE);
            write_whole(&path, written.as_bytes()).map_err(|error| {
                Message::new("error-at")
                    .with("place", shown(&path))
                    .with("problem", Diagnostic::from(error))
            })?;
        }
    }
    Ok(())
}

pub(super) fn check(args: &Args) -> Outcome {
    if args.translated
        && let Err(message) = note_translated(&args.lessons)
    {
        say(args.lang, &message);
        return Outcome::Unusable;
    }
    let chosen = choose(&args.lessons, Course::check);
    let outcome = chosen.report(args.lang, |_| true);
    let counts = [
        ("cli-checked", chosen.lessons.len()),
        ("cli-checked-scenes", chosen.scenes.len()),
    ];
    let mut sum = String::new();
    if args.filled {
        sum += &filled(&chosen, args.lang);
    }
    if args.names {
        sum += &names(&chosen.lessons, Catalog::of(args.lang));
    }
    for (key, count) in counts.into_iter().filter(|(_, count)| *count > 0) {
        sum += &Catalog::of(args.lang).message(&Message::new(key).with("count", count));
        sum += "\n";
    }
    if sum.is_empty() {
        return outcome;
    }
    match print(&printable(&sum), args.lang) {
        Outcome::Done => outcome,
        failed => failed,
    }
}
