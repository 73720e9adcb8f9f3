//! A step's goal, looked at whenever its scene has been run anew.

use crate::{
    labs::{Difference, smaller},
    widgets::TextTold,
};

use super::{App, desk::Page, hint::Help, prelude::*};

#[derive(Default)]
pub struct Goals {
    /// What was looked at last: the page, and its scene's recording.
    seen: Option<(Page, u64)>,
    /// Which parts of the open step's goal hold; none where it has none.
    met: Vec<bool>,
    pub(super) help: Help,
}

impl App {
    /// Which parts of the open step's goal hold.
    pub(super) fn met(&self) -> &[bool] {
        &self.goals.met
    }

    /// What of the open step's text is shown, and how.
    pub(super) fn text_told(&self) -> TextTold<'_> {
        TextTold {
            is_answered: self.shown.is_answered,
            met: self.met(),
            waits: self.practice.asks_for_a_step(),
        }
    }

    pub(super) fn is_reached(&self) -> bool {
        !self.met().is_empty() && self.met().iter().all(|is_met| *is_met)
    }

    /// Makes the scene smaller in which a mistake differs from what is right, as long as it differs in the same kind of event.
    pub(super) fn make_smaller(&mut self, now: f64) {
        let Some(kind) = Difference::kind_in(self.history.now()) else {
            self.tell(&Message::new("smaller-no-difference"), now);
            return;
        };
        let mut holds = |scene: &Scene| Difference::kind_in(scene).as_ref() == Some(&kind);
        match smaller(self.history.now(), &mut holds) {
            Some(found) => self.edit(Edit::Replace(found), None, now),
            None => self.tell(&Message::new("smaller-none"), now),
        }
    }

    /// A goal that is reached stays so, whatever becomes of the scene.
    pub(super) fn look_at_goal(&mut self) {
        let page = self.bookmark.page();
        let was = self.goals.seen.as_ref().map(|(page, _)| page);
        if was == page.as_ref() {
            self.count_end();
        } else {
            self.goals.help = Help::default();
        }
        let seen = page.map(|page| (page, self.playback.recording));
        if self.goals.seen == seen || self.pending.is_some() || self.playback.is_late {
            return;
        }
        let goal = self.bookmark.step().and_then(|step| step.goal.as_ref());
        let met = goal.map(|goal| {
            let scene = self.playback.scene();
            goal.met(scene, &scene.by_method(self.playback.runs()))
        });
        self.goals.met = met.unwrap_or_default();
        if let Some((Page::Step(lesson, step), _)) = seen.as_ref().filter(|_| self.is_reached()) {
            self.is_touched |= self.settings.progress.reach(lesson, step);
        }
        self.goals.seen = seen;
        self.look_for_hint();
        self.count_end();
    }
}
