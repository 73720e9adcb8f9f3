//! A flat polygon in space against one plane.

use std::slice;

use crate::{
    algo::ring::{Clip, Crossing, Limit, Right, put_in},
    geom::Plane,
    trace::{Real, Told},
};

use super::plane_cut::{PlaneCut, distance, plane_cut};

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
        let PlaneCut { at, t, .. } = cut;
        Some(Crossing { at, t })
    }
}

/// The part of a convex polygon that lies inside of a plane: none of one that only touches it.
#[must_use]
pub fn clipped(polygon: &[[f64; 3]], plane: &Plane) -> Vec<[f64; 3]> {
    let mut left = Vec::with_capacity(polygon.len() + 1);
    let Some((&first, following)) = polygon.split_first() else {
        return left;
    };
    let mut clip = Clip::begin::<Right, f64>(plane, first);
    let Told::Continue(()) = clip.tell_first(plane, &mut put_in(&mut left));
    for &vertex in following {
        let vertex = ([0; 2], vertex);
        let Told::Continue(()) =
            clip.vertex::<Right, f64, _>(plane, vertex, &mut put_in(&mut left));
    }
    let Told::Continue(()) = clip.close::<Right, f64, _>(plane, [0; 2], &mut put_in(&mut left));
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
        let square = [
            [-1.0, -1.0, 0.0],
            [1.0, -1.0, 0.0],
            [1.0, 1.0, 0.0],
            [-1.0, 1.0, 0.0],
        ];
        let plane = Plane::new([2.0, 0.0, 0.0, -1.0]).unwrap();
        let [inside, outside] = split(&square, &plane);
        assert_eq!(
            inside,
            [
                [0.5, -1.0, 0.0],
                [1.0, -1.0, 0.0],
                [1.0, 1.0, 0.0],
                [0.5, 1.0, 0.0]
            ]
        );
        assert_eq!(
            outside,
            [
                [-1.0, -1.0, 0.0],
                [0.5, -1.0, 0.0],
                [0.5, 1.0, 0.0],
                [-1.0, 1.0, 0.0]
            ]
        );
    }

    #[test]
    fn what_touches_the_plane_is_not_cut() {
        let triangle = [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0]];
        let plane = Plane::new([1.0, 0.0, 0.0, 0.0]).unwrap();
        let [inside, outside] = split(&triangle, &plane);
        assert_eq!((inside.len(), outside.len()), (3, 0));
    }
}
