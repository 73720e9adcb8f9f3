//! Where in the course the reader stands.

use crate::{
    lesson::{Course, Lesson, LessonStep},
    text::Lang,
};

/// A course, and an open step of it where it has one.
#[derive(Clone, Debug, Default)]
pub struct Bookmark {
    course: Course,
    lesson_idx: usize,
    step_idx: usize,
}

impl Bookmark {
    /// At the first step of the first lesson.
    #[must_use]
    pub const fn new(course: Course) -> Self {
        Self {
            course,
            lesson_idx: 0,
            step_idx: 0,
        }
    }

    /// Every lesson.
    #[must_use]
    pub fn lessons(&self) -> &[Lesson] {
        &self.course.lessons
    }

    /// The open lesson.
    #[must_use]
    pub fn lesson(&self) -> Option<&Lesson> {
        self.course.lessons.get(self.lesson_idx)
    }

    /// The open step.
    #[must_use]
    pub fn step(&self) -> Option<&LessonStep> {
        self.lesson()?.steps.get(self.step_idx)
    }

    /// The open step's title.
    #[must_use]
    pub fn title(&self, lang: Lang) -> Option<&str> {
        self.lesson()?.step_title(&self.step()?.id, lang)
    }

    /// Indices of the open lesson and step.
    #[must_use]
    pub const fn indices(&self) -> [usize; 2] {
        [self.lesson_idx, self.step_idx]
    }

    /// Ids of the open lesson and step.
    #[must_use]
    pub fn ids(&self) -> Option<(String, String)> {
        Some((self.lesson()?.id.clone(), self.step()?.id.clone()))
    }

    /// Opens a step, where there is one with these indices.
    pub fn open(&mut self, lesson_idx: usize, step_idx: usize) -> bool {
        let steps = self
            .course
            .lessons
            .get(lesson_idx)
            .map_or(0, |lesson| lesson.steps.len());
        let exists = step_idx < steps;
        if exists {
            (self.lesson_idx, self.step_idx) = (lesson_idx, step_idx);
        }
        exists
    }

    /// Opens the step with these ids, else the lesson's first, else nothing else than now.
    pub fn open_ids(&mut self, lesson: &str, step: &str) {
        let found = self.course.lessons.iter().position(|l| l.id == lesson);
        if let Some(lesson_idx) = found {
            let step_idx = self.course.lessons[lesson_idx]
                .step_index(step)
                .unwrap_or(0);
            self.open(lesson_idx, step_idx);
        }
    }

    /// One step on or back, into the neighbouring lesson at an end.
    pub fn go(&mut self, forward: bool) -> bool {
        let [lesson, step] = self.indices();
        if forward {
            return self.open(lesson, step + 1) || self.open(lesson + 1, 0);
        }
        match (step.checked_sub(1), lesson.checked_sub(1)) {
            (Some(before), _) => self.open(lesson, before),
            (None, Some(before)) => {
                let last = self.course.lessons[before].steps.len().saturating_sub(1);
                self.open(before, last)
            }
            (None, None) => false,
        }
    }

    /// Another version of the course (a browser's never changes); the reader stays at the same step where it is still there.
    #[cfg(not(target_arch = "wasm32"))]
    pub fn replace(&mut self, course: Course) {
        let ids = self.ids();
        self.course = course;
        (self.lesson_idx, self.step_idx) = (0, 0);
        if let Some((lesson, step)) = ids {
            self.open_ids(&lesson, &step);
        }
    }
}
