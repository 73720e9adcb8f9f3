//! Cohen–Sutherland: decide by outcodes first, cut only what they leave open.
//!
//! ```text
//!    1001 │ 1000 │ 1010        one bit a side: top bottom right left
//!   ──────┼──────┼──────       OR  = 0000  both ends inside: accept
//!    0001 │ 0000 │ 0010        AND ≠ 0000  both beyond one side: reject
//!   ──────┼──────┼──────       otherwise   cut at the side of the lowest bit
//!    0101 │ 0100 │ 0110                    set, and look again
//! ```
//!
//! 1. Give both ends a code.
//! 2. Accept or reject by OR and AND where that is possible.
//! 3. Take the lowest bit set in the OR. As the AND is 0, exactly one end has it: the segment crosses that
//!    side. Replace that end by the crossing, give it a new code, go to 2.
//!
//! The side is chosen from the OR of both codes, not from "the first end that is outside": then the cuts
//! do not depend on the direction of the segment. Crossings are computed from the original ends, so that
//! no rounding piles up, and kept within the part that is left, so that a bit once cleared stays clear.
//!
//! *Conventions*: closed window, y up. *Degenerate*: a point is accepted or rejected by its codes; a touch
//! is accepted. *Bound*: each cut clears a bit of the OR for good, so there are at most 4. *Cost*: 8
//! comparisons for the codes; 4 +, 2 ×, 1 ÷ and 7 comparisons a cut.
//!
//! *Source*: Danny Cohen and Ivan Sutherland, 1967; first printed in W. M. Newman and R. F. Sproull,
//! *Principles of Interactive Computer Graphics*, 1973, pp. 123–124.
//!
//! ```
//! use clipscope::{algo::line::{BitOrder, CohenSutherland, CohenSutherlandInput}, geom::{Segment, Window}, trace::silent};
//! let window = Window::new(-1.0, -1.0, 1.0, 1.0)?;
//! let segment = Segment::new(-2.0, -1.0, 2.0, 1.5)?;
//! let input = CohenSutherlandInput { window, segment, bit_order: BitOrder::Tbrl };
//! assert_eq!(silent::<CohenSutherland>(&input), Some(Segment::new(-1.0, -0.375, 1.0, 0.875)?));
//! # Ok::<(), clipscope::geom::GeomError>(())
//! ```

use crate::{
    algo::{
        parameter::{Ratio, clamp_between},
        segment::{CodeClip, CodeEvent, Coded, VisibleLine},
    },
    geom::{Edge, Point, Segment, Window},
    trace::Real,
};

use super::{
    BitOrder, Outcode, Visible,
    crossing::{crossing_at, join, split},
    ends_of, segment_of,
};

/// The algorithm; see the module.
pub type CohenSutherland = CodeClip<2, CohenSutherlandInput>;

/// What happens, in order.
pub type CohenSutherlandEvent = CodeEvent<2, Outcode, Edge>;

/// What to clip, and how codes are written.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CohenSutherlandInput {
    /// Closed.
    pub window: Window,
    /// Directed from P₁ to P₂.
    pub segment: Segment,
    /// Also the order of the cuts: lowest bit first.
    pub bit_order: BitOrder,
}

impl Coded<2> for CohenSutherlandInput {
    type Side = Edge;
    type Code = Outcode;
    type Output = Visible;
    const N_SIDES: usize = 4;

    #[inline]
    fn ends(&self) -> [[f64; 2]; 2] {
        ends_of(&self.segment)
    }

    #[inline]
    fn code<R: Real>(&self, at: [f64; 2]) -> Outcode {
        Outcode::of(at.map(R::new), &self.window, self.bit_order)
    }

    #[inline]
    fn lowest(&self, code: Outcode) -> Option<Edge> {
        code.lowest(self.bit_order)
    }

    #[inline]
    fn has(&self, code: Outcode, edge: Edge) -> bool {
        code.has(edge, self.bit_order)
    }

    #[inline]
    fn crossing<R: Real>(&self, edge: Edge, left: &[[f64; 2]; 2]) -> ([f64; 2], Ratio) {
        let (axis, border) = (edge.axis(), self.window.border(edge));
        let cut = crossing_at::<R>(&self.segment, axis, border);
        let [[_, free1], [_, free2]] =
            left.map(|[x, y]| split::<R>(Point::from_finite(x, y), axis));
        let free = clamp_between(cut.free, free1, free2);
        let [num, den] = cut.ratio.map(R::get);
        let to = join(axis, R::new(border), free).to_array();
        (to, Ratio { num, den })
    }

    #[inline]
    fn answer(visible: VisibleLine<2>) -> Visible {
        visible.map(segment_of)
    }
}
