//! The two questions that decide everything, over a scalar that counts.

use std::cmp::Ordering;

use crate::{
    geom::{Point, doubtful_area, is_certain, lexicographic},
    trace::Real,
};

/// Twice the area of abc, positive where c is left of ab, with an exact sign. Swapping a and b changes the sign and no other bit.
#[inline]
pub fn side<R: Real>(a: Point, b: Point, c: Point) -> R {
    let [ax, ay, bx, by, cx, cy] = [a.x(), a.y(), b.x(), b.y(), c.x(), c.y()].map(R::new);
    let left = (ax - cx) * (by - cy);
    let right = (ay - cy) * (bx - cx);
    let det = left - right;
    if is_certain(det.get(), left.get(), right.get()) {
        det
    } else {
        // In one order only, so that every bit is the same for both.
        R::new(match lexicographic(a, b) {
            Ordering::Greater => -doubtful_area(b, a, c) + 0.0,
            Ordering::Less | Ordering::Equal => doubtful_area(a, b, c),
        })
    }
}

/// Where a ray from a corner of a border goes. The interior lies to the left.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Ray {
    /// Into the interior.
    Inside,
    /// Away from it.
    Outside,
    /// Along the edge that leaves the corner.
    OnNext,
    /// Back along the edge that comes to it.
    OnPrevious,
}

/// The ray from `at` through `to`, by the border that comes from `previous` and goes on to `next`.
pub fn ray<R: Real>([previous, at, next]: [Point; 3], to: Point) -> Ray {
    let zero = R::new(0.0);
    let same_way = |p: Point| lexicographic(at, p) == lexicographic(at, to);
    let by_next: R = side(at, next, to);
    if by_next == zero && same_way(next) {
        return Ray::OnNext;
    }
    let by_previous: R = side(at, previous, to);
    if by_previous == zero && same_way(previous) {
        return Ray::OnPrevious;
    }
    let turn: R = side(previous, at, next);
    // From the next edge counter-clockwise to the previous one: less than a half turn, or more.
    let inside = if turn > zero {
        by_next > zero && by_previous < zero
    } else if turn < zero {
        by_next > zero || by_previous < zero
    } else {
        by_next > zero
    };
    if inside { Ray::Inside } else { Ray::Outside }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn point([x, y]: [f64; 2]) -> Point {
        Point::new(x, y).unwrap()
    }

    #[test]
    fn eight_rays_at_a_convex_a_straight_and_a_reflex_corner() {
        use Ray::{Inside as I, OnNext as N, OnPrevious as P, Outside as O};
        let around = [
            [1.0, 0.0],
            [1.0, 1.0],
            [0.0, 1.0],
            [-1.0, 1.0],
            [-1.0, 0.0],
            [-1.0, -1.0],
            [0.0, -1.0],
            [1.0, -1.0],
        ];
        let next = [3.0, 0.0];
        let cases = [
            ("convex", [0.0, 3.0], [N, I, P, O, O, O, O, O]),
            ("wide", [-3.0, 3.0], [N, I, I, P, O, O, O, O]),
            ("straight", [-3.0, 0.0], [N, I, I, I, P, O, O, O]),
            ("reflex", [0.0, -3.0], [N, I, I, I, I, I, P, O]),
            ("hardly open", [3.0, -3.0], [N, I, I, I, I, I, I, P]),
        ];
        for (name, previous, expected) in cases {
            let corner = [previous, [0.0, 0.0], next].map(point);
            let found = around.map(|to| ray::<f64>(corner, point(to)));
            assert_eq!(found, expected, "{name}");
        }
    }

    #[test]
    fn a_doubtful_side_changes_its_sign_and_no_other_bit() {
        let [a, b] = [[0.1, 0.1], [0.7, 0.7]].map(point);
        for y in [0.3, 0.3_f64.next_up(), 0.3_f64.next_down()] {
            let c = point([0.3, y]);
            let [there, back]: [f64; 2] = [side(a, b, c), side(b, a, c)];
            assert_eq!(there, -back);
            assert_eq!(there.partial_cmp(&0.0), y.partial_cmp(&0.3), "{y}");
        }
    }
}
