//! The course as the app, export and the command line use it.

use std::collections::BTreeMap;

use crate::text::Catalog;

use super::{
    card::Card,
    markdown::StepText,
    prelude::*,
    reference::{Runs, Scenes, WrittenText},
    step::LessonStep,
    translation::Translation,
};

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
    /// By name: those of its steps, and those that only its text speaks of.
    pub(super) scenes: Scenes,
    pub(super) english: WrittenText,
    pub(super) translations: BTreeMap<Lang, Translation>,
}

impl Lesson {
    pub fn title(&self, lang: Lang) -> &str {
        &self.written(lang).0.title
    }

    /// A step's text in this language, or in English where there is none, with the numbers of its runs. These are recorded when
    /// the text is first asked for.
    pub fn step_text(&self, step_idx: usize, lang: Lang) -> Option<&StepText> {
        let (text, lang) = self.written(lang);
        let written = text.steps.get(step_idx)?;
        Some(written.filled(self.steps.get(step_idx)?, &self.scenes, lang))
    }

    pub fn step_title(&self, step_idx: usize, lang: Lang) -> Option<&str> {
        let (text, lang) = self.written(lang);
        let written = text.steps.get(step_idx)?;
        Some(written.title(self.steps.get(step_idx)?, &self.scenes, lang))
    }

    /// What a step shows, in a sentence; its title where no claim is written.
    pub fn step_claim(&self, step_idx: usize, lang: Lang) -> Option<&str> {
        let (text, lang) = self.written(lang);
        let written = text.steps.get(step_idx)?;
        Some(written.claim(self.steps.get(step_idx)?, &self.scenes, lang))
    }

    /// What stands over how it was and how it is, where that is written.
    pub fn step_sides(&self, step: &LessonStep, lang: Lang) -> Option<&[String; 2]> {
        let text = self.step_text(self.step_index(&step.id)?, lang)?;
        text.sides.as_ref()
    }

    /// What stands over a step: what it shows, once that may be told, else its title.
    pub fn step_heading(&self, step_idx: usize, lang: Lang, is_told: bool) -> Option<&str> {
        if is_told {
            self.step_claim(step_idx, lang)
        } else {
            self.step_title(step_idx, lang)
        }
    }

    /// What is to be kept of the lesson, at its end.
    pub fn card(&self, lang: Lang) -> Option<&Card> {
        self.written(lang).0.card.as_ref()
    }

    /// The text in this language, or in English where there is none, as it was written.
    fn written(&self, lang: Lang) -> (&WrittenText, Lang) {
        let own = self.translations.get(&lang).and_then(Translation::text);
        own.map_or((&self.english, Lang::En), |text| (text, lang))
    }

    /// The text of its file in a language, with what a reader sees in place of each reference.
    pub fn filled(&self, source: &str, lang: Lang) -> String {
        let runs = Runs::new(&self.scenes);
        let (text, lang) = self.written(lang);
        let steps = text.steps.iter().zip(&self.steps);
        let said = steps.flat_map(|(written, step)| written.said(step, &runs, lang));
        let mut said: Vec<_> = said.collect();
        said.sort_by_key(|(span, _)| span.start);
        let mut filled = source.to_owned();
        for (span, value) in said.into_iter().rev() {
            filled.replace_range(span, &value);
        }
        filled
    }

    /// What the text of a step can name: each name with what stands for it there.
    pub fn names(&self, step: &LessonStep, catalog: &Catalog) -> Vec<(String, String)> {
        Runs::new(&self.scenes).names(step, catalog)
    }

    pub fn speaks(&self, lang: Lang) -> bool {
        lang == Lang::En || self.translations.contains_key(&lang)
    }

    pub fn step_index(&self, id: &str) -> Option<usize> {
        let now = self.steps.iter().position(|step| step.id == id);
        let was = |step: &LessonStep| step.was.as_deref() == Some(id);
        now.or_else(|| self.steps.iter().position(was))
    }
}

impl Course {
    /// The number of a lesson: that of its folder, where its name begins with one, else its place.
    pub fn number(&self, lesson_idx: usize) -> usize {
        let id = self.lessons.get(lesson_idx).map(|lesson| &*lesson.id);
        let named = id.and_then(|id| id.split('-').next()?.parse().ok());
        named.unwrap_or(lesson_idx + 1)
    }

    pub fn lesson(&self, id: &str) -> Option<&Lesson> {
        self.lessons.get(self.lesson_index(id)?)
    }

    /// A lesson goes by its name: one that has moved in the course is found by the number that it had, too.
    pub fn lesson_index(&self, id: &str) -> Option<usize> {
        let mut lessons = self.lessons.iter();
        let same = lessons.clone().position(|lesson| lesson.id == id);
        same.or_else(|| lessons.position(|lesson| name_of(&lesson.id) == name_of(id)))
    }
}

/// `windows` for `01-windows`.
fn name_of(id: &str) -> &str {
    match id.split_once('-') {
        Some((number, name)) if number.parse::<usize>().is_ok() => name,
        _ => id,
    }
}
