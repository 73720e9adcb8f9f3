//! Which way an outline turns at a vertex, decided exactly.
//!
//! ```text
//!   convex      c ●       straight             reflex  a ●──────● b
//!                ╱                                              │    twice the area of abc =
//!     a ●───────● b         a ●────●────● c                     │    (xb − xa)(yc − yb) − (yb − ya)(xc − xb)
//!      area > 0               b: area = 0        area < 0       ● c
//! ```

use serde::Serialize;

use crate::{
    geom::{Point, doubtful_area, is_certain},
    trace::Real,
};

/// How an outline that runs counter-clockwise turns at a vertex.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Corner {
    /// To the left: the angle inside is less than 180°.
    Convex,
    /// Not at all: 180°.
    Straight,
    /// To the right: more than 180°.
    Reflex,
}

impl Corner {
    /// By the sign of the corner's area; compares once with 0, and again where it is not positive.
    pub(super) fn of<R: Real>(double_area: R) -> Self {
        let zero = R::new(0.0);
        if double_area > zero {
            Self::Convex
        } else if double_area < zero {
            Self::Reflex
        } else {
            Self::Straight
        }
    }
}

/// Twice the signed area of abc, rounded, with the exact sign, whose adaptive predicate is not counted.
pub(super) fn double_area<R: Real>(a: Point, b: Point, c: Point) -> R {
    let [[xa, ya], [xb, yb], [xc, yc]] = [a, b, c].map(|p| p.to_array().map(R::new));
    let left = (xb - xa) * (yc - yb);
    let right = (yb - ya) * (xc - xb);
    let area = left - right;
    if is_certain(area.get(), left.get(), right.get()) {
        area
    } else {
        R::new(doubtful_area(a, b, c))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn corner(abc: [[f64; 2]; 3]) -> Corner {
        let [a, b, c] = abc.map(|p| Point::try_from(p).unwrap());
        Corner::of(double_area::<f64>(a, b, c))
    }

    #[test]
    fn a_turn_of_one_unit_in_the_last_place_is_seen() {
        let [a, c] = [[0.1, 0.1], [0.7, 0.7]];
        assert_eq!(corner([a, [0.3, 0.3], c]), Corner::Straight);
        assert_eq!(corner([a, [0.3, 0.3_f64.next_down()], c]), Corner::Convex);
        assert_eq!(corner([a, [0.3, 0.3_f64.next_up()], c]), Corner::Reflex);
    }

    #[test]
    fn any_size_will_do() {
        for scale in [5e-324, 1e-308, 1e-160, 1.0, 1e160, 8e307] {
            let left = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0]].map(|p| p.map(|x| x * scale));
            let [a, b, c] = left;
            assert_eq!(corner([a, b, c]), Corner::Convex, "at {scale:e}");
            assert_eq!(corner([c, b, a]), Corner::Reflex, "at {scale:e}");
            assert_eq!(corner([a, a, c]), Corner::Straight, "at {scale:e}");
        }
    }
}
