//! Which side of a plane is a point on? Inside is n·p + d ≥ 0, for every volume here is closed.

use serde::Serialize;

use crate::{geom::Plane, trace::Real};

/// The three answers.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum PlaneSide {
    /// On the side that the normal points to.
    Inside,
    /// On the plane itself, which counts as inside.
    On,
    /// On the other side.
    Outside,
}

impl PlaneSide {
    /// From n·p + d, or the distance.
    pub fn of<R: Real>(value: R) -> Self {
        let zero = R::new(0.0);
        if value > zero {
            Self::Inside
        } else if value == zero {
            Self::On
        } else {
            Self::Outside
        }
    }
}

/// n·p + d: the distance of p from the plane, |n| times as long. Exact where products and sums are, and so is its sign.
#[inline]
#[must_use]
pub fn weighted_sum<R: Real>(plane: &Plane, p: [f64; 3]) -> R {
    let [x, y, z] = p.map(R::new);
    let [a, b, c] = plane.normal().map(R::new);
    a * x + b * y + c * z + R::new(plane.d())
}

/// (n·p + d) / |n|: positive on the side that the normal points to. A normal of length 1 costs no division.
#[inline]
#[must_use]
pub fn signed_distance<R: Real>(plane: &Plane, p: [f64; 3]) -> R {
    let sum = weighted_sum(plane, p);
    match plane.length() {
        1.0 => sum,
        length => sum / R::new(length),
    }
}
