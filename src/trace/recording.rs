//! A recorded run: its events, its cost so far at each, its answer, and some copies of its memory.

use std::convert::Infallible;

use super::{
    Counted, Counts,
    method::{Method, Tell, Told, told},
};

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

type Look<'a, M> = &'a mut dyn FnMut(&Step<'_, M>);

/// Keeps everything that is told, and shows each step once.
struct Keeping<'a, M: Method> {
    input: &'a M::Input,
    look: Look<'a, M>,
    events: Vec<M::Event>,
    counts: Vec<Counts>,
    rests: Rests<M::Held>,
}

impl<M: Method> Tell<M> for Keeping<'_, M> {
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
    pub fn looking(input: M::Input, mut look: impl FnMut(&Step<'_, M>)) -> Self {
        Self::seen_by(input, &mut look)
    }

    fn seen_by(input: M::Input, look: Look<'_, M>) -> Self {
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
        let (events, counts, rests) = (keeping.events, keeping.counts, keeping.rests);
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
        &self.rests.kept
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
        let mut found = None;
        let mut see = |n: usize, held: &M::Held| {
            let (input, past) = (&self.input, &self.events[..n]);
            let seen = look(n, &Step { input, held, past });
            seen.map_break(|it| found = Some(it))
        };
        let _ = if from >= n_steps {
            see(to, &self.held)
        } else {
            self.run_through([from, to], &mut see)
        };
        found
    }

    fn run_through(
        &self,
        [from, to]: [usize; 2],
        see: &mut dyn FnMut(usize, &M::Held) -> Told<()>,
    ) -> Told<()> {
        if from == 0 {
            see(0, &M::begin(&self.input))?;
        }
        if to == 0 {
            return Told::Continue(());
        }
        // At a rest, locals of the step before are gone already: so a rest strictly before `from`.
        let rest = self.rests.before(from.saturating_sub(1));
        let (mut n, mut held) = rest.map_or_else(|| (0, M::begin(&self.input)), Clone::clone);
        let mut hear = |held: &M::Held, _| {
            n += 1;
            if n < from {
                return Told::Continue(());
            }
            see(n, held)?;
            if n == to {
                Told::Break(())
            } else {
                Told::Continue(())
            }
        };
        told::<M>(&self.input, &mut held, &mut hear)
    }

    /// Shows one step.
    ///
    /// # Panics
    /// Where the run, made again, does not tell what it told, which is tested of every method.
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
    pub fn first_difference<B: Method<Input = M::Input, Event = M::Event>>(&self) -> Option<usize> {
        let mut n = 0;
        let mut hear = |_: &B::Held, event| {
            n += 1;
            if self.event_at(n) == Some(event) {
                Told::Continue(())
            } else {
                Told::Break(())
            }
        };
        let mut held = B::begin(&self.input);
        let is_different = told::<B>(&self.input, &mut held, &mut hear).is_break();
        let is_shorter = n < self.events.len();
        is_different
            .then_some(n)
            .or_else(|| is_shorter.then_some(n + 1))
    }
}

/// So many copies are kept at most, however long the run.
const MOST_KEPT: usize = 32;

/// Copies of what a run held at each `stride`-th of its rests, with the number of events that were past.
struct Rests<H> {
    stride: usize,
    n_offered: usize,
    kept: Vec<(usize, H)>,
}

impl<H> Default for Rests<H> {
    fn default() -> Self {
        Self {
            stride: 1,
            n_offered: 0,
            kept: Vec::new(),
        }
    }
}

impl<H: Clone> Rests<H> {
    /// Keeps a copy where one is due. Of 32 copies every other one is dropped, and the stride doubles.
    fn offer(&mut self, n_events: usize, held: &H) {
        self.n_offered += 1;
        if !self.n_offered.is_multiple_of(self.stride) {
            return;
        }
        if self.kept.len() == MOST_KEPT {
            let mut keep = true;
            self.kept.retain(|_| {
                keep = !keep;
                keep
            });
            self.stride *= 2;
            // The one that is offered stands between two that would be kept now.
            return;
        }
        self.kept.push((n_events, held.clone()));
    }

    /// The last copy after no more than `n_events`.
    fn before(&self, n_events: usize) -> Option<&(usize, H)> {
        let n = self.kept.partition_point(|(at, _)| *at <= n_events);
        self.kept[..n].last()
    }
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use super::{super::Real, *};

    #[test]
    fn however_many_are_offered_32_at_most_are_kept_evenly() {
        let mut rests = Rests::default();
        for n in 1..=5000 {
            rests.offer(n, &n);
            assert!(rests.kept.len() <= MOST_KEPT, "after {n}");
        }
        let at: Vec<usize> = rests.kept.iter().map(|(n, _)| *n).collect();
        assert!(at.len() >= MOST_KEPT / 2, "{at:?}");
        let is_even = |pair: &[usize]| pair[1] - pair[0] == rests.stride;
        assert!(at.windows(2).all(is_even), "{at:?}");
        assert_eq!(rests.before(at[3] + 1), Some(&(at[3], at[3])));
        assert_eq!(rests.before(at[0] - 1), None);
    }

    thread_local! {
        static N_COUNTED: Cell<usize> = const { Cell::new(0) };
    }

    /// Counts up to its input, and rests now and then.
    struct Count;

    impl Method for Count {
        type Input = usize;
        type Held = usize;
        type Output = usize;
        type Event = usize;

        fn begin(_: &usize) -> usize {
            0
        }

        fn run<R: Real, T: Tell<Self>>(
            input: &usize,
            held: &mut usize,
            tell: &mut T,
        ) -> Told<T::Stop> {
            while *held < *input {
                if held.is_multiple_of(64) {
                    tell.rest(held);
                }
                *held += 1;
                N_COUNTED.set(N_COUNTED.get() + 1);
                tell.tell(held, *held)?;
            }
            Told::Continue(())
        }

        fn output(held: usize) -> usize {
            held
        }

        fn max_events(input: &usize) -> usize {
            *input
        }
    }

    #[test]
    fn a_step_far_on_takes_no_more_of_a_run_than_the_way_from_one_copy_to_the_next() {
        let n = 200_000;
        let recording = Recording::<Count>::new(n);
        for step in [0, 1, 28_000, 161_860, n - 1, n] {
            N_COUNTED.set(0);
            assert_eq!(recording.at(step, |step| *step.held), step);
            let most = 2 * n / MOST_KEPT + 64;
            assert!(N_COUNTED.get() <= most, "step {step}: {}", N_COUNTED.get());
        }
    }
}
