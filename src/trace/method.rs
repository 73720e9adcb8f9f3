//! Told runs: an algorithm that works in its own memory and tells what it does.

use std::{convert::Infallible, ops::ControlFlow};

use super::Real;

/// What telling returns: the run goes on, or stops with what it was stopped for.
pub type Told<S, T = ()> = ControlFlow<S, T>;

/// An algorithm that tells what it does as it works.
pub trait Method: Sized {
    /// What it reads, validated already: no NaN, windows ordered.
    type Input: Clone;
    /// The memory that it works in. It holds the answer after the last event.
    type Held: Clone;
    /// The answer, as a program asks for it.
    type Output: Clone + PartialEq;
    /// A small happening: ids, numbers and points; no `String`, no `Vec`.
    type Event: Copy + PartialEq;

    /// The memory before the first event.
    fn begin(input: &Self::Input) -> Self::Held;

    /// Runs from where `held` rests, its beginning or a copy that was taken at [`Tell::rest`], to the end, or until `tell` stops
    /// the run. An event is told after `held` shows what it did.
    ///
    /// # Errors
    /// [`ControlFlow::Break`] with what `tell` stopped the run for.
    fn run<R: Real, T: Tell<Self>>(
        input: &Self::Input,
        held: &mut Self::Held,
        tell: &mut T,
    ) -> Told<T::Stop>;

    /// The answer that the memory holds after the last event.
    fn output(held: Self::Held) -> Self::Output;

    /// No run on this input tells more events than this.
    fn max_events(input: &Self::Input) -> usize;
}

/// A method that does all that `Part` does, in a part of its own memory.
pub trait Includes<Part: Method>: Method {
    /// The memory of the part.
    fn part(held: &Self::Held) -> &Part::Held;

    /// The same, to be changed.
    fn part_mut(held: &mut Self::Held) -> &mut Part::Held;

    /// An event of the part, as one of the whole.
    fn as_own(event: Part::Event) -> Self::Event;
}

impl<M: Method> Includes<M> for M {
    #[inline(always)]
    fn part(held: &M::Held) -> &M::Held {
        held
    }

    #[inline(always)]
    fn part_mut(held: &mut M::Held) -> &mut M::Held {
        held
    }

    #[inline(always)]
    fn as_own(event: M::Event) -> M::Event {
        event
    }
}

/// Who listens to a run.
pub trait Tell<M: Method> {
    /// What a run can be stopped for; [`Infallible`] where nothing stops it, and then `?` compiles to nothing.
    type Stop;

    /// An event has happened, and `held` shows what it did.
    ///
    /// # Errors
    /// [`ControlFlow::Break`] where the run is to stop.
    fn tell(&mut self, held: &M::Held, event: M::Event) -> Told<Self::Stop>;

    /// The run can go on from a copy of `held`: for methods whose silent runs take longer than some 2 ms.
    #[inline(always)]
    fn rest(&mut self, _held: &M::Held) {}
}

/// Nobody listens, and nothing stops the run.
#[derive(Clone, Copy, Debug)]
pub struct Silent;

impl<M: Method> Tell<M> for Silent {
    type Stop = Infallible;

    #[inline(always)]
    fn tell(&mut self, _: &M::Held, _: M::Event) -> Told<Infallible> {
        Told::Continue(())
    }
}

/// A closure listens.
#[derive(Clone, Copy, Debug)]
pub struct Listening<F>(
    /// It is called with what is held after each event, and with the event.
    pub F,
);

impl<M: Method, S, F: FnMut(&M::Held, M::Event) -> Told<S>> Tell<M> for Listening<F> {
    type Stop = S;

    #[inline]
    fn tell(&mut self, held: &M::Held, event: M::Event) -> Told<S> {
        (self.0)(held, event)
    }
}

/// Who is told of every event: of what is held after it, and of the event itself.
pub type Hear<'a, M> = &'a mut dyn FnMut(&<M as Method>::Held, <M as Method>::Event) -> Told<()>;

struct Heard<'a, M: Method>(Hear<'a, M>);

impl<M: Method> Tell<M> for Heard<'_, M> {
    type Stop = ();

    fn tell(&mut self, held: &M::Held, event: M::Event) -> Told<()> {
        (self.0)(held, event)
    }
}

/// Runs a method until the end, or until who hears it has heard enough. It is compiled once for all of them.
pub fn told<M: Method>(input: &M::Input, held: &mut M::Held, hear: Hear<'_, M>) -> Told<()> {
    M::run::<f64, _>(input, held, &mut Heard::<M>(hear))
}

/// The answer and nothing else, as a program asks for it.
#[inline]
pub fn silent<M: Method>(input: &M::Input) -> M::Output {
    M::output(held_after::<M, f64>(input))
}

/// The memory after a silent run over the scalar `R`.
#[inline]
pub fn held_after<M: Method, R: Real>(input: &M::Input) -> M::Held {
    let mut held = M::begin(input);
    let Told::Continue(()) = M::run::<R, _>(input, &mut held, &mut Silent);
    held
}
