//! Why nothing on the far side of a plane hides what is on the eye's own. Along a straight line of sight the distance from a plane changes
//! evenly. If it is positive at the eye and at Q, it is so at every place between: whatever stands in front of Q stands on the eye's side. On the way
//! to R, on the other side, it is 0 once. To meet the far side and come back the line of sight would have to bend. *Cost*: three distances
//! and a division.

use serde::Serialize;

use crate::{
    algo::volume::signed_distance,
    geom::Plane,
    trace::{Real, Told},
};

use super::Proof;

/// The proof; see the module.
#[derive(Clone, Copy, Debug)]
pub struct CrossesOnce;

/// A plane, an eye, and a place on each side of it.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CrossesOnceInput {
    /// Turned so that the eye is in front of it; none where the triangle has none, or where the eye lies in it.
    pub plane: Option<Plane>,
    /// Where the lines of sight begin.
    pub eye: [f64; 3],
    /// Q, on the eye's side, if something is there.
    pub own: Option<[f64; 3]>,
    /// R, on the other one, if something is there.
    pub other: Option<[f64; 3]>,
}

/// What is shown, in order.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum CrossesOnceFact {
    /// The plane has no sides that could be told apart: the end.
    NoSides,
    /// The distance of the eye.
    Eye,
    /// The distance of Q.
    Own,
    /// The least distance on the way from the eye to Q.
    Least,
    /// The distance of R.
    Other,
    /// After which part of the way to R the distance is 0.
    Crossing,
}

impl Proof for CrossesOnce {
    type Input = CrossesOnceInput;
    type Fact = CrossesOnceFact;

    fn prove<R: Real, S>(
        input: &CrossesOnceInput,
        show: &mut impl FnMut(CrossesOnceFact, R) -> Told<S>,
    ) -> Told<S> {
        let Some(plane) = &input.plane else {
            return show(CrossesOnceFact::NoSides, R::new(0.0));
        };
        let eye = signed_distance::<R>(plane, input.eye);
        show(CrossesOnceFact::Eye, eye)?;
        if let Some(at) = input.own {
            let own = signed_distance(plane, at);
            show(CrossesOnceFact::Own, own)?;
            show(CrossesOnceFact::Least, if own < eye { own } else { eye })?;
        }
        if let Some(at) = input.other {
            let other = signed_distance(plane, at);
            show(CrossesOnceFact::Other, other)?;
            show(CrossesOnceFact::Crossing, eye / (eye - other))?;
        }
        Told::Continue(())
    }

    fn max_facts(_: &CrossesOnceInput) -> usize {
        5
    }
}
