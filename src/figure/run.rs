//! A recorded run with its type erased: what the timeline, a lesson and the command line need of any algorithm.

use std::ops::ControlFlow;

use serde_json::Value as Json;

use crate::trace::Counts;

use super::{
    frame::{Caption, Choice, Frame, Shown},
    moment::Moment,
    role::Link,
    watch::{Watch, mark_changes},
    words::Words,
};

/// Runs longer than this are not searched event by event when the scene is changed: a drag has no time for it.
const LONG: usize = 4096;
const NEARBY: usize = 64;

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Tick {
    Test,
    Cut,
    Accept,
    Reject,
    Phase,
}

pub trait Run: Send {
    /// Number of events. Step 0 is before the first.
    fn n_steps(&self) -> usize;
    /// Could the method not take the scene? Then there are no steps, and the caption says why.
    fn is_refused(&self) -> bool {
        false
    }
    fn tick(&self, step: usize) -> Tick;
    /// That event as JSON: `{"event": "cut", "edge": "left", …}`.
    fn event_json(&self, step: usize) -> Json;
    /// That event's words, in place of those that are in `words`: its name, then its fields that are words.
    fn read_words(&self, step: usize, words: &mut Words);
    fn counts_at(&self, step: usize) -> Counts;
    fn code_line(&self, step: usize) -> Option<usize>;

    /// Shows steps `from..=to`, one after the other, in one run, until `look` breaks off.
    fn visit(
        &self,
        from_to: [usize; 2],
        look: &mut dyn FnMut(usize, &dyn Shown) -> ControlFlow<()>,
    );

    fn output_json(&self) -> Json;

    /// Where a run that is wrong on purpose first does something else than the right one, from step 1.
    fn differs_at(&self) -> Option<usize> {
        None
    }
}

