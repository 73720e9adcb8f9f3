//! Why a segment meets a plane at t = d₁ / (d₁ − d₂). From P₁ to P₂ the value of n·P + D goes evenly from d₁ to d₂: planes parallel
//! to the given one, one level apart, cut the segment into equal pieces, since the triangles between them are all alike. The given plane is
//! the level 0, so −d₁ levels lie before it, of d₂ − d₁. *Cost*: that of both distances, and two divisions.

use serde::Serialize;

use crate::{
    algo::{segment::Ends, volume::plane_distances},
    geom::Plane,
    trace::{Real, Told},
};

use super::Proof;

/// The proof; see the module.
#[derive(Clone, Copy, Debug)]
pub struct Similar;

/// A plane, and the ends of a segment.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct SimilarInput {
    /// Its normal may have any length.
    pub plane: Plane,
    /// P₁ and P₂.
    pub ends: Ends<3>,
}

/// What is shown, in order.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum SimilarFact {
    /// n·P₁ + D
    D1,
    /// n·P₂ + D
    D2,
    /// d₂ − d₁: so many levels from end to end.
    Levels,
    /// All of the segment lies on one level: no triangle, and no t. The end.
    Parallel,
    /// Which part of the segment lies between two levels one apart.
    Piece,
    /// Where the segment meets the plane: the end.
    T,
}

impl Proof for Similar {
    type Input = SimilarInput;
    type Fact = SimilarFact;

    fn prove<R: Real, S>(
        input: &SimilarInput,
        show: &mut impl FnMut(SimilarFact, R) -> Told<S>,
    ) -> Told<S> {
        let [d1, d2] = plane_distances::<R>(&input.plane, &input.ends);
        show(SimilarFact::D1, d1)?;
        show(SimilarFact::D2, d2)?;
        let levels = d2 - d1;
        show(SimilarFact::Levels, levels)?;
        if levels == R::new(0.0) {
            return show(SimilarFact::Parallel, d1);
        }
        show(SimilarFact::Piece, R::new(1.0) / levels)?;
        show(SimilarFact::T, d1 / (d1 - d2))
    }

    fn max_facts(_: &SimilarInput) -> usize {
        5
    }
}
