//! Where an edge crosses the last of some planes, and on which side of it a vertex lies; and a flat polygon against one plane.
//!
//! A crossing is found from the inside end to the outside end, whichever way the edge is walked: two triangles that share the
//! edge get the same bits. On a plane across an axis the coordinate is assigned. Elsewhere it is rounded, and may come to lie
//! outside by an ulp, of this plane or of one before it. Then it is moved inwards until its own distances say that it is inside:
//! so clipping again changes nothing.

use std::slice;

use crate::{
    algo::{
        parameter::{Ratio, Share, clamp_between},
        ring::{Crossing, Limit, pass},
    },
    geom::Plane,
    trace::Real,
};

use super::point_plane::{bounded_sum, is_plain, scaled_sums, signed_distance, weighted_sum};

/// Where an edge crosses.
pub(super) struct PlaneCut<R> {
    pub at: [f64; 3],
    /// How inside and outside end share in it.
    pub share: Share<R>,
    /// From the edge's first end to its second.
    pub t: Ratio,
    /// Is the edge's first end the inside one?
    pub is_leaving: bool,
}

/// n·p + d; beyond the range of f64 the largest or the smallest number, so that the sign is right.
#[inline]
pub(super) fn distance<R: Real>(plane: &Plane, p: [f64; 3]) -> R {
    let sum = weighted_sum::<R>(plane, p);
    if is_plain(sum.get()) {
        sum
    } else {
        R::new(bounded_sum(plane, p))
    }
}

/// The distance of a vertex, in lengths of 1, from n·p + d as [`distance`] has it.
#[inline]
pub(super) fn told(plane: &Plane, p: [f64; 3], distance: f64) -> f64 {
    if distance == 0.0 || is_plain(distance) && distance.abs() < f64::MAX {
        distance / plane.length()
    } else {
        signed_distance(plane, p)
    }
}

/// An edge's ends and their distances, the inside end first.
#[inline]
pub(super) fn inside_first<E, R: Real>([a, b]: [E; 2], [d1, d2]: [R; 2]) -> ([E; 2], [R; 2]) {
    let is_leaving = d1.get() > 0.0;
    if is_leaving {
        ([a, b], [d1, d2])
    } else {
        ([b, a], [d2, d1])
    }
}

/// Where the edge between `ends`, of which one lies strictly inside of the last of `planes` and the other outside, crosses that
/// plane; `None` where rounding puts the crossing on the inside end itself.
pub(super) fn plane_cut<R: Real>(
    planes: &[Plane],
    ends: [[f64; 3]; 2],
    distances: [R; 2],
) -> Option<PlaneCut<R>> {
    let plane = planes.last()?;
    let is_leaving = distances[0].get() > 0.0;
    let ([inside, outside], along) = inside_first(ends, distances);
    let share = share(plane, [inside, outside], along);
    let mut at = std::array::from_fn(|i| share.mean(inside[i], outside[i]));
    let assigned = across(plane);
    if let Some(axis) = assigned {
        let border = -plane.d() / plane.normal()[axis];
        at[axis] = clamp_between(border, inside[axis], outside[axis]);
    }
    let at = settled(planes, at, assigned, inside);
    let t = share.ratio(is_leaving);
    (at != inside).then_some(PlaneCut {
        at,
        share,
        t,
        is_leaving,
    })
}

/// By the ends' distances, by both times a power of two where these or their difference leave the range of f64.
fn share<R: Real>(plane: &Plane, ends: [[f64; 3]; 2], distances: [R; 2]) -> Share<R> {
    let is_plain = |d: R| is_plain(d.get()) && d.get().abs() < f64::MAX;
    let whole = distances[0] - distances[1];
    let [d1, d2] = if distances.into_iter().all(is_plain) && is_plain(whole) {
        distances
    } else {
        scaled_sums(plane, ends).map(R::new)
    };
    Share {
        weights: [d1, -d2],
        whole: d1 - d2,
        raw: [-d1.get(), -d2.get(), 0.0],
    }
}

/// The only axis along which the normal points.
fn across(plane: &Plane) -> Option<usize> {
    match plane.normal() {
        [_, 0.0, 0.0] => Some(0),
        [0.0, _, 0.0] => Some(1),
        [0.0, 0.0, _] => Some(2),
        _ => None,
    }
}

