//! Proofs by picture: where a formula comes from. A proof finds the formula's terms one after the other, in numbers of the
//! reader's own scene, and tells each as one event: a fact and its number. It needs no case: it answers nothing that the
//! method, whose formula it proves, does not.
//!
//! ```
//! use clipscope::{algo::why::{Similar, SimilarFact, SimilarInput, Why}, geom::Plane, trace::silent};
//! let plane = Plane::new([0.0, 1.0, 0.0, 0.0])?;
//! let facts = silent::<Why<Similar>>(&SimilarInput { plane, ends: [[0.0, -1.0, 0.0], [4.0, 3.0, 0.0]] });
//! assert_eq!(facts.get(SimilarFact::T), Some(0.25));
//! # Ok::<(), clipscope::geom::SpaceError>(())
//! ```

mod bridge;
mod crosses_once;
mod double_area;
mod error_term;
mod facing;
mod fence;
mod mean;
mod projection_row;
mod quarter_turn;
mod shadow;
mod similar;
mod strips;

use std::marker::PhantomData;

use serde::Serialize;

use crate::trace::{Method, Real, Tell, Told};

pub use bridge::{Bridge, BridgeFact, BridgeInput};
pub use crosses_once::{CrossesOnce, CrossesOnceFact, CrossesOnceInput};
pub use double_area::{DoubleArea, DoubleAreaFact, DoubleAreaInput};
pub use error_term::{ErrorTerm, ErrorTermFact, ErrorTermInput};
pub use facing::{Facing, FacingFact, FacingInput};
pub use fence::{Fence, FenceFact, FenceInput};
pub use mean::{Mean, MeanFact};
pub use projection_row::{ProjectionRow, ProjectionRowFact, ProjectionRowInput};
pub use quarter_turn::{QuarterTurn, QuarterTurnFact, QuarterTurnInput};
pub use shadow::{Shadow, ShadowFact, ShadowInput};
pub use similar::{Similar, SimilarFact, SimilarInput};
pub use strips::{Strips, StripsFact};

/// Where a formula comes from.
pub trait Proof: Sized + 'static {
    /// The numbers of a scene that it is shown on.
    type Input: Clone;
    /// What is found, a fact a step.
    type Fact: Copy + PartialEq;

    /// Finds the facts, each from the input and the facts before it.
    ///
    /// # Errors
    /// [`Told::Break`] where `show` stops.
    fn prove<R: Real, S>(
        input: &Self::Input,
        show: &mut impl FnMut(Self::Fact, R) -> Told<S>,
    ) -> Told<S>;

    /// No proof on this input shows more facts than this.
    fn max_facts(input: &Self::Input) -> usize;
}

/// The method that shows the proof `P`.
#[derive(Clone, Copy, Debug)]
pub struct Why<P>(PhantomData<P>);

/// A fact, and its number.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
pub struct Shown<F> {
    /// What it is the number of; as JSON it is the event.
    #[serde(flatten)]
    pub fact: F,
    /// In the scene.
    pub number: f64,
}

/// What has been shown so far.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct Facts<F>(Vec<Shown<F>>);

impl<F: Copy + PartialEq> Facts<F> {
    /// The last number of a fact; none before it is shown.
    #[must_use]
    pub fn get(&self, fact: F) -> Option<f64> {
        self.all(fact).last()
    }

    /// All numbers of a fact, in the order in which they were shown.
    pub fn all(&self, fact: F) -> impl DoubleEndedIterator<Item = f64> {
        let of_it = self.0.iter().filter(move |shown| shown.fact == fact);
        of_it.map(|shown| shown.number)
    }
}

impl<P: Proof> Method for Why<P> {
    type Input = P::Input;
    type Held = Facts<P::Fact>;
    type Output = Facts<P::Fact>;
    type Event = Shown<P::Fact>;

    fn begin(_: &Self::Input) -> Self::Held {
        Facts(Vec::new())
    }

    fn run<R: Real, T: Tell<Self>>(
        input: &Self::Input,
        held: &mut Self::Held,
        tell: &mut T,
    ) -> Told<T::Stop> {
        P::prove::<R, _>(input, &mut |fact, number| {
            let number = number.get();
            let shown = Shown { fact, number };
            held.0.push(shown);
            tell.tell(held, shown)
        })
    }

    fn output(held: Self::Held) -> Self::Output {
        held
    }

    fn max_events(input: &Self::Input) -> usize {
        P::max_facts(input)
    }
}