/// What is the same for all of them is compiled once.
impl dyn Run + '_ {
    /// The moment of a step, to be found again in another run; `start` at step 0.
    pub fn moment(&self, step: usize) -> Moment {
        if step == 0 {
            return Moment::Start;
        }
        let (mut words, mut other) = (Words::default(), Words::default());
        self.read_words(step, &mut words);
        let is_same = |&step: &usize| {
            self.read_words(step, &mut other);
            other == words
        };
        let nth = (1..step).filter(is_same).count() + 1;
        Moment::Event { words, nth }
    }

    /// The last step up to this one that answers a question, and what might come there.
    pub fn decision_by(&self, step: usize) -> Option<(usize, Choice)> {
        (1..=step.min(self.n_steps())).rev().find_map(|step| {
            let mut choice = None;
            self.visit([step, step], &mut |_, shown| {
                choice = shown.options().filter(Choice::is_open);
                ControlFlow::Break(())
            });
            Some((step, choice?))
        })
    }

    /// The step at which it is asked what another one decides: the one before, or where the phase began that leads to it.
    pub fn asked_at(&self, decided: usize, choice: &Choice) -> usize {
        let begins = |&step: &usize| step == 0 || self.tick(step) == Tick::Phase;
        let mut before = (0..decided).rev();
        let found = if choice.is_of_phase {
            before.find(begins)
        } else {
            before.next()
        };
        found.unwrap_or_default()
    }

    pub fn find(&self, moment: &Moment) -> Option<usize> {
        let (wanted, nth) = match moment {
            Moment::Start => return Some(0),
            Moment::End => return Some(self.n_steps()),
            Moment::Event { words, nth } => (words, nth),
        };
        let mut words = Words::default();
        let fits = |step: &usize| {
            self.read_words(*step, &mut words);
            words.include(wanted)
        };
        (1..=self.n_steps()).filter(fits).nth(nth - 1)
    }

    /// The step to show beside `step` of another run: its end beside the other's end. As long as both do the same, as many
    /// steps in; where they part, what this run does in place of the other, or, where the other only does more, the last that
    /// both did; from then on the same moment, or where that never comes, as many steps in.
    pub fn beside(&self, other: &dyn Run, step: usize) -> usize {
        if step >= other.n_steps() {
            return self.n_steps();
        }
        let as_many = step.min(self.n_steps());
        if self.n_steps().max(other.n_steps()) > LONG {
            return as_many;
        }
        let [mut own, mut others] = [Words::default(), Words::default()];
        let mut is_parted = |step: &usize| {
            self.read_words(*step, &mut own);
            other.read_words(*step, &mut others);
            own != others
        };
        match (1..=as_many).find(&mut is_parted) {
            None => as_many,
            Some(parted) if parted < step => {
                let moment = other.moment(step);
                let same = self.find(&moment);
                same.or_else(|| self.find(&moment.of_any_kind()))
                    .unwrap_or(as_many)
            }
            Some(_) => {
                let is_other_kind = own.name() != others.name();
                other.read_words(step + 1, &mut others);
                let same = is_other_kind.then(|| self.find(&other.moment(step)));
                match same.flatten() {
                    _ if own == others => as_many - 1,
                    Some(same) => same,
                    None => as_many,
                }
            }
        }
    }

    /// Where a cursor at `step` of `before` belongs: at the same moment, else the same kind of event, else as near as can be.
    pub fn corresponding(&self, before: &dyn Run, step: usize) -> usize {
        if step >= before.n_steps() {
            return self.n_steps();
        }
        if self.n_steps().max(before.n_steps()) > LONG {
            return as_far_along(self, before, step);
        }
        let moment = before.moment(step);
        let kind = moment.of_any_kind();
        let Some(found) = self.find(&moment) else {
            return self.find(&kind).unwrap_or_else(|| step.min(self.n_steps()));
        };
        // The third plane is the same plane, whatever is said of it; the third that is kept may be another.
        let about = |run: &dyn Run, step| {
            let decided = run.shown(step, |shown| shown.decision());
            decided.map(|(_, about)| about)
        };
        let subject = about(before, step);
        let is_about = |step: &usize| about(self, *step) == subject;
        let another = || self.find(&kind).filter(is_about);
        if subject.is_none() || is_about(&found) {
            found
        } else {
            another().unwrap_or(found)
        }
    }

    /// # Panics
    /// Where the run, made again, does not tell what it told: every method is tested for it.
    pub fn frame(&self, step: usize) -> Frame {
        let mut seen = None;
        self.frames([step, step], |_| true, |_, frame| seen = Some(frame));
        seen.expect("a run comes past each of its steps")
    }

    pub fn frames(
        &self,
        [from, to]: [usize; 2],
        wanted: impl Fn(usize) -> bool,
        mut look: impl FnMut(usize, Frame),
    ) {
        let mut before = None;
        self.visit([from.saturating_sub(1), to], &mut |step, shown| {
            let is_wanted = step >= from && wanted(step);
            if is_wanted || (step < to && wanted(step + 1)) {
                let mut watch = shown.watch();
                if let Some(before) = before.take() {
                    mark_changes(&mut watch, &before);
                }
                if is_wanted {
                    let frame = Frame {
                        views: shown.views(),
                        caption: shown.caption(),
                        code_line: self.code_line(step),
                        watch: watch.clone(),
                        counts: self.counts_at(step),
                    };
                    look(step, frame);
                }
                before = Some(watch);
            } else {
                before = None;
            }
            ControlFlow::Continue(())
        });
    }

    /// The moment of a step in as few words as lead back to it.
    pub fn shortest_moment(&self, step: usize) -> Moment {
        if step == 0 || step >= self.n_steps() {
            return if step == 0 {
                Moment::Start
            } else {
                Moment::End
            };
        }
        let whole = self.moment(step);
        let text = whole.to_string();
        let mut words = text.split(' ');
        let event = words.next().unwrap_or_default();
        let with_one = words.map(|word| format!("{event} {word}"));
        let shorter = [event.to_owned()].into_iter().chain(with_one);
        let mut shorter = shorter.filter_map(|text| text.parse().ok());
        let found = shorter.find(|moment| self.find(moment) == Some(step));
        found.unwrap_or(whole)
    }

    pub fn caption(&self, step: usize) -> Caption {
        self.shown(step, |shown| shown.caption())
    }

    pub fn watch(&self, step: usize) -> Watch {
        self.shown(step, |shown| shown.watch())
    }

    /// # Panics
    /// Where the run, made again, does not tell what it told: every method is tested for it.
    pub fn shown<T>(&self, step: usize, look: impl FnOnce(&dyn Shown) -> T) -> T {
        let (mut look, mut seen) = (Some(look), None);
        self.visit([step, step], &mut |_, shown| {
            seen = look.take().map(|look| look(shown));
            ControlFlow::Break(())
        });
        seen.expect("a run comes past each of its steps")
    }

    pub fn why(&self, thing: Link) -> Option<usize> {
        self.why_until(thing, self.n_steps())
    }

    /// The same of its steps up to this one.
    pub fn why_until(&self, thing: Link, step: usize) -> Option<usize> {
        let mut found = None;
        self.visit([1, step], &mut |step, shown| {
            if shown.decision().is_some_and(|(_, about)| about == thing) {
                found = Some(step);
            }
            ControlFlow::Continue(())
        });
        found
    }
}

/// Do both tell the same on the last steps up to this one? So they do where what was added is asked later.
fn come_alike(now: &dyn Run, before: &dyn Run, step: usize) -> bool {
    let [mut own, mut others] = [Words::default(), Words::default()];
    let first = step.saturating_sub(NEARBY) + 1;
    step <= now.n_steps()
        && (first..=step).all(|step| {
            now.read_words(step, &mut own);
            before.read_words(step, &mut others);
            own == others
        })
}

fn as_far_along(now: &dyn Run, before: &dyn Run, step: usize) -> usize {
    let n_steps = now.n_steps();
    if n_steps == before.n_steps() || step == 0 || come_alike(now, before, step) {
        return step;
    }
    let part = step as f64 / before.n_steps() as f64;
    let there = ((part * n_steps as f64).round() as usize).clamp(1.min(n_steps), n_steps);
    let kind = before.tick(step);
    (0..=NEARBY)
        .flat_map(|by| [there.checked_sub(by), Some(there + by)])
        .flatten()
        .filter(|step| (1..=n_steps).contains(step))
        .find(|&step| now.tick(step) == kind)
        .unwrap_or(there)
}
