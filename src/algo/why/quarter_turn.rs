//! Why the normal of a side plane is (±cos α, 0, −sin α). From above such a plane is a line through the eye; one unit of it goes sin α across and
//! cos α ahead, α being half the angle of view. A quarter turn to the inside makes the normal of it, and makes the legs of its triangle change
//! places, one of them with its sign turned. Lengths stay. *Cost*: a square root and two divisions.

use serde::Serialize;

use crate::{
    geom::{Sight, ViewVolume},
    trace::{Real, Told},
};

use super::Proof;

/// The proof; see the module.
#[derive(Clone, Copy, Debug)]
pub struct QuarterTurn;

/// A view volume, and a point whose distance from its right plane is a check.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct QuarterTurnInput {
    /// Whose right plane it is.
    pub volume: ViewVolume,
    /// In view space.
    pub point: [f64; 3],
}

/// What is shown, in order.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum QuarterTurnFact {
    /// How far the plane goes to the side while it goes one unit ahead: tan α.
    Tangent,
    /// Of one unit along the plane: sin α.
    Across,
    /// Of one unit along the plane: cos α.
    Ahead,
    /// Of the normal: −cos α.
    TurnedAcross,
    /// Of the normal: sin α.
    TurnedAhead,
    /// The distance of the point from the plane: the end.
    Distance,
}

impl QuarterTurnInput {
    /// How far the plane is from the eye, along its normal: 0 in perspective.
    #[must_use]
    pub const fn aside(&self) -> f64 {
        match self.volume.sight() {
            Sight::Perspective => 0.0,
            Sight::Parallel => self.volume.half_size()[0],
        }
    }
}

impl Proof for QuarterTurn {
    type Input = QuarterTurnInput;
    type Fact = QuarterTurnFact;

    fn prove<R: Real, S>(
        input: &QuarterTurnInput,
        show: &mut impl FnMut(QuarterTurnFact, R) -> Told<S>,
    ) -> Told<S> {
        let tangent = match input.volume.sight() {
            Sight::Perspective => input.volume.half_size()[0],
            Sight::Parallel => 0.0,
        };
        show(QuarterTurnFact::Tangent, R::new(tangent))?;
        let long = R::new(libm::hypot(1.0, tangent));
        let [across, ahead] = [R::new(tangent) / long, R::new(1.0) / long];
        show(QuarterTurnFact::Across, across)?;
        show(QuarterTurnFact::Ahead, ahead)?;
        show(QuarterTurnFact::TurnedAcross, -ahead)?;
        show(QuarterTurnFact::TurnedAhead, across)?;
        let [x, _, z] = input.point.map(R::new);
        let distance = -ahead * x + across * -z + R::new(input.aside());
        show(QuarterTurnFact::Distance, distance)
    }

    fn max_facts(_: &QuarterTurnInput) -> usize {
        6
    }
}
