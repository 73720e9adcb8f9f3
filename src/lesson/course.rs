//! The course as the app, export and the command line use it.

use std::collections::BTreeMap;

use crate::text::Lang;

use super::{markdown::Block, step::LessonStep};

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
    /// The id of the lab where its scenes live.
    pub lab: &'static str,
    /// Author and year of what it teaches.
    pub source: String,
    /// At least one.
    pub steps: Vec<LessonStep>,
    pub(super) english: LessonText,
    pub(super) translations: BTreeMap<Lang, LessonText>,
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

impl Lesson {
    /// The text in this language, or in English where there is none.
    pub fn text(&self, lang: Lang) -> &LessonText {
        self.translations.get(&lang).unwrap_or(&self.english)
    }

    /// Is there a text in this language?
    pub fn speaks(&self, lang: Lang) -> bool {
        lang == Lang::En || self.translations.contains_key(&lang)
    }

    /// The index of the step with this id.
    pub fn step_index(&self, id: &str) -> Option<usize> {
        self.steps.iter().position(|step| step.id == id)
    }

    /// The title of the step with this id, in this language or in English.
    pub fn step_title(&self, id: &str, lang: Lang) -> Option<&str> {
        let step = self.text(lang).steps.get(self.step_index(id)?)?;
        Some(&step.title)
    }
}

impl Course {
    /// The lesson in the folder of this name.
    pub fn lesson(&self, id: &str) -> Option<&Lesson> {
        self.lessons.iter().find(|lesson| lesson.id == id)
    }
}
