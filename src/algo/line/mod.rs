//! Clipping a segment against a window: five algorithms, one answer.
//!
//! What all five promise, whatever finite numbers they are given:
//! a border coordinate is assigned, never computed, and the other one is clamped into the window; an end
//! that was inside comes back bit for bit; clipping the reversed segment gives the mirror image, bit for
//! bit; clipping the answer again changes nothing; no accepted end lies outside the window; touching in
//! one point is visible, with both ends that point. Where the arithmetic is exact (dyadic coordinates of
//! moderate size) all five give the correctly rounded true answer, corners included.
//! `tests/line_exactness` holds them to it.
//!
//! Beyond that, Liang–Barsky, Cyrus–Beck and Nicholl–Lee–Nicholl decide on the ends' distances from the
//! borders, each rounded once, with comparisons that are exact: they agree in every bit for any numbers.
//! Brute force and Cohen–Sutherland decide on the crossings that they have computed, and may see a corner an
//! ulp away from where it is.
//!
//! What a program calls is [`kernel`], for one segment, and [`batch`], for many: Liang–Barsky rearranged for
//! speed, with the same results bit for bit.

pub mod batch;
mod brute_force;
mod closed_form;
mod cohen_sutherland;
pub(super) mod convex_border;
mod corner_line;
pub(super) mod crossing;
mod cyrus_beck;
pub mod kernel;
mod liang_barsky;
mod nicholl_lee_nicholl;
mod outcode;
mod segment_turn;

use crate::geom::{Point, Segment, Window};

pub use brute_force::{BruteForce, BruteForceEvent};
pub use cohen_sutherland::{CohenSutherland, CohenSutherlandEvent, CohenSutherlandInput};
pub use corner_line::{CornerLine, Turn};
pub(crate) use crossing::corner_between;
pub use cyrus_beck::{CyrusBeck, CyrusBeckEvent, CyrusBeckInput, CyrusBeckRow};
pub use liang_barsky::{LiangBarsky, LiangBarskyEvent, WindowRow};
pub use nicholl_lee_nicholl::{NichollLeeNicholl, NichollLeeNichollEvent, Question, WindowRegion};
pub use outcode::{BitOrder, Outcode};
pub use segment_turn::{SegmentTurn, least_move_in, least_move_out};

pub use super::parameter::{End, Param, Ratio};

/// The visible part of a segment; `None` where there is none.
pub type Visible = Option<Segment>;

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

/// The segment between two ends that have been put inside.
fn segment_between([p1, p2]: [Point; 2]) -> Segment {
    Segment { p1, p2 }
}

/// The same by their coordinates.
#[inline]
fn segment_of(ends: [[f64; 2]; 2]) -> Segment {
    segment_between(ends.map(|[x, y]| Point::from_finite(x, y)))
}

/// Both ends by their coordinates.
#[inline]
fn ends_of(segment: &Segment) -> [[f64; 2]; 2] {
    [segment.p1, segment.p2].map(Point::to_array)
}
