//! How far a segment is from another answer: the least move as a whole along a border's normal that makes it visible, or makes it
//! vanish. A move is positive inwards; what touches vanishes by any move out.
//!
//! A convex region and a segment are apart exactly where an edge's normal tells them apart, or the segment's own (S. Gottschalk,
//! M. Lin and D. Manocha, "OBBTree", SIGGRAPH '96, §5). Each of these bounds the move, and of the interval that all allow the end
//! nearer to 0 is the answer. *Cost*: for n edges two distances and two products each, for each direction asked.
//!
//! ```
//! use clipscope::{algo::line::{SegmentTurn, least_move_in, least_move_out}, geom::{ConvexPolygon, Segment, Window}};
//! let window = ConvexPolygon::from(Window::new(-1.0, -1.0, 1.0, 1.0)?);
//! let planes: Vec<_> = window.half_planes().collect();
//! // The fourth edge is the left one.
//! let outside = Segment::new(-3.0, 0.0, -1.5, 0.5)?;
//! assert_eq!(least_move_in(&planes, window.vertices(), &outside, 3), Some(0.5));
//! let inside = Segment::new(-0.5, -0.5, 0.75, 0.5)?;
//! let out = least_move_out(&planes, window.vertices(), &inside);
//! assert_eq!(out, Some(SegmentTurn { border_idx: 0, by: -1.5 }));
//! # Ok::<(), clipscope::geom::GeomError>(())
//! ```

use crate::geom::{HalfPlane, Point, Segment};

use super::{
    super::parameter::{least_move, moves_allowed, nearest_move},
    End,
};

/// A move along a border's normal that turns an answer.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct SegmentTurn {
    /// Which border.
    pub border_idx: usize,
    /// How far: inwards where positive.
    pub by: f64,
}

/// How far a segment that is not visible has to be moved along a border's normal so that it is; none where that is no help.
#[must_use]
pub fn least_move_in(
    planes: &[HalfPlane],
    corners: &[Point],
    segment: &Segment,
    border_idx: usize,
) -> Option<f64> {
    let along = unit(planes.get(border_idx)?.normal());
    nearest_move(moves_that_meet(planes, corners, segment, along)?)
}

/// The least move outwards across a border, beyond which nothing of a visible segment is left.
#[must_use]
pub fn least_move_out(
    planes: &[HalfPlane],
    corners: &[Point],
    segment: &Segment,
) -> Option<SegmentTurn> {
    let moves = |plane: &HalfPlane| moves_that_meet(planes, corners, segment, unit(plane.normal()));
    let borders = planes.iter().enumerate().rev();
    let (border_idx, by) = least_move(borders.map(|(idx, plane)| (idx, moves(plane))))?;
    Some(SegmentTurn { border_idx, by })
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
    let side = |&corner: &Point| dot(normal, between(segment.p1, corner));
    let sides = corners.iter().map(side);
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
    v.map(|x| if length > 0.0 { x / length } else { x })
}
