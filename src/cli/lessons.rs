//! The lessons that a command names.

use std::path::{Path, PathBuf};

use crate::{
    lesson::{Course, Embedded, Files, Folder, Lesson, Loaded, Problem, Severity},
    text::{Catalog, Lang, Message},
};

use super::{Outcome, say, say::say_text};

/// The lessons that were asked for, and what is wrong with them.
#[derive(Default)]
pub(super) struct Chosen {
    /// Those in order.
    pub lessons: Vec<Lesson>,
    problems: Vec<Problem>,
    /// Names that are neither a path nor a lesson of the embedded course.
    missing: Vec<String>,
}

/// Each name is a path to a lesson or to a folder of lessons, else a lesson of the embedded course; without
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
        if name.exists() {
            let loaded = Course::check(&Folder::new(name));
            chosen.lessons.extend(loaded.course.lessons);
            chosen.problems.extend(loaded.problems);
            continue;
        }
        let course = course.get_or_insert_with(|| embedded(&Embedded).course);
        match name.to_str().and_then(|id| course.lesson(id)) {
            Some(lesson) => chosen.lessons.push(lesson.clone()),
            None => chosen.missing.push(shown(name)),
        }
    }
    chosen
}

impl Chosen {
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
        for name in &self.missing {
            say(
                lang,
                &Message::new("cli-no-lesson").with("name", name.clone()),
            );
        }
        let nothing_read = |problem: &Problem| {
            problem.place.is_none() && matches!(problem.code(), "no-lessons" | "unreadable")
        };
        match errors.len() + self.missing.len() {
            0 => Outcome::Done,
            _ if self.lessons.is_empty() && errors.iter().all(|p| nothing_read(p)) => {
                Outcome::Unusable
            }
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
