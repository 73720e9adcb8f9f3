//! The course as the app, export and the command line use it.

use std::collections::BTreeMap;

use super::{markdown::Block, prelude::*, step::LessonStep};

/// Lessons in the order of their folders' names.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Course {
    /// Each valid; broken ones have been left out.
    pub lessons: Vec<Lesson>,
}

/// One lesson: at least one step, and a text for each in English.
#[derive(Clone, PartialEq, Debug)]
pub struct Lesson {
    /// Its folder's name: `01-windows`.
    pub id: String,
    pub lab: &'static str,
    /// Author and year of what it teaches.
    pub source: String,
    pub steps: Vec<LessonStep>,
    pub(super) english: LessonText,
    pub(super) translations: BTreeMap<Lang, LessonText>,
}

#[derive(Clone, PartialEq, Debug)]
pub struct LessonText {
    pub title: String,
    /// One for each step, in their order.
    pub steps: Vec<StepText>,
}

#[derive(Clone, PartialEq, Debug)]
pub struct StepText {
    pub title: String,
    pub body: Vec<Block>,
}

impl Lesson {
    /// The text in this language, or in English where there is none.
    pub fn text(&self, lang: Lang) -> &LessonText {
        self.translations.get(&lang).unwrap_or(&self.english)
    }

    pub fn speaks(&self, lang: Lang) -> bool {
        lang == Lang::En || self.translations.contains_key(&lang)
    }

    pub fn step_index(&self, id: &str) -> Option<usize> {
        self.steps.iter().position(|step| step.id == id)
    }

    pub fn step_title(&self, id: &str, lang: Lang) -> Option<&str> {
        let step = self.text(lang).steps.get(self.step_index(id)?)?;
        Some(&step.title)
    }
}

impl Course {
    pub fn lesson(&self, id: &str) -> Option<&Lesson> {
        self.lessons.iter().find(|lesson| lesson.id == id)
    }
}
