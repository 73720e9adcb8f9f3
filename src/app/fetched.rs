//! What a page fetches when it is first needed; on a desktop all of it is there.

use crate::{
    lesson::{has_stand_in, without_stand_in},
    text::Part,
};

use super::{App, notice::Notice, prelude::*};

impl App {
    /// Speaks another language, as soon as its texts are there.
    pub(super) fn speak(&mut self, lang: Lang) {
        let part = Part::Texts(lang);
        if !part.is_here() {
            self.shown.awaited = Some(lang);
            self.fetch(part);
            return;
        }
        self.shown.awaited = None;
        self.settings.lang = lang;
        if self.notices.iter().any(Notice::is_greeting) {
            self.notices.retain(|notice| !notice.is_greeting());
            self.greet();
        }
        if self.settings.folder.is_none() && !self.speaks(lang) {
            self.bookmark.replace(Course::embedded());
        }
        self.keep_room();
    }

    fn speaks(&self, lang: Lang) -> bool {
        let mut lessons = self.bookmark.course.lessons.iter();
        lessons.all(|lesson| lesson.speaks(lang))
    }

    /// Has it fetched, and says so until it is there.
    fn fetch(&mut self, part: Part) {
        if self.platform.fetch(part) {
            let text = self.coming(part, "status-coming");
            self.notify(Notice {
                text,
                is_problem: false,
                until: None,
            });
        }
    }

    fn coming(&self, part: Part, key: &'static str) -> String {
        let what = match part {
            Part::Texts(lang) => lang.native_name().to_owned(),
            Part::Spot => self.look().say("solid-spot"),
        };
        self.catalog()
            .message(&Message::new(key).with("what", what))
    }

    /// Takes up what has come since.
    pub(super) fn pass_fetched(&mut self) {
        for (part, has_come) in self.platform.fetched() {
            let coming = self.coming(part, "status-coming");
            self.notices.retain(|notice| notice.text != coming);
            if !has_come {
                self.lose(part);
            }
        }
        let awaited = self.shown.awaited;
        if let Some(lang) = awaited.filter(|&lang| Part::Texts(lang).is_here()) {
            self.speak(lang);
        }
        if !has_stand_in(self.history.now()) {
            return;
        }
        if Part::Spot.is_here() {
            self.exchange_stand_in();
        } else if !self.shown.has_lost {
            self.fetch(Part::Spot);
        }
    }

    /// It did not come: what nobody waits for is not missed.
    fn lose(&mut self, part: Part) {
        let is_missed = match part {
            Part::Texts(lang) => self.shown.awaited.take_if(|it| *it == lang).is_some(),
            Part::Spot => has_stand_in(self.history.now()),
        };
        if is_missed {
            self.shown.has_lost |= part == Part::Spot;
            self.complain(self.coming(part, "status-not-come"));
        }
    }

    fn exchange_stand_in(&mut self) {
        let was_untouched = self.is_untouched();
        if self.settings.folder.is_none() {
            self.bookmark.replace(Course::embedded());
        }
        let formats = self.kit.formats;
        (self.history).exchange(|scene| without_stand_in(scene, formats));
        self.album = None;
        if was_untouched {
            self.enter();
        } else {
            self.rerecord();
            self.fit();
        }
    }
}