/// Moves a crossing that some planes have outside inwards, by as much as it is outside and a few roundings more, until none has.
///
/// Where planes meet at an acute angle the way in of one leads out of another: so every plane that objects turns the direction by
/// its own normal (as Rosenblatt's perceptron does). Of planes with no room between them the inside end is left.
fn settled(
    planes: &[Plane],
    crossing: [f64; 3],
    assigned: Option<usize>,
    inside: [f64; 3],
) -> [f64; 3] {
    // In random scenes six rounds are the most.
    const ROUNDS: i32 = 32;
    const DOUBLINGS: i32 = 8;
    let (mut at, mut along, mut far) = (crossing, [0.0; 3], 0.0_f64);
    for round in 0..=ROUNDS {
        let mut is_inside = true;
        for plane in planes {
            if distance::<f64>(plane, at) >= 0.0 {
                continue;
            }
            is_inside = false;
            far = far.max(outside_by(plane, crossing));
            let is_held = |axis| assigned == Some(axis) && across(plane).is_none();
            for (axis, n) in plane.unit_normal().into_iter().enumerate() {
                along[axis] += if is_held(axis) { 0.0 } else { n };
            }
        }
        if is_inside {
            return at;
        }
        let by = far * 2f64.powi(round.min(DOUBLINGS));
        if !by.is_finite() {
            break;
        }
        at = std::array::from_fn(|i| (crossing[i] + by * along[i]).clamp(f64::MIN, f64::MAX));
    }
    inside
}

/// How far a point is outside of a plane, and how far its rounded coordinates may be.
fn outside_by(plane: &Plane, at: [f64; 3]) -> f64 {
    let n = plane.normal();
    let size: f64 = (0..3).map(|i| (n[i] * at[i]).abs()).sum();
    let roundings = f64::EPSILON * (size + plane.d().abs());
    if is_plain(roundings) {
        return (roundings - distance::<f64>(plane, at).min(0.0)) / plane.length();
    }
    let unit = plane.unit_normal();
    let size: f64 = (0..3).map(|i| (unit[i] * f64::EPSILON * at[i]).abs()).sum();
    let roundings = size + f64::EPSILON * (plane.d() / plane.length()).abs();
    roundings - signed_distance::<f64>(plane, at).min(0.0)
}

impl Limit<[f64; 3]> for Plane {
    #[inline]
    fn distance<R: Real>(&self, vertex: &[f64; 3]) -> R {
        distance(self, *vertex)
    }

    #[inline]
    fn crossing<R: Real>(
        &self,
        ends: [&[f64; 3]; 2],
        distances: [R; 2],
    ) -> Option<Crossing<[f64; 3]>> {
        let cut = plane_cut(slice::from_ref(self), ends.map(|&end| end), distances)?;
        Some(Crossing {
            at: cut.at,
            t: cut.t,
        })
    }
}

/// The part of a convex polygon that lies inside of a plane: none of one that only touches it.
#[must_use]
pub fn clipped(polygon: &[[f64; 3]], plane: &Plane) -> Vec<[f64; 3]> {
    let mut left = Vec::with_capacity(polygon.len() + 1);
    pass(plane, polygon, &mut left);
    if left.len() < 3 {
        left.clear();
    }
    left
}

/// A convex polygon in two: what lies inside of a plane, and what lies outside. What is on the plane belongs to both.
#[must_use]
pub fn split(polygon: &[[f64; 3]], plane: &Plane) -> [Vec<[f64; 3]>; 2] {
    [*plane, plane.turned()].map(|plane| clipped(polygon, &plane))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_parts_of_a_square_meet_in_the_cut() {
        let between = |left: f64, right: f64| {
            let corners = [[left, -1.0], [right, -1.0], [right, 1.0], [left, 1.0]];
            corners.map(|[x, y]| [x, y, 0.0])
        };
        let plane = Plane::new([2.0, 0.0, 0.0, -1.0]).unwrap();
        let [inside, outside] = split(&between(-1.0, 1.0), &plane);
        assert_eq!(inside, between(0.5, 1.0));
        assert_eq!(outside, between(-1.0, 0.5));
    }

    #[test]
    fn what_touches_the_plane_is_not_cut() {
        let triangle = [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0]];
        let plane = Plane::new([1.0, 0.0, 0.0, 0.0]).unwrap();
        let [inside, outside] = split(&triangle, &plane);
        assert_eq!((inside.len(), outside.len()), (3, 0));
    }
}
