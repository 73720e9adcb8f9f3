//! Where the reader stands: in the course, or beside it.

use std::collections::BTreeMap;

use super::{
    desk::{Page, Places},
    prelude::*,
};

/// A scene of the reader's own: the one that a lab has without a name, or another.
#[derive(Clone, PartialEq, Debug)]
pub struct FreeScene {
    pub lab: &'static Lab,
    pub name: Option<String>,
}

impl FreeScene {
    pub const fn of(lab: &'static Lab) -> Self {
        Self { lab, name: None }
    }

    pub fn page(&self) -> Page {
        let lab = self.lab.id.to_owned();
        match &self.name {
            None => Page::Free(lab),
            Some(name) => Page::Named(lab, name.clone()),
        }
    }
}

/// A course, and an open step of it where it has one; or the free scene of a lab, and the step to come back to.
#[derive(Default)]
pub struct Bookmark {
    pub course: Course,
    /// The indices of lesson and step.
    pub at: [usize; 2],
    pub free: Option<FreeScene>,
}

impl Bookmark {
    /// In a course where its reader was last, as far as that is still there; else at its first step.
    pub fn restored(
        course: Course,
        places: &Places,
        lab_of: impl Fn(&str) -> Option<&'static Lab>,
    ) -> Self {
        let mut bookmark = Self {
            course,
            ..Self::default()
        };
        // A free scene lies beside the step that was open: so far none is.
        let step = match &places.page {
            Some(Page::Free(lab) | Page::Named(lab, _)) => places.steps.get(lab),
            Some(Page::Step(..)) | None => None,
        };
        for page in step.into_iter().chain(&places.page) {
            bookmark.open_page(page, &lab_of, &places.steps);
        }
        bookmark
    }

    pub fn page(&self) -> Option<Page> {
        match &self.free {
            Some(free) => Some(free.page()),
            None => self.page_of(self.at),
        }
    }

    pub fn page_of(&self, [lesson_idx, step_idx]: [usize; 2]) -> Option<Page> {
        let lesson = self.course.lessons.get(lesson_idx)?;
        let step = lesson.steps.get(step_idx)?;
        Some(Page::Step(lesson.id.clone(), step.id.clone()))
    }

    pub fn step_of(&self, lesson: &str, step: &str) -> Option<&LessonStep> {
        let lesson = self.course.lesson(lesson)?;
        lesson.steps.get(lesson.step_index(step)?)
    }

    /// The open lesson, or the one to come back to.
    pub fn lesson(&self) -> Option<&Lesson> {
        self.course.lessons.get(self.at[0])
    }

    /// The open step; none in a free scene.
    pub fn step(&self) -> Option<&LessonStep> {
        match &self.free {
            Some(_) => None,
            None => self.lesson()?.steps.get(self.at[1]),
        }
    }

    /// The rectangle of the plane that a scene shows at first: with the others of the open lesson, if it is one of theirs.
    pub fn bounds_of(&self, scene: &Scene) -> [[f64; 2]; 2] {
        let lesson = self.step().and(self.lesson());
        lesson.map_or_else(
            || scene.document().frame(),
            |lesson| lesson.bounds_of(scene),
        )
    }

    /// The step's title; once its answer is open, or where it asks nothing, what it shows.
    pub fn title(&self, lang: Lang, is_open: bool) -> Option<&str> {
        self.step()?;
        self.lesson()?.step_heading(self.at[1], lang, is_open)
    }

    /// Opens a step, where there is one with these indices.
    pub fn open(&mut self, at: [usize; 2]) -> bool {
        let exists = self.page_of(at).is_some();
        if exists {
            (self.at, self.free) = (at, None);
        }
        exists
    }

    /// Opens the step with these ids, else the lesson's first, else nothing else than now.
    pub fn open_ids(&mut self, lesson: &str, step: &str) -> bool {
        let found = self.course.lesson_index(lesson);
        found.is_some_and(|lesson_idx| {
            let step_idx = self.course.lessons[lesson_idx].step_index(step);
            self.open([lesson_idx, step_idx.unwrap_or(0)])
        })
    }

    /// Opens the first lesson of the lab with this id, where there is one.
    pub fn open_lab(&mut self, id: &str) -> bool {
        let found = self.course.lessons.iter().position(|l| l.lab == id);
        found.is_some_and(|lesson_idx| self.open([lesson_idx, 0]))
    }

    /// Opens a free scene of a lab: beside the open step where that is of the same lab, else beside the step of its own that
    /// was open `last`, or its first.
    pub fn open_free(&mut self, free: FreeScene, last: Option<&Page>) -> bool {
        let lab = free.lab;
        let is_of_lab = |bookmark: &Self| bookmark.lesson().is_some_and(|it| it.lab == lab.id);
        if !is_of_lab(self) {
            if let Some(Page::Step(lesson, step)) = last {
                self.open_ids(lesson, step);
            }
            if !is_of_lab(self) {
                self.open_lab(lab.id);
            }
        }
        self.free = Some(free);
        true
    }

    /// Opens a page, where it is still there; `lab_of` knows the labs by their ids.
    pub fn open_page(
        &mut self,
        page: &Page,
        lab_of: impl FnOnce(&str) -> Option<&'static Lab>,
        steps: &BTreeMap<String, Page>,
    ) -> bool {
        let (id, name) = match page {
            Page::Step(lesson, step) => return self.open_ids(lesson, step),
            Page::Free(id) => (id, None),
            Page::Named(id, name) => (id, Some(name.clone())),
        };
        lab_of(id).is_some_and(|lab| self.open_free(FreeScene { lab, name }, steps.get(lab.id)))
    }

    /// The title of the step after the open one.
    pub fn next_title(&self, lang: Lang) -> Option<&str> {
        let [lesson_idx, step_idx] = self.next()?;
        self.course.lessons[lesson_idx].step_title(step_idx, lang)
    }

    /// The step after the open one, in the next lesson at the end of its own.
    fn next(&self) -> Option<[usize; 2]> {
        let [lesson, step] = self.at;
        let mut next = [[lesson, step + 1], [lesson + 1, 0]].into_iter();
        next.find(|&at| self.page_of(at).is_some())
    }

    /// One step on or back, into the neighbouring lesson at an end.
    pub fn go(&mut self, forward: bool) -> bool {
        let [lesson, step] = self.at;
        if forward {
            return self.next().is_some_and(|at| self.open(at));
        }
        match (step.checked_sub(1), lesson.checked_sub(1)) {
            (Some(before), _) => self.open([lesson, before]),
            (None, Some(before)) => {
                let last = self.course.lessons[before].steps.len().saturating_sub(1);
                self.open([before, last])
            }
            (None, None) => false,
        }
    }

    /// Another version of the course; the reader stays at the same step where it is still there.
    pub fn replace(&mut self, course: Course) {
        let page = self.page_of(self.at);
        let free = self.free.take();
        (self.course, self.at) = (course, [0, 0]);
        if let Some(Page::Step(lesson, step)) = page {
            self.open_ids(&lesson, &step);
        }
        self.free = free;
    }
}
