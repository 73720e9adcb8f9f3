//! Why n·(P − p₀) is the distance of P from a plane. Light along the plane casts a shadow of the way from p₀, a point of the plane, to P on
//! the plane's normal. Shadows add up: each step along an axis casts its own, as long as the step times that component of n. The whole shadow
//! is the side of a rectangle that lies opposite to the perpendicular from the plane to P. *Cost*: a multiplication a component, twice.

use serde::Serialize;

use crate::{
    algo::volume::signed_distance,
    geom::Plane,
    trace::{Real, Told},
};

use super::Proof;

/// The proof; see the module.
#[derive(Clone, Copy, Debug)]
pub struct Shadow;

/// A plane whose normal has length 1, a point, and two points of the plane to set out from.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ShadowInput {
    /// With n of length 1.
    pub plane: Plane,
    /// P
    pub point: [f64; 3],
    /// p₀, and another one.
    pub from: [[f64; 3]; 2],
}

/// What is shown, in order.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum ShadowFact {
    /// The shadow of the step along x; none where n has no such component, and so of y and z.
    X,
    /// Of the step along y.
    Y,
    /// Of the step along z.
    Z,
    /// All of them, end to end: n·(P − p₀).
    Sum,
    /// The perpendicular from the plane to P: n·P + D.
    Distance,
    /// n·(P − p₀) from the other p₀: the end.
    Elsewhere,
}

impl ShadowFact {
    /// Of the steps along x, y and z.
    pub const STEPS: [Self; 3] = [Self::X, Self::Y, Self::Z];
}

impl ShadowInput {
    /// How long the shadow of a step is, from the first p₀ or from the other one.
    #[must_use]
    pub fn piece<R: Real>(&self, from: usize, axis: usize) -> R {
        let step = R::new(self.point[axis]) - R::new(self.from[from][axis]);
        step * R::new(self.plane.normal()[axis])
    }

    /// The axes along which n has a component.
    pub fn axes(&self) -> impl Iterator<Item = usize> {
        let normal = self.plane.normal();
        (0..3).filter(move |&axis| normal[axis] != 0.0)
    }
}

impl Proof for Shadow {
    type Input = ShadowInput;
    type Fact = ShadowFact;

    fn prove<R: Real, S>(
        input: &ShadowInput,
        show: &mut impl FnMut(ShadowFact, R) -> Told<S>,
    ) -> Told<S> {
        let mut sum = R::new(0.0);
        for axis in input.axes() {
            let piece = input.piece::<R>(0, axis);
            show(ShadowFact::STEPS[axis], piece)?;
            sum = sum + piece;
        }
        show(ShadowFact::Sum, sum)?;
        show(
            ShadowFact::Distance,
            signed_distance(&input.plane, input.point),
        )?;
        let elsewhere = input.axes().map(|axis| input.piece::<R>(1, axis));
        let none = R::new(0.0);
        show(
            ShadowFact::Elsewhere,
            elsewhere.fold(none, |sum, it| sum + it),
        )
    }

    fn max_facts(_: &ShadowInput) -> usize {
        6
    }
}
