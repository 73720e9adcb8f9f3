//! Clipping a segment against a window: five algorithms, one answer. A program calls [`kernel`], for one segment, or [`batch`], for
//! many.
//!
//! All five promise for any finite numbers: a border coordinate is assigned, never computed, and the other one is clamped into the
//! window; an end that was inside comes back bit for bit; clipping the reversed segment gives the mirror image, bit for bit; clipping
//! again changes nothing; touching in one point is visible, with both ends that point. Where the arithmetic is exact all five give
//! the correctly rounded true answer. Liang–Barsky, Cyrus–Beck and Nicholl–Lee–Nicholl compare exactly, and agree in every bit for any
//! numbers; brute force and Cohen–Sutherland may see a corner an ulp away from where it is.

pub mod batch;
mod brute_force;
mod cohen_sutherland;
pub(super) mod convex_border;
pub(super) mod crossing;
mod cyrus_beck;
pub mod faulty;
pub mod kernel;
mod liang_barsky;
mod nicholl_lee_nicholl;
mod segment_turn;

use crate::geom::{Point, Segment, Window};

use super::segment::{Ends, LineAnswer, VisibleLine};

pub use brute_force::{BruteForce, BruteForceEvent};
pub use cohen_sutherland::{
    BitOrder, CohenSutherland, CohenSutherlandEvent, CohenSutherlandInput, Outcode,
};
pub(crate) use crossing::corner_between;
pub use cyrus_beck::{CyrusBeck, CyrusBeckEvent, CyrusBeckInput, CyrusBeckRow};
pub use liang_barsky::{LiangBarsky, LiangBarskyEvent};
pub use nicholl_lee_nicholl::{
    CornerLine, NichollLeeNicholl, NichollLeeNichollEvent, Question, Turn, WindowRegion,
};
pub use segment_turn::{SegmentTurn, least_move_in, least_move_out};

pub use super::parameter::{End, Param, Ratio};

/// The visible part of a segment; `None` where there is none.
pub type Visible = Option<Segment>;

impl LineAnswer<2> for Visible {
    #[inline]
    fn of(visible: VisibleLine<2>) -> Self {
        visible.map(segment_of)
    }
}

impl End {
    /// The point of `segment` at this end.
    #[must_use]
    pub const fn of(self, segment: &Segment) -> Point {
        match self {
            Self::P1 => segment.p1,
            Self::P2 => segment.p2,
        }
    }
}

/// A window and the segment to clip against it.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct WindowInput {
    /// Closed.
    pub window: Window,
    /// Directed from P₁ to P₂.
    pub segment: Segment,
}

fn segment_between([p1, p2]: [Point; 2]) -> Segment {
    Segment { p1, p2 }
}

#[inline]
fn segment_of(ends: Ends<2>) -> Segment {
    segment_between(ends.map(|[x, y]| Point::from_finite(x, y)))
}

#[inline]
fn ends_of(segment: &Segment) -> Ends<2> {
    [segment.p1, segment.p2].map(Point::to_array)
}
