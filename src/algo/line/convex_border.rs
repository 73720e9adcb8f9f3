//! An edge of a convex polygon as a border: how far both ends of a segment lie inside, d = n·(P − E) in lengths of n, and where
//! the segment crosses, (P₁·d2 − P₂·d1) / (d2 − d1).

use crate::{
    geom::{Axis, ConvexPolygon, HalfPlane, Point, Segment, Wide},
    trace::Real,
};

use super::{
    super::parameter::{clamp_between, weighted_mean},
    End,
    crossing::{on_line, split},
};

#[derive(Clone, Copy)]
pub struct ConvexBorder {
    pub edge_idx: usize,
    pub plane: HalfPlane,
    /// Of both ends of the segment: see [`plane_distances`].
    pub distances: [f64; 2],
}

impl ConvexBorder {
    /// Where the segment crosses it: within the boxes of segment and edge, whatever rounding does.
    pub fn crossing<R: Real>(&self, segment: &Segment, clip: &ConvexPolygon) -> Point {
        let vertices = clip.vertices();
        let i = self.edge_idx;
        let edge = [vertices[i], vertices[(i + 1) % vertices.len()]];
        let origin = self.plane.origin();
        match self.plane.normal() {
            [_, 0.0] => on_line::<R>(segment, Axis::X, origin.x(), edge),
            [0.0, _] => on_line::<R>(segment, Axis::Y, origin.y(), edge),
            _ => {
                let [d1, d2] = self.distances;
                let whole = R::new(d2) - R::new(d1);
                let [x, y] = [Axis::X, Axis::Y].map(|axis| {
                    let of = |p: Point| split::<R>(p, axis)[0];
                    let ends = [of(segment.p1), of(segment.p2)];
                    let mean = weighted_mean(ends, [R::new(-d1), R::new(d2)], whole, [d1, d2, 0.0]);
                    let mean = clamp_between(mean, ends[0], ends[1]);
                    clamp_between(mean, of(edge[0]), of(edge[1])).get()
                });
                Point::from_finite(x, y)
            }
        }
    }
}

/// n·(P − E) for both ends. Where they or their difference are too large, both come scaled by the same power of two: only their
/// ratio counts.
pub fn plane_distances<R: Real>(segment: &Segment, plane: &HalfPlane) -> [R; 2] {
    in_range(segment, plane, told_distances(segment, plane))
}

/// n·(P − E) for both ends, not finite where too large.
pub fn told_distances<R: Real>(segment: &Segment, plane: &HalfPlane) -> [R; 2] {
    let (normal, origin) = (plane.normal(), plane.origin().to_array());
    End::BOTH.map(|end| {
        let p = end.of(segment).to_array();
        let product = |axis: usize| R::new(normal[axis]) * (R::new(p[axis]) - R::new(origin[axis]));
        match normal {
            [_, 0.0] => product(0),
            [0.0, _] => product(1),
            _ => product(0) + product(1),
        }
    })
}

/// Of both ends as they were computed.
pub fn in_range<R: Real>(segment: &Segment, plane: &HalfPlane, distances: [R; 2]) -> [R; 2] {
    let [d1, d2] = distances.map(R::get);
    if (d2 - d1).is_finite() {
        distances
    } else {
        Wide::near_one(told_distances(segment, plane)).0.map(R::new)
    }
}
