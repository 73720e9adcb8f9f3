//! The lessons and scene files that a command names.

use std::{
    fs,
    path::{Path, PathBuf},
};

use crate::{
    lesson::{
        Course, Embedded, Files, Folder, Lesson, Loaded, Problem, SceneFile, SceneFormats, Severity,
    },
    text::{Catalog, Diagnostic, Lang, Message},
};

use super::{Outcome, say, say::say_text};

/// The lessons that were asked for, and what is wrong with them.
#[derive(Default)]
pub(super) struct Chosen {
    /// Those in order.
    pub lessons: Vec<Lesson>,
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
        chosen.lessons = loaded.course.lessons;
        chosen.problems = loaded.problems;
        return chosen;
    }
    let mut course = None;
    for name in names {
        if name.is_file() {
            chosen.read_scene(name);
            continue;
        }
        if name.exists() {
            let loaded = Course::check(&Folder::new(name));
            chosen.lessons.extend(loaded.course.lessons);
            chosen.problems.extend(loaded.problems);
            continue;
        }
        let course = course.get_or_insert_with(|| embedded(&Embedded).course);
        match name.to_str().and_then(|id| course.lesson(id)) {
            Some(lesson) => chosen.lessons.push(lesson.clone()),
            None => {
                let message = Message::new("cli-no-lesson").with("name", shown(name));
                chosen.unread.push(message);
            }
        }
    }
    chosen
}

impl Chosen {
    /// Is nothing in order?
    pub const fn is_empty(&self) -> bool {
        self.lessons.is_empty() && self.scenes.is_empty()
    }

    fn read_scene(&mut self, path: &Path) {
        let read = fs::read(path).map_err(|error| {
            Message::new("cli-unreadable")
                .with("path", shown(path))
                .with("reason", Diagnostic::from(error))
        });
        let stem = path.file_stem().unwrap_or_default().to_string_lossy();
        match read.map(|bytes| SceneFormats::standard().read(&shown(path), &bytes)) {
            Ok(Ok(scene)) => self.scenes.push((stem.into_owned(), scene)),
            Ok(Err(problems)) => self.problems.extend(problems),
            Err(message) => self.unread.push(message),
        }
    }

    /// Names on standard error whatever is wrong.
    pub fn report(&self, lang: Lang) -> Outcome {
        self.name(lang, |_| true)
    }

    /// Names on standard error which lessons are left out.
    pub fn report_errors(&self, lang: Lang) -> Outcome {
        self.name(lang, is_error)
    }

    fn name(&self, lang: Lang, is_told: fn(&Problem) -> bool) -> Outcome {
        for problem in self.problems.iter().filter(|problem| is_told(problem)) {
            say_text(&problem.render(Catalog::of(lang)));
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

fn is_error(problem: &Problem) -> bool {
    problem.severity == Severity::Error
}

fn shown(path: &Path) -> String {
    path.display().to_string()
}
