//! Messages over the stage: what went right for a moment, what went wrong until it is dismissed.

use crate::text::Message;

use super::App;

/// How long good news stays, in seconds.
const PASSING_SECS: f64 = 5.0;
/// More are dropped, the oldest first.
const MAX_NOTICES: usize = 4;

pub struct Notice {
    pub text: String,
    /// Does it tell of a problem, with lines of a file in it?
    pub is_problem: bool,
    /// When it goes away by itself, in seconds.
    pub until: Option<f64>,
}

impl App {
    pub(super) fn notify(&mut self, notice: Notice) {
        self.notices.retain(|old| old.text != notice.text);
        self.notices.push(notice);
        let surplus = self.notices.len().saturating_sub(MAX_NOTICES);
        self.notices.drain(..surplus);
    }

    /// Says to someone new what to press first, and that things can be dragged, until they do.
    pub(super) fn greet(&mut self) {
        if !self.settings.is_greeted {
            self.notify(Notice {
                text: self.catalog().term("greeting"),
                is_problem: false,
                until: None,
            });
        }
    }

    /// Someone has done one of that.
    pub(super) fn greeted(&mut self) {
        if !std::mem::replace(&mut self.settings.is_greeted, true) {
            let is_greeting = |notice: &Notice| !notice.is_problem && notice.until.is_none();
            self.notices.retain(|notice| !is_greeting(notice));
        }
    }

    /// Says it until it is dismissed.
    pub(super) fn complain(&mut self, text: String) {
        self.notify(Notice {
            text,
            is_problem: true,
            until: None,
        });
    }

    /// Says it for a moment.
    pub(super) fn tell(&mut self, message: &Message, now: f64) {
        self.notify(Notice {
            text: self.catalog().message(message),
            is_problem: false,
            until: Some(now + PASSING_SECS),
        });
    }

    /// Takes away what has been seen; seconds until the next one goes.
    pub(super) fn expire_notices(&mut self, now: f64) -> Option<f32> {
        let is_shown = |notice: &Notice| notice.until.is_none_or(|until| until > now);
        self.notices.retain(is_shown);
        let ends = self.notices.iter().filter_map(|notice| notice.until);
        ends.reduce(f64::min).map(|until| (until - now) as f32)
    }
}
