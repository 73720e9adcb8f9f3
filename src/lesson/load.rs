//! From files to a course, and to what is wrong with them.

use std::collections::{BTreeMap, BTreeSet};

use crate::text::{Diagnostic, Lang, Message};

use super::{
    course::{Course, Lesson},
    embedded::Embedded,
    files::{Files, LESSON_FILE, MAX_LESSONS},
    lesson_file::{self, Moments, Reading, Skeleton},
    problem::{Problem, Severity},
    scene_file::SceneFormats,
    sections,
    sink::Sink,
    source::Source,
    toml_fields::suggestion,
};

/// What came of loading a course.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Loaded {
    /// The lessons that are in order.
    pub course: Course,
    /// Every mistake of every file, by file and then from its top to its end.
    pub problems: Vec<Problem>,
}

impl Course {
    /// The course that is compiled in. A test keeps it free of problems.
    pub fn embedded() -> Self {
        Self::load(&Embedded).course
    }

    /// Reads every lesson; one with an error is left out, all others stay. Moments are looked for when they are
    /// needed: [`LessonStep::position`](super::LessonStep::position).
    pub fn load(files: &dyn Files) -> Loaded {
        let formats = SceneFormats::standard();
        let moments = Moments::Later;
        load(files, Reading { formats, moments })
    }

    /// The same, and looks for every moment: one that never comes is an error like any other.
    pub fn check(files: &dyn Files) -> Loaded {
        Self::check_with(files, SceneFormats::standard())
    }

    /// The same, with scenes spelt as these formats have it.
    pub fn check_with(files: &dyn Files, formats: SceneFormats) -> Loaded {
        let moments = Moments::Now;
        load(files, Reading { formats, moments })
    }
}

fn load(files: &dyn Files, reading: Reading) -> Loaded {
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
        let (lesson, problems) = load_lesson(files, reading, id, names);
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
    reading: Reading,
    id: &str,
    names: &BTreeSet<&str>,
) -> (Option<Lesson>, Vec<Problem>) {
    let mut problems = Vec::new();
    let skeleton = lesson_toml(files, reading, id, names, &mut problems);
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
    reading: Reading,
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
            let source = Source::new(files.shown(&path), &bytes).among(files, id);
            let mut sink = Sink::new(&source);
            let skeleton = lesson_file::read(reading, &mut sink);
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
    problem.what.notes = suggestion(meant, &known);
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
