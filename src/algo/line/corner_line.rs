//! The line from P₁ through a corner of the window, and on which side of it P₂ lies.
//!
//! ```text
//!     left  │     ╱          P₂ left of the line: of the two borders through C, the horizontal
//!           │   ╱            one is crossed first here; right of it: the vertical one. At the
//!           │ ╱  window      window's other diagonal it is the other way round.
//!   ┄┄┄┄┄┄┄┄C──────────
//!         ╱ ┊
//!    P₁ ●   ┊      right
//! ```
//!
//! With `a` and `b` the ends' coordinates from the corner C, P₂ is left of the line where
//! `(C − P₁) × (P₂ − P₁) = b₁·a₂ − a₁·b₂` is positive. Each border lies between P₁ and P₂ wherever the
//! algorithm asks, so both products have the same sign, and their magnitudes tell which one is crossed first:
//! `u = |a₁| / (|a₁| + |a₂|)` is below `|b₁| / (|b₁| + |b₂|)` where `|a₁·b₂| < |b₁·a₂|`.

use std::cmp::Ordering;

use serde::Serialize;

use crate::{
    geom::{Edge, Point, Segment, Window},
    trace::Real,
};

use super::{super::parameter::compare_products, crossing::signed_distances};

/// A line from P₁ through a corner, and P₂ beside it.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
pub struct CornerLine {
    /// C, the corner.
    pub corner: Point,
    /// The vertical and the horizontal side that meet there.
    pub edges: [Edge; 2],
    /// `a₁·b₂` and `b₁·a₂`, rounded: P₂ is left of the line where the second is larger.
    pub products: [f64; 2],
    /// Where P₂ lies.
    pub turn: Turn,
    /// Of the two borders, the one that the segment's line crosses first; `None` through the corner.
    pub first: Option<Edge>,
}

/// Where a point lies, looking from P₁ through the corner.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Turn {
    /// To the left.
    Left,
    /// On the line.
    Through,
    /// To the right.
    Right,
}

impl CornerLine {
    /// Where P₂ lies. Neither border may have both ends strictly on the same side.
    #[must_use]
    pub fn beside<R: Real>(
        [x_edge, y_edge]: [Edge; 2],
        window: &Window,
        segment: &Segment,
    ) -> Self {
        // Distances are positive inside: right and top need their signs turned to give coordinates.
        let from_corner = |edge: Edge| {
            let distances = signed_distances::<R>(segment, window, edge);
            distances.map(|d| if edge.is_max() { -d } else { d })
        };
        let ([a1, a2], [b1, b2]) = (from_corner(x_edge), from_corner(y_edge));
        let order = compare_products([a1, b2], [b1, a2]);
        let negative = [[a1, b2], [b1, a2]].iter().any(|factors| {
            let [p, q] = factors.map(R::get);
            p < 0.0 && q > 0.0 || p > 0.0 && q < 0.0
        });
        let nearer = if negative { order.reverse() } else { order };
        Self {
            corner: Point::from_finite(window.border(x_edge), window.border(y_edge)),
            edges: [x_edge, y_edge],
            products: [a1.get() * b2.get(), b1.get() * a2.get()],
            turn: match order {
                Ordering::Less => Turn::Left,
                Ordering::Equal => Turn::Through,
                Ordering::Greater => Turn::Right,
            },
            first: match nearer {
                Ordering::Less => Some(x_edge),
                Ordering::Equal => None,
                Ordering::Greater => Some(y_edge),
            },
        }
    }
}
