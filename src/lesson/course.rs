//! The course as the app, export and the command line use it, and how it is loaded.

use std::{
    collections::{BTreeMap, BTreeSet},
    sync::Arc,
};

use crate::{
    figure::Moment,
    labs::{Lock, Scene},
    text::{Diagnostic, Lang, Message},
};

use super::{
    files::{Embedded, Files},
    lesson_file::{self, Skeleton},
    markdown::Block,
    problem::{Problem, Severity},
    scene_file::SceneFormats,
    sections,
    sink::Sink,
    source::Source,
};

/// More lessons than this in one folder are left out.
pub const MAX_LESSONS: usize = 1_000;

/// What makes a folder a lesson.
pub(super) const LESSON_FILE: &str = "lesson.toml";

/// Lessons in the order of their folders' names.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Course {
    /// Each valid; broken ones have been left out.
    pub lessons: Vec<Lesson>,
}

/// What came of loading a course.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Loaded {
    /// The lessons that are in order.
    pub course: Course,
    /// Every mistake of every file, by file and then from its top to its end.
    pub problems: Vec<Problem>,
}

/// One lesson: at least one step, and a text for each in English.
#[derive(Clone, PartialEq, Debug)]
pub struct Lesson {
    /// Its folder's name: `01-windows`.
    pub id: String,
    /// The id of the lab where its scenes live.
    pub lab: &'static str,
    /// Author and year of what it teaches.
    pub source: String,
    /// At least one.
    pub steps: Vec<Step>,
    pub(super) english: LessonText,
    pub(super) translations: BTreeMap<Lang, LessonText>,
}

/// One step of a lesson: a scene, and where its run stops.
#[derive(Clone, PartialEq, Debug)]
pub struct Step {
    /// Unique in the lesson.
    pub id: String,
    /// Shared by the steps that show it, since it may be large.
    pub scene: Arc<Scene>,
    /// As the lesson names it.
    pub moment: Moment,
    /// The step of the first method's run at which that moment comes.
    pub position: usize,
    /// The figure that export makes of it, unique in the lesson: lower-case letters, digits and hyphens.
    pub figure: Option<String>,
    /// Handles that cannot be dragged.
    pub locks: Vec<Lock>,
    /// How the pseudocode is first shown.
    pub code: CodeView,
}

/// How the pseudocode is shown.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Hash)]
pub enum CodeView {
    /// As code.
    #[default]
    Full,
    /// In words.
    Words,
    /// Not at all, so that a class can be asked first.
    Hidden,
}

/// A lesson's text in one language.
#[derive(Clone, PartialEq, Debug)]
pub struct LessonText {
    /// The lesson's title.
    pub title: String,
    /// One for each step, in their order.
    pub steps: Vec<StepText>,
}

/// A step's text in one language.
#[derive(Clone, PartialEq, Debug)]
pub struct StepText {
    /// The step's title.
    pub title: String,
    /// What is read, from top to bottom.
    pub body: Vec<Block>,
}

impl CodeView {
    /// Every view, in the order in which they hide more and more.
    pub const ALL: [Self; 3] = [Self::Full, Self::Words, Self::Hidden];

    /// As lesson files spell it.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Full => "full",
            Self::Words => "words",
            Self::Hidden => "hidden",
        }
    }
}

impl Lesson {
    /// The text in this language, or in English where there is none.
    #[must_use]
    pub fn text(&self, lang: Lang) -> &LessonText {
        self.translations.get(&lang).unwrap_or(&self.english)
    }

    /// Is there a text in this language?
    #[must_use]
    pub fn speaks(&self, lang: Lang) -> bool {
        lang == Lang::En || self.translations.contains_key(&lang)
    }

    /// The index of the step with this id.
    #[must_use]
    pub fn step_index(&self, id: &str) -> Option<usize> {
        self.steps.iter().position(|step| step.id == id)
    }

    /// The title of the step with this id, in this language or in English.
    #[must_use]
    pub fn step_title(&self, id: &str, lang: Lang) -> Option<&str> {
        let step = self.text(lang).steps.get(self.step_index(id)?)?;
        Some(&step.title)
    }
}

impl Course {
    /// The course that is compiled in. A test keeps it free of problems.
    #[must_use]
    pub fn embedded() -> Self {
        Self::load(&Embedded).course
    }

    /// The lesson in the folder of this name.
    #[must_use]
    pub fn lesson(&self, id: &str) -> Option<&Lesson> {
        self.lessons.iter().find(|lesson| lesson.id == id)
    }

    /// Reads and checks every lesson. One with an error is left out; all others stay.
    #[must_use]
    pub fn load(files: &dyn Files) -> Loaded {
        Self::load_with(files, SceneFormats::standard())
    }

