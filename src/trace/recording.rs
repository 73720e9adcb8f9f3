//! A recorded run, and the state after any number of its events.

use super::{Algorithm, Counted, Counts};

use keyframes::Keyframes;

mod keyframes;

/// Input, events, cost so far at each, answer, and keyframes.
#[derive(Clone)]
pub struct Trace<A: Algorithm> {
    input: A::Input,
    events: Vec<A::Event>,
    /// Cost up to and including each event.
    counts: Vec<Counts>,
    total: Counts,
    output: A::Output,
    keyframes: Keyframes<A::State>,
}

impl<A: Algorithm> Trace<A> {
    /// Runs the algorithm on `input` and keeps everything that it says.
    #[must_use]
    pub fn record(input: A::Input) -> Self {
        let (mut events, mut counts) = (Vec::new(), Vec::new());
        let (output, total) = Counts::of(|| {
            A::run::<Counted>(&input, |event| {
                events.push(event);
                counts.push(Counts::so_far());
            })
        });
        let mut state = A::start(&input);
        let mut keyframes = Keyframes::starting_with(state.clone());
        for (i, &event) in events.iter().enumerate() {
            A::apply(&mut state, event);
            keyframes.offer(i + 1, &state);
        }
        Self {
            input,
            events,
            counts,
            total,
            output,
            keyframes,
        }
    }

    /// What it ran on.
    #[must_use]
    pub const fn input(&self) -> &A::Input {
        &self.input
    }

    /// In the order in which they were emitted.
    #[must_use]
    pub fn events(&self) -> &[A::Event] {
        &self.events
    }

    /// The answer.
    #[must_use]
    pub const fn output(&self) -> &A::Output {
        &self.output
    }

    /// The event that leads to step `n_steps`; none at step 0.
    #[must_use]
    pub fn event_at(&self, n_steps: usize) -> Option<A::Event> {
        n_steps
            .checked_sub(1)
            .and_then(|i| self.events.get(i))
            .copied()
    }

    /// Cost of the first `n_steps` events; the whole run's at the end.
    #[must_use]
    pub fn counts_at(&self, n_steps: usize) -> Counts {
        if n_steps >= self.events.len() {
            return self.total;
        }
        n_steps
            .checked_sub(1)
            .map_or(Counts::default(), |i| self.counts[i])
    }

    /// The first step, from 1, at which `B` does something else on the same input; none where it never does.
    #[must_use]
    pub fn first_difference<B>(&self) -> Option<usize>
    where
        B: Algorithm<Input = A::Input, Event = A::Event>,
    {
        let (mut n_events, mut differs) = (0, None);
        B::run::<f64>(&self.input, |event| {
            n_events += 1;
            if differs.is_none() && self.event_at(n_events) != Some(event) {
                differs = Some(n_events);
            }
        });
        differs.or_else(|| (n_events < self.events.len()).then_some(n_events + 1))
    }

    /// State after the first `n_steps` events, or after all of them where there are fewer.
    #[must_use]
    pub fn state_at(&self, n_steps: usize) -> A::State {
        let n_steps = n_steps.min(self.events.len());
        let (kept_steps, kept) = self.keyframes.before(n_steps);
        let mut state = kept.clone();
        for &event in &self.events[kept_steps..n_steps] {
            A::apply(&mut state, event);
        }
        state
    }
}
