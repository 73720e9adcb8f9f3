//! A lesson of one's own: from a scene, from another lesson, or one that lies in a folder; and how it is tried and left.

use std::collections::BTreeMap;

use crate::lesson::{Draft, Files, Progress};

use super::{
    super::{App, desk::Work, history::History, practice::Practice, prelude::*},
    Compose, Version,
};

impl App {
    /// Where the open course lies, if it is a folder's.
    #[cfg(not(target_arch = "wasm32"))]
    pub(super) fn own_files(&self) -> Option<Box<dyn Files>> {
        let reload = self.reload.as_ref()?;
        Some(Box::new(reload.folder().clone()))
    }

    #[cfg(target_arch = "wasm32")]
    pub(super) fn own_files(&self) -> Option<Box<dyn Files>> {
        None
    }

    /// Can the open lesson be made in the window?
    pub(in super::super) fn can_compose(&self) -> bool {
        self.own_files().is_some() && self.bookmark.step().is_some()
    }

    pub(super) fn begin_composing(&mut self, now: f64) {
        let Some((files, lesson)) = self
            .own_files()
            .zip(self.bookmark.step().and(self.bookmark.lesson()))
        else {
            self.tell(&Message::new("compose-own-only"), now);
            return;
        };
        let id = lesson.id.clone();
        let steps: Vec<String> = lesson.steps.iter().map(|step| step.id.clone()).collect();
        let on_disk = match Draft::read(&*files, &id) {
            Ok(draft) => draft,
            Err(reason) => {
                self.report_unread(&files.shown(&id), reason.into());
                return;
            }
        };
        // Steps in one list get lines of their own with the first change.
        let draft = on_disk.in_tables().unwrap_or_else(|| on_disk.clone());
        if draft.ids() != steps {
            // Changed in this moment, say.
            self.tell(&Message::new("compose-form"), now);
            return;
        }
        let speaks = draft.speaks(self.settings.lang);
        let open = self.open_id();
        let (page, is_changed) = (self.bookmark.page(), self.is_the_readers());
        self.notices.clear();
        self.practice = Practice::default();
        self.compose = Some(Box::new(Compose {
            lesson: id,
            files,
            on_disk,
            history: History::new(Version {
                draft,
                step: open.clone(),
            }),
            theirs: None,
            problems: Vec::new(),
            due: None,
            lang: if speaks { self.settings.lang } else { Lang::En },
            taken: None,
            left: None,
            rows: (None, BTreeMap::new()),
            stands: BTreeMap::new(),
            offered: (None, Vec::new()),
            works: BTreeMap::new(),
            tried: None,
        }));
        // What was done on its pages before is there again afterwards.
        let mut works = self.clear_composed_works();
        let before = self.enter();
        let before = page.zip(before).filter(|_| is_changed);
        works.extend(before.map(|(page, work)| (page, Work { is_changed, ..work })));
        if let Some(compose) = &mut self.compose {
            compose.works = works;
        }
        self.check_composed();
    }

    /// Writes what is left to be written, and shows the lesson as a student sees it.
    pub(in super::super) fn end_composing(&mut self, now: f64) {
        self.stop_trying();
        self.check_composed();
        self.write_composed(false);
        if self
            .compose
            .as_ref()
            .is_some_and(|compose| compose.theirs.is_some())
        {
            self.tell(&Message::new("compose-settle-first"), now);
            return;
        }
        let is_open = self.has_composed_open();
        self.leave_composed();
        if is_open {
            self.enter();
        }
        #[cfg(not(target_arch = "wasm32"))]
        self.read_course_again(now);
    }

    /// Nothing is made any more: what is left to be written is written.
    pub(in super::super) fn leave_composed(&mut self) {
        self.stop_trying();
        self.write_composed(true);
        self.clear_composed_works();
        let works = self.compose.take().map(|compose| compose.works);
        self.desk.works.extend(works.into_iter().flatten());
    }

    pub(super) fn try_lesson(&mut self) {
        if self.stop_trying() {
            return;
        }
        self.check_composed();
        if self.composed().is_none() {
            return;
        }
        let marks = std::mem::take(&mut self.settings.progress);
        if let Some(compose) = &mut self.compose {
            compose.tried = Some(marks);
        }
        self.clear_composed_works();
        self.enter();
    }

    /// Was it tried?
    fn stop_trying(&mut self) -> bool {
        let marks: Option<Progress> = self
            .compose
            .as_mut()
            .and_then(|compose| compose.tried.take());
        let Some(marks) = marks else {
            return false;
        };
        self.settings.progress = marks;
        self.practice = Practice::default();
        if self.has_composed_open() {
            let open = self.open_id();
            self.open_composed(&open);
        }
        true
    }

    #[cfg(target_arch = "wasm32")]
    pub(in super::super) fn save_lesson(
        &mut self,
        _: super::super::dialog::Target,
        _: &Context,
        _: f64,
    ) {
    }
}
