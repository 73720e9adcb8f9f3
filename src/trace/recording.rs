//! A recorded run: its events, its cost so far at each, its answer, and some copies of its memory.

use std::convert::Infallible;

use super::{
    Counted, Counts,
    method::{Listening, Method, Tell, Told},
};

use rests::Rests;

mod rests;

/// A step to be shown.
pub struct Step<'a, M: Method> {
    /// What the method runs on.
    pub input: &'a M::Input,
    /// The memory after the last event that is past.
    pub held: &'a M::Held,
    /// All events that have been told so far.
    pub past: &'a [M::Event],
}

impl<M: Method> Step<'_, M> {
    /// The event that led to this step; none before the first.
    #[must_use]
    pub fn event(&self) -> Option<M::Event> {
        self.past.last().copied()
    }
}

impl<M: Method> Clone for Step<'_, M> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<M: Method> Copy for Step<'_, M> {}

/// A recorded run.
pub struct Recording<M: Method> {
    input: M::Input,
    events: Vec<M::Event>,
    /// Cost up to and including each event.
    counts: Vec<Counts>,
    total: Counts,
    held: M::Held,
    rests: Rests<M::Held>,
}

/// Keeps everything that is told, and shows each step once.
struct Keeping<'a, M: Method, F> {
    input: &'a M::Input,
    look: F,
    events: Vec<M::Event>,
    counts: Vec<Counts>,
    rests: Rests<M::Held>,
}

impl<M: Method, F: FnMut(&Step<'_, M>)> Tell<M> for Keeping<'_, M, F> {
    type Stop = Infallible;

    fn tell(&mut self, held: &M::Held, event: M::Event) -> Told<Infallible> {
        self.events.push(event);
        self.counts.push(Counts::so_far());
        let (input, past) = (self.input, &self.events[..]);
        (self.look)(&Step { input, held, past });
        Told::Continue(())
    }

    fn rest(&mut self, held: &M::Held) {
        self.rests.offer(self.events.len(), held);
    }
}

impl<M: Method> Recording<M> {
    /// Runs the method on `input` and keeps everything that it tells.
    #[must_use]
    pub fn new(input: M::Input) -> Self {
        Self::looking(input, |_| {})
    }

    /// The same; `look` sees each step once, while it is recorded.
    pub fn looking(input: M::Input, look: impl FnMut(&Step<'_, M>)) -> Self {
        let mut keeping = Keeping {
            input: &input,
            look,
            events: Vec::new(),
            counts: Vec::new(),
            rests: Rests::default(),
        };
        let (held, total) = Counts::of(|| {
            let mut held = M::begin(&input);
            let Told::Continue(()) = M::run::<Counted, _>(&input, &mut held, &mut keeping);
            held
        });
        let Keeping {
            events,
            counts,
            rests,
            ..
        } = keeping;
        Self {
            input,
            events,
            counts,
            total,
            held,
            rests,
        }
    }

    /// What the method ran on.
    #[must_use]
    pub const fn input(&self) -> &M::Input {
        &self.input
    }

    /// The events, in the order in which they were told.
    #[must_use]
    pub fn events(&self) -> &[M::Event] {
        &self.events
    }

    /// The memory after the last event.
    #[must_use]
    pub const fn held(&self) -> &M::Held {
        &self.held
    }

    /// The copies of the memory that are kept, each with the number of events that were past.
    #[must_use]
    pub fn rests(&self) -> &[(usize, M::Held)] {
        self.rests.kept()
    }

    /// The answer.
    #[must_use]
    pub fn output(&self) -> M::Output {
        M::output(self.held.clone())
    }

    /// The event that leads to step `n_steps`; none at step 0.
    #[must_use]
    pub fn event_at(&self, n_steps: usize) -> Option<M::Event> {
        let i = n_steps.checked_sub(1)?;
        self.events.get(i).copied()
    }

    /// Cost of the first `n_steps` events; the whole run's at the end.
    #[must_use]
    pub fn counts_at(&self, n_steps: usize) -> Counts {
        if n_steps >= self.events.len() {
            return self.total;
        }
        let last = n_steps.checked_sub(1);
        last.map_or(Counts::default(), |i| self.counts[i])
    }

    /// Shows steps `from..=to`, one after the other, in one run; a break ends the walk.
    pub fn walk<S>(
        &self,
        [from, to]: [usize; 2],
        mut look: impl FnMut(usize, &Step<'_, M>) -> Told<S>,
    ) -> Option<S> {
        let n_steps = self.events.len();
        let to = to.min(n_steps);
        let mut see = |n: usize, held: &M::Held| {
            let (input, past) = (&self.input, &self.events[..n]);
            look(n, &Step { input, held, past })
        };
        let seen = if from >= n_steps {
            see(to, &self.held)
        } else {
            self.run_through([from, to], &mut see)
        };
        seen.break_value()
    }

    fn run_through<S>(
        &self,
        [from, to]: [usize; 2],
        see: &mut impl FnMut(usize, &M::Held) -> Told<S>,
    ) -> Told<S> {
        if from == 0 {
            see(0, &M::begin(&self.input))?;
        }
        if to == 0 {
            return Told::Continue(());
        }
        // At a rest, locals of the step before are gone already: so a rest strictly before `from`.
        let rest = self.rests.before(from.saturating_sub(1));
        let (mut n, mut held) = rest.map_or_else(|| (0, M::begin(&self.input)), Clone::clone);
        let mut listening = Listening(|held: &M::Held, _| {
            n += 1;
            if n < from {
                return Told::Continue(());
            }
            match see(n, held) {
                Told::Break(found) => Told::Break(Some(found)),
                Told::Continue(()) if n == to => Told::Break(None),
                Told::Continue(()) => Told::Continue(()),
            }
        });
        match M::run::<f64, _>(&self.input, &mut held, &mut listening) {
            Told::Break(Some(found)) => Told::Break(found),
            Told::Break(None) | Told::Continue(()) => Told::Continue(()),
        }
    }

    /// Shows one step.
    ///
    /// # Panics
    /// Where the run, made again, does not tell what it told: a law that every method is tested for.
    pub fn at<T>(&self, n_steps: usize, look: impl FnOnce(&Step<'_, M>) -> T) -> T {
        let n = n_steps.min(self.events.len());
        let mut look = Some(look);
        let seen = self.walk([n, n], |_, step| match look.take() {
            Some(look) => Told::Break(look(step)),
            None => Told::Continue(()),
        });
        seen.expect("a run that is made again comes past the same steps")
    }

    /// The first step, from 1, at which `B` does something else on the same input; none where it never does.
    #[must_use]
    pub fn first_difference<B>(&self) -> Option<usize>
    where
        B: Method<Input = M::Input, Event = M::Event>,
    {
        let mut n = 0;
        let mut comparing = Listening(|_: &B::Held, event| {
            n += 1;
            if self.event_at(n) == Some(event) {
                Told::Continue(())
            } else {
                Told::Break(n)
            }
        });
        let mut held = B::begin(&self.input);
        let differs = B::run::<f64, _>(&self.input, &mut held, &mut comparing).break_value();
        differs.or_else(|| (n < self.events.len()).then_some(n + 1))
    }
}
