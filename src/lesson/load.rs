//! From files to a course, and to what is wrong with them.

use std::collections::{BTreeMap, BTreeSet};

use super::{
    course::{Course, Lesson},
    files::{Embedded, Files, LESSON_FILE, MAX_LESSONS},
    lesson_file::{self, Body, Moments, Reading, Skeleton},
    prelude::*,
    reference::{Runs, WrittenText},
    scene_file::SceneFormats,
    sections,
    translated::{self, TRANSLATED_FILE},
    translation::Translation,
};

#[derive(Clone, PartialEq, Debug, Default)]
pub struct Loaded {
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
    /// needed: `LessonStep::position`.
    pub fn load(files: &dyn Files) -> Loaded {
        let formats = SceneFormats::standard();
        let moments = Moments::Later;
        load(files, Reading { formats, moments })
    }

    /// The same, and looks for every moment: one that never comes is an error like any other.
    pub fn check(files: &dyn Files) -> Loaded {
        Self::check_with(files, SceneFormats::standard())
    }

    pub fn check_with(files: &dyn Files, formats: SceneFormats) -> Loaded {
        let moments = Moments::Now;
        load(files, Reading { formats, moments })
    }
}

fn load(files: &dyn Files, reading: Reading) -> Loaded {
    let mut loaded = Loaded::default();
    let problems = &mut loaded.problems;
    let paths = match files.list() {
        Ok(paths) => paths,
        Err(error) => {
            problems.push(whole_file(files.shown(""), error));
            return loaded;
        }
    };
    let folders = folders(&paths);
    if folders.is_empty() {
        let message = Message::new("problem-no-lessons");
        problems.push(no_lesson(files.shown(""), message));
    }
    for (id, names) in folders.iter().take(MAX_LESSONS) {
        let lesson = load_lesson(files, reading, id, names, problems);
        loaded.course.lessons.extend(lesson);
    }
    if folders.len() > MAX_LESSONS {
        let message = Message::new("problem-too-many-lessons").with("limit", MAX_LESSONS);
        problems.push(whole_file(files.shown(""), message));
    }
    loaded
}

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
    all_problems: &mut Vec<Problem>,
) -> Option<Lesson> {
    let mut problems = Vec::new();
    let mut skeleton = lesson_toml(files, reading, id, names, &mut problems);
    let controls = skeleton.as_mut().and_then(|it| it.controls.take());
    let body = skeleton.as_ref().and_then(|it| it.body.as_ref());
    let body = body.filter(|_| reading.moments == Moments::Now);
    let runs = body.map(|body| Runs::new(&body.scenes));
    let texts = Texts {
        files,
        // What is checked is read now.
        later: files
            .compiled_in()
            .filter(|_| reading.moments == Moments::Later),
        id,
        ids: skeleton.as_ref().and_then(|it| it.ids.as_deref()),
        controls: controls.as_deref(),
        checked: body.zip(runs.as_ref()),
        // A course is looked at with it where it is checked.
        translated: body.and_then(|_| translated(files, id, names)),
    };
    let (mut english, mut translations) = (None, BTreeMap::new());
    for name in names.iter().filter(|name| is_text(name)) {
        let stem = name.trim_end_matches(".md");
        let Some(lang) = Lang::ALL.into_iter().find(|lang| lang.id() == stem) else {
            problems.push(unknown_language(files.shown(&format!("{id}/{name}")), stem));
            continue;
        };
        if lang == Lang::En {
            english = texts.read(lang, &mut problems);
        } else {
            let text = texts.later(lang);
            let text = text.or_else(|| texts.read(lang, &mut problems).map(Translation::from));
            translations.extend(text.map(|text| (lang, text)));
        }
    }
    if let Some(skeleton) = &mut skeleton {
        let speaks_of = |name: &str| english.as_ref().is_some_and(|text| text.speaks_of(name));
        let unused = std::mem::take(&mut skeleton.unshown).into_iter();
        let unused = unused.filter(|(name, _)| !speaks_of(name));
        problems.extend(unused.map(|(_, problem)| problem));
    }
    for lang in Lang::ALL {
        let name = format!("{lang}.md");
        if !names.contains(&*name) {
            problems.push(missing_text(files.shown(&format!("{id}/{name}")), lang));
        }
    }
    let is_broken = problems.iter().any(|p| p.severity == Severity::Error);
    all_problems.extend(problems);
    skeleton
        .filter(|_| !is_broken)?
        .into_lesson(id, english?, translations)
}