    /// The same, with scenes spelt as these formats have it.
    #[must_use]
    pub fn load_with(files: &dyn Files, formats: SceneFormats) -> Loaded {
        let mut loaded = Loaded::default();
        let paths = match files.list() {
            Ok(paths) => paths,
            Err(error) => {
                loaded
                    .problems
                    .push(whole_file(files.shown(""), Severity::Error, error));
                return loaded;
            }
        };
        let folders = folders(&paths);
        if folders.is_empty() {
            let message = Message::new("problem-no-lessons");
            let problem = whole_file(files.shown(""), Severity::Error, message);
            loaded
                .problems
                .push(problem.expecting("expect-lesson-folder"));
        }
        for (id, names) in folders.iter().take(MAX_LESSONS) {
            let (lesson, problems) = load_lesson(files, formats, id, names);
            loaded.course.lessons.extend(lesson);
            loaded.problems.extend(problems);
        }
        if folders.len() > MAX_LESSONS {
            let message = Message::new("problem-too-many-lessons").with("limit", MAX_LESSONS);
            let problem = whole_file(files.shown(""), Severity::Error, message);
            loaded.problems.push(problem);
        }
        loaded
    }
}

/// Lesson folders and the names of the files in them that matter.
fn folders(paths: &[String]) -> BTreeMap<&str, BTreeSet<&str>> {
    let mut folders: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
    for path in paths {
        if let Some((id, name)) = path.split_once('/') {
            folders.entry(id).or_default().insert(name);
        }
    }
    // A folder with neither file is something else: pictures, drafts, version control.
    folders.retain(|_, names| names.contains(LESSON_FILE) || names.contains("en.md"));
    folders
}

fn load_lesson(
    files: &dyn Files,
    formats: SceneFormats,
    id: &str,
    names: &BTreeSet<&str>,
) -> (Option<Lesson>, Vec<Problem>) {
    let mut problems = Vec::new();
    let skeleton = lesson_toml(files, formats, id, names, &mut problems);
    let mut texts = BTreeMap::new();
    for name in names.iter().filter(|name| is_text(name)) {
        let path = format!("{id}/{name}");
        let stem = name.trim_end_matches(".md");
        let Some(lang) = Lang::ALL.into_iter().find(|lang| lang.id() == stem) else {
            problems.push(unknown_language(files.shown(&path), stem));
            continue;
        };
        match files.read(&path) {
            Err(error) => problems.push(whole_file(files.shown(&path), Severity::Error, error)),
            Ok(bytes) => {
                let source = Source::new(files.shown(&path), &bytes);
                let mut sink = Sink::new(&source);
                let ids = skeleton
                    .as_ref()
                    .and_then(|skeleton| skeleton.ids.as_deref());
                texts.extend(sections::read(ids, &mut sink).map(|text| (lang, text)));
                problems.extend(sink.into_problems());
            }
        }
    }
    for lang in Lang::ALL {
        let name = format!("{lang}.md");
        if !names.contains(&*name) {
            problems.push(missing_text(files.shown(&format!("{id}/{name}")), lang));
        }
    }
    let is_broken = problems.iter().any(|p| p.severity == Severity::Error);
    let lesson = (!is_broken)
        .then(|| skeleton?.into_lesson(id, texts))
        .flatten();
    (lesson, problems)
}

fn lesson_toml(
    files: &dyn Files,
    formats: SceneFormats,
    id: &str,
    names: &BTreeSet<&str>,
    problems: &mut Vec<Problem>,
) -> Option<Skeleton> {
    let path = format!("{id}/{LESSON_FILE}");
    if !names.contains(LESSON_FILE) {
        let message = Message::new("problem-missing-file");
        let problem = whole_file(files.shown(&path), Severity::Error, message);
        problems.push(problem.expecting("expect-lesson-folder"));
        return None;
    }
    match files.read(&path) {
        Err(error) => {
            problems.push(whole_file(files.shown(&path), Severity::Error, error));
            None
        }
        Ok(bytes) => {
            let source = Source::new(files.shown(&path), &bytes);
            let mut sink = Sink::new(&source);
            let skeleton = lesson_file::read(formats, &mut sink);
            problems.extend(sink.into_problems());
            skeleton
        }
    }
}

/// A language's text; a folder may have a README of its own.
fn is_text(name: &str) -> bool {
    !name.contains('/') && name != "README.md" && name.strip_suffix(".md").is_some()
}

fn whole_file(file: String, severity: Severity, what: impl Into<Diagnostic>) -> Problem {
    Problem {
        file,
        place: None,
        severity,
        what: what.into(),
    }
}

impl Problem {
    fn expecting(mut self, key: &'static str) -> Self {
        self.what.notes.push(Message::new(key));
        self
    }
}

fn unknown_language(file: String, stem: &str) -> Problem {
    let message = Message::new("problem-unknown-language").with("name", stem.to_owned());
    let known = Lang::ALL.map(Lang::id);
    let mut problem = whole_file(file, Severity::Error, message);
    let meant = Lang::from_locale(stem).map(Lang::id);
    problem.what.notes = super::toml_fields::suggestion(meant, &known);
    problem
}

fn missing_text(file: String, lang: Lang) -> Problem {
    if lang == Lang::En {
        let message = Message::new("problem-missing-file");
        return whole_file(file, Severity::Error, message).expecting("expect-lesson-folder");
    }
    let message =
        Message::new("problem-missing-language").with("language", lang.native_name().to_owned());
    whole_file(file, Severity::Warning, message)
}
