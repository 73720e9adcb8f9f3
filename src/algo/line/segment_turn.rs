//! How far a segment is from another answer: the least move as a whole along a border's normal that makes it visible, or
//! makes it vanish.
//!
//! ```text
//!      ┌────────┐
//!      │        │   ╱P₂      A convex region and a segment are apart exactly where an edge's normal tells them apart,
//!      │ region │ ╱          or the segment's own. Each of these asks for room + s · slope ≥ 0, and what all of them
//!      │        ╱            allow is an interval of moves s.
//!      └──────╱─┘
//!         P₁╱  ⟵ s ── moved along the deciding border's normal
//! ```
//!
//! 1. An edge with unit normal n rejects the segment where both ends lie beyond it: its room is the larger of both
//!    distances, its slope n·v for a move along v.
//! 2. The segment's line rejects the region where all corners lie on one side of it: twice, once for either side.
//! 3. [`moves_allowed`] has the interval; its end nearer to 0 is the answer.
//!
//! *Conventions*: closed region, normals pointing inside; a move is positive inwards. *Degenerate*: a point has no line of
//! its own; a segment that touches vanishes by any move out. *Cost*: for n edges two distances and two products each, for each
//! direction that is asked. *Source*: the separating axes of two convex sets; S. Gottschalk, M. Lin and D. Manocha, "OBBTree",
//! SIGGRAPH '96, §5. `tests/line_exactness/turns.rs` asks the clippers.
//!
//! ```
//! use clipscope::{algo::line::{SegmentTurn, least_move_in, least_move_out}, geom::{ConvexPolygon, Segment, Window}};
//! let window = ConvexPolygon::from(Window::new(-1.0, -1.0, 1.0, 1.0)?);
//! let planes: Vec<_> = window.half_planes().collect();
//! // The fourth edge is the left one.
//! let outside = Segment::new(-3.0, 0.0, -1.5, 0.5)?;
//! assert_eq!(least_move_in(&planes, window.vertices(), &outside, 3), Some(0.5));
//! let inside = Segment::new(-0.5, -0.5, 0.75, 0.5)?;
//! assert_eq!(
//!     least_move_out(&planes, window.vertices(), &inside),
//!     Some(SegmentTurn { border_idx: 0, by: -1.5 }),
//! );
//! # Ok::<(), clipscope::geom::GeomError>(())
//! ```

use crate::geom::{HalfPlane, Point, Segment};

use super::{super::parameter::moves_allowed, End};

/// A move along a border's normal that turns an answer.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct SegmentTurn {
    /// Which border.
    pub border_idx: usize,
    /// How far: inwards where positive.
    pub by: f64,
}

/// How far a segment that is not visible has to be moved along the normal of a border so that it is; none where no such
/// move helps, or there is no such border.
#[must_use]
pub fn least_move_in(
    planes: &[HalfPlane],
    corners: &[Point],
    segment: &Segment,
    border_idx: usize,
) -> Option<f64> {
    let along = unit(planes.get(border_idx)?.normal());
    let [low, high] = moves_that_meet(planes, corners, segment, along)?;
    let nearest = if low > 0.0 { low } else { high.min(0.0) };
    nearest.is_finite().then_some(nearest)
}

/// The least move outwards across a border, beyond which nothing of a visible segment is left.
#[must_use]
pub fn least_move_out(
    planes: &[HalfPlane],
    corners: &[Point],
    segment: &Segment,
) -> Option<SegmentTurn> {
    let turns = planes.iter().enumerate().filter_map(|(border_idx, plane)| {
        let [low, _] = moves_that_meet(planes, corners, segment, unit(plane.normal()))?;
        let by = low.min(0.0);
        by.is_finite().then_some(SegmentTurn { border_idx, by })
    });
    turns.min_by(|a, b| b.by.total_cmp(&a.by))
}

/// The moves along a direction after which some of the segment lies in the region.
fn moves_that_meet(
    planes: &[HalfPlane],
    corners: &[Point],
    segment: &Segment,
    along: [f64; 2],
) -> Option<[f64; 2]> {
    let by_edges = planes.iter().map(|plane| {
        let normal = unit(plane.normal());
        let distances = End::BOTH.map(|end| dot(normal, between(plane.origin(), end.of(segment))));
        [distances[0].max(distances[1]), dot(normal, along)]
    });
    let [dx, dy] = between(segment.p1, segment.p2);
    let normal = unit([-dy, dx]);
    let sides = corners
        .iter()
        .map(|&corner| dot(normal, between(segment.p1, corner)));
    let [min, max] = sides.fold([f64::INFINITY, f64::NEG_INFINITY], |[min, max], side| {
        [min.min(side), max.max(side)]
    });
    let slope = dot(normal, along);
    moves_allowed(by_edges.chain([[max, -slope], [-min, slope]]))
}

fn between(from: Point, to: Point) -> [f64; 2] {
    [to.x() - from.x(), to.y() - from.y()]
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// Of length 1; zero stays zero.
fn unit(v: [f64; 2]) -> [f64; 2] {
    let length = dot(v, v).sqrt();
    if length > 0.0 {
        v.map(|x| x / length)
    } else {
        v
    }
}
