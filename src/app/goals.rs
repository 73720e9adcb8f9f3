//! A step's goal, looked at whenever its scene has been run anew.

use std::sync::{
    Arc,
    atomic::{AtomicBool, Ordering},
};

use web_time::Duration;

use crate::{
    labs::{Difference, Lock, listed, moved, smaller},
    lesson::Goal,
    widgets::TextTold,
};

use super::{App, desk::Page, errand::Errand, hint::Help, prelude::*};

/// What is found within this time is on the stage in the same frame.
const AT_ONCE: Duration = Duration::from_millis(16);

/// A scene that is smaller than this one is looked for.
struct Search {
    found: Errand<Option<Scene>>,
    is_stopped: Arc<AtomicBool>,
    than: Scene,
}

#[derive(Default)]
pub struct Goals {
    /// What was looked at last: the page, and its scene's recording.
    seen: Option<(Page, u64)>,
    /// Which parts of the open step's goal hold; none where it has none.
    met: Vec<bool>,
    pub(super) help: Help,
    search: Option<Search>,
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
    /// What was found when that is stopped stays.
    pub(super) fn make_smaller(&mut self, ctx: &Context, now: f64) {
        if self.goals.search.is_some() {
            return;
        }
        if self.is_hunting() {
            self.tell(&Message::new("smaller-not-yet"), now);
            return;
        }
        let Some(kind) = Difference::kind_in(self.history.now()) else {
            self.tell(&Message::new("smaller-no-difference"), now);
            return;
        };
        // What has been reached stays so.
        let goal = self.bookmark.step().and_then(|step| step.goal.clone());
        let goal = goal.filter(|_| self.is_reached());
        // What the step locks stays where it is.
        let locks = self.locks(&self.scene().document().handles()).to_vec();
        let is_free = move |handle| !Lock::any_holds(&locks, handle);
        let is_stopped = Arc::new(AtomicBool::new(false));
        let (first, stop) = (self.history.now().clone(), is_stopped.clone());
        let look = move || {
            let mut holds = |scene: &Scene| {
                let is_asked = !stop.load(Ordering::Relaxed);
                let is_met = |goal: &Goal| goal.met_by(scene).into_iter().all(|is_met| is_met);
                is_asked
                    && Difference::kind_in(scene).as_ref() == Some(&kind)
                    && goal.as_ref().is_none_or(is_met)
            };
            smaller(&first, &is_free, &mut holds)
        };
        self.goals.search = Some(Search {
            found: Errand::start(ctx, look),
            is_stopped,
            than: self.history.now().clone(),
        });
        self.take_smaller(AT_ONCE, now);
        if self.is_making_smaller() {
            self.tell(&Message::new("smaller-search"), now);
        }
    }

    /// Is a smaller scene being looked for?
    pub const fn is_making_smaller(&self) -> bool {
        self.goals.search.is_some()
    }

    /// Looks no further; whether it has looked.
    pub(super) fn stop_search(&self) -> bool {
        let search = self.goals.search.as_ref();
        search.is_some_and(|search| !search.is_stopped.swap(true, Ordering::Relaxed))
    }

    /// Shows the smaller scene once it is found, unless the scene is another by then.
    pub(super) fn take_smaller(&mut self, within: Duration, now: f64) {
        let Some(search) = &mut self.goals.search else {
            return;
        };
        let is_of_now = search.than == *self.history.now();
        if !is_of_now {
            search.is_stopped.store(true, Ordering::Relaxed);
        }
        let Some(found) = search.found.answer(within).transpose() else {
            return;
        };
        self.goals.search = None;
        match found {
            _ if !is_of_now => {}
            Ok(Some(found)) => {
                let what = told_of_smaller(self.history.now(), &found);
                self.edit(Edit::Reduce(found), None, now);
                self.tell(&what, now);
            }
            Ok(None) | Err(_) => self.tell(&Message::new("smaller-none"), now),
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

/// What has become smaller: the number of vertices, else numbers that are rounder.
fn told_of_smaller(before: &Scene, after: &Scene) -> Message {
    let n_vertices = |scene: &Scene| {
        let handles = scene.document().handles().into_iter();
        Value::Count(handles.filter(|handle| handle.kind().is_vertex).count())
    };
    let [n_before, n_after] = [before, after].map(n_vertices);
    if n_before == n_after {
        let handles = moved(before, after);
        // Of a number that no handle has nothing moves.
        if handles.is_empty() {
            return Message::new("smaller-rounder-only");
        }
        let rounder = Message::new("smaller-rounder");
        return rounder.with("handles", listed(after, &handles));
    }
    let fewer = Message::new("smaller-fewer").with("before", n_before);
    fewer.with("after", n_after)
}