/// The texts of a lesson, and what they are read with.
struct Texts<'a> {
    files: &'a dyn Files,
    /// Where texts can be read later, too.
    later: Option<Embedded>,
    id: &'a str,
    ids: Option<&'a [String]>,
    controls: Option<&'a [&'static str]>,
    checked: Option<(&'a Body, &'a Runs<'a>)>,
    translated: Option<(Vec<u8>, String)>,
}

impl Texts<'_> {
    fn path(&self, lang: Lang) -> String {
        format!("{}/{lang}.md", self.id)
    }

    fn read(&self, lang: Lang, problems: &mut Vec<Problem>) -> Option<WrittenText> {
        read(self.files, &self.path(lang), None, problems, |sink| {
            let text = sections::read(self.ids, self.controls, sink)?;
            if let Some((body, runs)) = self.checked {
                for (written, step) in text.steps.iter().zip(&body.steps) {
                    written.check(step, runs, sink);
                }
            }
            let translated = self.translated.as_ref().filter(|_| lang != Lang::En);
            if let Some((known, english)) = translated {
                translated::stale(known, english, lang, sink);
            }
            (sink.n_errors() == 0).then_some(text)
        })
    }

    /// What is compiled in has no mistakes to be told, as a test makes sure: so it need not be read at once.
    fn later(&self, lang: Lang) -> Option<Translation> {
        let files = self.later?;
        let (path, ids) = (self.path(lang), self.ids?.to_vec());
        let controls = self.controls.map(<[_]>::to_vec);
        Some(Translation::later(move || {
            read(&files, &path, None, &mut Vec::new(), |sink| {
                sections::read(Some(&ids), controls.as_deref(), sink)
            })
        }))
    }
}

/// What a lesson keeps of its English when it was translated, and that English as it is now.
fn translated(files: &dyn Files, id: &str, names: &BTreeSet<&str>) -> Option<(Vec<u8>, String)> {
    let read = |name| files.read(&format!("{id}/{name}")).ok();
    let kept = names.contains(TRANSLATED_FILE).then_some(TRANSLATED_FILE)?;
    Some((read(kept)?, String::from_utf8(read("en.md")?).ok()?))
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
        problems.push(no_lesson(files.shown(&path), message));
        return None;
    }
    read(files, &path, Some(id), problems, |sink| {
        lesson_file::read(reading, sink)
    })
}

/// What `read` makes of a file, which may name others in its folder.
fn read<T>(
    files: &dyn Files,
    path: &str,
    folder: Option<&str>,
    problems: &mut Vec<Problem>,
    read: impl FnOnce(&Sink<'_>) -> Option<T>,
) -> Option<T> {
    let shown = files.shown(path);
    let bytes = match files.read(path) {
        Ok(bytes) => bytes,
        Err(error) => {
            problems.push(whole_file(shown, error));
            return None;
        }
    };
    let mut source = Source::new(shown, &bytes);
    source.folder = folder.map(|folder| (files, folder));
    let sink = Sink::new(&source);
    let made = read(&sink);
    problems.extend(sink.into_problems());
    made
}

/// A language's text; a folder may have a README of its own.
fn is_text(name: &str) -> bool {
    !name.contains('/') && name != "README.md" && name.strip_suffix(".md").is_some()
}

fn whole_file(file: String, what: impl Into<Diagnostic>) -> Problem {
    Problem {
        file,
        place: None,
        severity: Severity::Error,
        what: what.into(),
    }
}

fn no_lesson(file: String, message: Message) -> Problem {
    let expected = Message::new("expect-lesson-folder");
    whole_file(file, Diagnostic::new(message).noting(expected))
}

fn unknown_language(file: String, stem: &str) -> Problem {
    let message = Message::new("problem-unknown-language").with("name", stem.to_owned());
    let meant = Lang::from_locale(stem).map(Lang::id);
    let mut problem = whole_file(file, message);
    problem.what.notes = suggestion(meant, &Lang::ALL.map(Lang::id));
    problem
}

fn missing_text(file: String, lang: Lang) -> Problem {
    if lang == Lang::En {
        return no_lesson(file, Message::new("problem-missing-file"));
    }
    let message = Message::new("problem-missing-language");
    let message = message.with("language", lang.native_name().to_owned());
    Problem {
        severity: Severity::Warning,
        ..whole_file(file, message)
    }
}
