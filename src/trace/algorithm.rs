//! What every algorithm in this crate is.

use super::Real;

/// An algorithm that reports what it does as it works.
pub trait Algorithm {
    /// Validated already: no NaN, windows ordered.
    type Input: Clone;
    /// The answer.
    type Output: Clone + PartialEq;
    /// A small happening: ids, numbers and points; no `String`, no `Vec`.
    type Event: Copy + PartialEq;
    /// What a picture of a step needs, the answer included.
    type State: Clone;

    /// Runs once, calling `emit` at every step. `R` is `f64`, or a scalar that counts.
    fn run<R: Real>(input: &Self::Input, emit: impl FnMut(Self::Event)) -> Self::Output;

    /// Before the first event.
    fn start(input: &Self::Input) -> Self::State;

    /// Copies the event's data into the state: no predicate, no arithmetic.
    fn apply(state: &mut Self::State, event: Self::Event);

    /// The answer that a state holds after the last event.
    fn finish(state: &Self::State) -> Self::Output;

    /// No run on this input emits more events than this.
    fn max_events(input: &Self::Input) -> usize;
}

/// The answer and nothing else, as a program would ask for it.
pub fn silent<A: Algorithm>(input: &A::Input) -> A::Output {
    A::run::<f64>(input, |_| {})
}
