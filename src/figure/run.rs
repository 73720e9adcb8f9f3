//! A recorded run with its type erased: what the timeline, a lesson and the command line need of any
//! algorithm, whichever lab it belongs to.

use std::ops::ControlFlow;

use serde_json::Value as Json;

use crate::trace::Counts;

use super::{
    frame::{Caption, Frame},
    moment::Moment,
    role::Link,
    shown::Shown,
    watch::{Watch, mark_changes},
    words::Words,
};

/// Runs longer than this are not searched event by event when the scene is changed: a drag has no time for it.
const LONG: usize = 4096;
/// In such a run, an event of the same kind is looked for within so many steps.
const NEARBY: usize = 64;

/// The kind of an event: the shape of its tick on the timeline.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Tick {
    /// Something was looked at.
    Test,
    /// Something was cut off.
    Cut,
    /// The end: visible.
    Accept,
    /// The end: not visible.
    Reject,
    /// A new side, plane or triangle begins.
    Phase,
}

/// A recorded run of some algorithm.
pub trait Run {
    /// Number of events. Step 0 is before the first.
    fn n_steps(&self) -> usize;
    /// Could the method not take the scene? Then there are no steps, and the caption says why.
    fn is_refused(&self) -> bool {
        false
    }
    /// The kind of the event that leads to step `step ≥ 1`.
    fn tick(&self, step: usize) -> Tick;
    /// That event as JSON: `{"event": "cut", "edge": "left", …}`.
    fn event_json(&self, step: usize) -> Json;
    /// That event's words, in place of those that are in `words`: its name, then its fields that are words.
    fn read_words(&self, step: usize, words: &mut Words);
    /// Cost up to and including that event.
    fn counts_at(&self, step: usize) -> Counts;
    /// The line of pseudocode that the event belongs to; none before the first.
    fn code_line(&self, step: usize) -> Option<usize>;

    /// Shows steps `from..=to`, one after the other, in one run, until `look` breaks off.
    fn visit(
        &self,
        from_to: [usize; 2],
        look: &mut dyn FnMut(usize, &dyn Shown) -> ControlFlow<()>,
    );

    /// The answer as JSON: the fields of `output` in `interfaces.md`.
    fn output_json(&self) -> Json;

    /// The moment of a step, to be found again in another run; `start` at step 0.
    fn moment(&self, step: usize) -> Moment {
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

    /// The step of a moment; `None` where it never comes.
    fn find(&self, moment: &Moment) -> Option<usize> {
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

    /// The step of this run to show beside `step` of another one: as many steps in, and its end beside the
    /// other's end.
    fn beside(&self, other: &dyn Run, step: usize) -> usize {
        if step >= other.n_steps() {
            self.n_steps()
        } else {
            step.min(self.n_steps())
        }
    }

    /// Where a cursor that stood at `step` of `before` belongs in this run: at the same moment where it
    /// comes, else at the same kind of event, else as near as can be. In a very long run, as far along.
    fn corresponding(&self, before: &dyn Run, step: usize) -> usize {
        if step >= before.n_steps() {
            return self.n_steps();
        }
        if self.n_steps().max(before.n_steps()) > LONG {
            return as_far_along(self, before, step);
        }
        let moment = before.moment(step);
        let kind = moment.of_any_kind();
        self.find(&moment)
            .or_else(|| self.find(&kind))
            .unwrap_or_else(|| step.min(self.n_steps()))
    }

    /// Where a run that is wrong on purpose first does something else than the right one does on the same input, from
    /// step 1; none where it never does, and of any other run.
    fn differs_at(&self) -> Option<usize> {
        None
    }
}

impl dyn Run + '_ {
    /// What the step shows: values that differ from the step before are marked.
    ///
    /// # Panics
    /// Where the run, made again, does not tell what it told: a law that every method is tested for.
    pub fn frame(&self, step: usize) -> Frame {
        let mut seen = None;
        self.frames([step, step], |_| true, |_, frame| seen = Some(frame));
        seen.expect("a run comes past each of its steps")
    }

    /// The frames of those of the steps `from..=to` that are wanted, in one run.
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
                    look(step, self.framed(step, shown, watch.clone()));
                }
                before = Some(watch);
            } else {
                before = None;
            }
            ControlFlow::Continue(())
        });
    }

    fn framed(&self, step: usize, shown: &dyn Shown, watch: Watch) -> Frame {
        Frame {
            views: shown.views(),
            caption: shown.caption(),
            code_line: self.code_line(step),
            watch,
            counts: self.counts_at(step),
        }
    }

    /// The sentence of the step alone.
    pub fn caption(&self, step: usize) -> Caption {
        self.shown(step, |shown| shown.caption())
    }

    /// The values that are alive at the step, alone: none is marked as changed.
    pub fn watch(&self, step: usize) -> Watch {
        self.shown(step, |shown| shown.watch())
    }

    /// What one step shows, or a part of that.
    ///
    /// # Panics
    /// Where the run, made again, does not tell what it told: a law that every method is tested for.
    pub fn shown<T>(&self, step: usize, look: impl FnOnce(&dyn Shown) -> T) -> T {
        let (mut look, mut seen) = (Some(look), None);
        self.visit([step, step], &mut |_, shown| {
            seen = look.take().map(|look| look(shown));
            ControlFlow::Break(())
        });
        seen.expect("a run comes past each of its steps")
    }

    /// The last step that decides about a thing; none where no step does.
    pub fn why(&self, thing: Link) -> Option<usize> {
        let mut found = None;
        self.visit([1, self.n_steps()], &mut |step, shown| {
            if shown.decision().is_some_and(|(_, about)| about == thing) {
                found = Some(step);
            }
            ControlFlow::Continue(())
        });
        found
    }
}

/// The step as many steps in, where both runs are as long; else as large a part of the way, at the nearest
/// event of the same kind.
fn as_far_along(now: &(impl Run + ?Sized), before: &dyn Run, step: usize) -> usize {
    let n_steps = now.n_steps();
    if n_steps == before.n_steps() || step == 0 {
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
