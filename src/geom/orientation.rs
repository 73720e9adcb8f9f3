//! The one question that all of plane geometry is decided by: which way do three points turn?

use std::cmp::Ordering;

use super::{
    Point,
    long_sum::LongSum,
    power::{exponent, times_power},
};

/// Sign of the area of abc: `Greater` where c lies to the left of the line from a to b. Exact for any finite numbers: the
/// determinant as computed decides where it is larger than its own rounding error; otherwise adaptive expansions do (Shewchuk,
/// Discrete & Computational Geometry 18, 1997, pp. 305–363), and beyond their range long integers.
#[inline]
#[must_use]
pub fn orientation(a: Point, b: Point, c: Point) -> Ordering {
    let left = (a.x() - c.x()) * (b.y() - c.y());
    let right = (a.y() - c.y()) * (b.x() - c.x());
    let det = left - right;
    if is_certain(det, left, right) {
        sign_of(det)
    } else {
        adaptive(a, b, c)
    }
}

/// Of a number that is not 0.
#[inline]
const fn sign_of(x: f64) -> Ordering {
    if x > 0.0 {
        Ordering::Greater
    } else {
        Ordering::Less
    }
}

/// Has `det = left − right` the sign of the exact determinant, both products being rounded from rounded differences?
/// Shewchuk's bound is (3 + 16ε)ε (|left| + |right|) with ε = 2⁻⁵³; the constant is a little more than that.
/// Below 2⁻⁹⁰⁰ a product's rounding error may be absolute, and what overflows compares false.
#[inline]
#[must_use]
pub fn is_certain(det: f64, left: f64, right: f64) -> bool {
    let size = left.abs() + right.abs();
    det.abs() > 3.4e-16 * size && size > 2f64.powi(-900) && size < f64::INFINITY
}

#[cold]
fn adaptive(a: Point, b: Point, c: Point) -> Ordering {
    let points = [a, b, c].map(Point::to_array);
    // Between these, neither a product of differences nor any of its tails overflows or vanishes.
    let plain = 2f64.powi(-300)..=2f64.powi(300);
    let is_plain = |x: &f64| *x == 0.0 || plain.contains(&x.abs());
    if !points.as_flattened().iter().all(is_plain) {
        return exact_winding(points.into_iter());
    }
    let [a, b, c] = points.map(|[x, y]| robust::Coord { x, y });
    let area = robust::orient2d(a, b, c);
    area.partial_cmp(&0.0).unwrap_or(Ordering::Equal)
}

/// Twice the signed area of abc, where as computed it may have the wrong sign or has left the range of f64. The sign is exact:
/// infinite is what is larger than any number, and 0 only what has no area.
#[cold]
#[must_use]
pub fn doubtful_area(a: Point, b: Point, c: Point) -> f64 {
    let sign = match orientation(a, b, c) {
        Ordering::Equal => return 0.0,
        Ordering::Greater => 1.0,
        Ordering::Less => -1.0,
    };
    let points = [a, b, c].map(Point::to_array);
    let largest = exponent(points.as_flattened());
    let by = if (-300..300).contains(&largest) {
        0
    } else {
        // One more, so that no difference overflows.
        largest + 1
    };
    let [a, b, c] = points.map(|p| {
        let [x, y] = times_power(p, -by);
        robust::Coord { x, y }
    });
    let [size] = times_power([robust::orient2d(a, b, c).abs()], 2 * by);
    size.max(f64::MIN_POSITIVE).copysign(sign)
}

/// Sign of the area that a ring runs around, `Greater` for counter-clockwise. Exact, whatever its shape.
#[must_use]
pub fn winding(ring: &[Point]) -> Ordering {
    let Some(&origin) = ring.first() else {
        return Ordering::Equal;
    };
    let (mut area, mut size) = (0.0, 0.0);
    for pair in ring.windows(2) {
        let [[px, py], [qx, qy]] =
            [pair[0], pair[1]].map(|p| [p.x() - origin.x(), p.y() - origin.y()]);
        let (left, right) = (px * qy, py * qx);
        area += left - right;
        size += left.abs() + right.abs();
    }
    // Each term has three roundings and each sum one.
    let error = (ring.len() + 4) as f64 * f64::EPSILON * size;
    if area.abs() > error && size > 2f64.powi(-900) && size < f64::INFINITY {
        sign_of(area)
    } else {
        exact_winding(ring.iter().map(|p| p.to_array()))
    }
}

/// By x, then by y: along any line the order in which a walk in one direction meets its points.
#[inline]
#[must_use]
pub fn lexicographic(a: Point, b: Point) -> Ordering {
    (a.x(), a.y())
        .partial_cmp(&(b.x(), b.y()))
        .unwrap_or(Ordering::Equal)
}

/// Of a ring of fewer than 2²⁹ corners. For the few that leave the range in which expansions are exact, and for rings of next to no
/// area.
fn exact_winding(ring: impl ExactSizeIterator<Item = [f64; 2]> + Clone) -> Ordering {
    let mut sum = LongSum::zero();
    let after = ring.clone().cycle().skip(1);
    for ([px, py], [qx, qy]) in ring.zip(after) {
        sum.add([px, qy]);
        sum.add([-py, qx]);
    }
    sum.sign()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geom::random_bits;

    #[test]
    fn it_agrees_with_expansions_where_they_are_exact() {
        let mut bits = random_bits(7);
        let mut next = || ((bits() >> 33) % 9) as f64;
        for scale in [1.0, 0.1, 1e-9, 1e20] {
            for _ in 0..20_000 {
                let points = [(); 3].map(|()| [next() * scale, next() * scale]);
                let [a, b, c] = points.map(|[x, y]| robust::Coord { x, y });
                let expected = robust::orient2d(a, b, c).partial_cmp(&0.0).unwrap();
                assert_eq!(exact_winding(points.into_iter()), expected, "{points:?}");
            }
        }
    }

    #[test]
    fn neither_the_largest_nor_the_smallest_numbers_are_lost() {
        let (max, min) = (f64::MAX, 5e-324);
        let (zero, low, high) = ([0.0; 2], [-max; 2], [max; 2]);
        let cases = [
            ([low, high, zero], Ordering::Equal),
            ([low, high, [0.0, min]], Ordering::Greater),
            ([low, high, [min, 0.0]], Ordering::Less),
            ([zero, [min, 0.0], [0.0, min]], Ordering::Greater),
            ([zero, [min, min], high], Ordering::Equal),
            ([zero, [min, min], [max, max.next_down()]], Ordering::Less),
        ];
        for (points, expected) in cases {
            assert_eq!(exact_winding(points.into_iter()), expected, "{points:?}");
            let [a, b, c] = points;
            let turned = exact_winding([b, a, c].into_iter());
            assert_eq!(turned, expected.reverse(), "{points:?}, turned");
        }
    }
    fn turn(points: [[f64; 2]; 3]) -> Ordering {
        let [a, b, c] = points.map(|[x, y]| Point::new(x, y).unwrap());
        orientation(a, b, c)
    }

    #[test]
    fn one_unit_in_the_last_place_is_seen_at_any_size() {
        for scale in [1e-300, 1e-160, 1e-3, 1.0, 1e8, 1e160, 1e300] {
            let on = 1.5_f64;
            for y in [on, on.next_up(), on.next_down()] {
                // A scale that is no power of two may round the three alike, never apart.
                let [a, b, c] = [[0.0, 0.0], [3.0, 3.0], [on, y]].map(|p| p.map(|x| x * scale));
                let exact = c[1].total_cmp(&c[0]);
                assert_eq!(turn([a, b, c]), exact, "{y} at {scale:e}");
                assert_eq!(turn([b, a, c]), exact.reverse(), "{y} at {scale:e}, turned");
                if scale == 1.0 {
                    assert_eq!(exact, y.total_cmp(&on));
                }
            }
        }
    }

    #[test]
    fn the_winding_of_a_ring_with_next_to_no_area() {
        use Ordering::{Equal, Greater, Less};
        let third = 1.0_f64 / 3.0;
        let (a, b) = ([0.1, 0.1], [0.7, 0.7]);
        let below = [third, third.next_down()];
        let cases: [(&[[f64; 2]], Ordering); 8] = [
            (&[[0.0, 0.0], [2.0, 0.0], [2.0, 1.0]], Greater),
            (&[a, b, [third, third]], Equal),
            (&[a, b, [third, third.next_up()]], Greater),
            (&[a, b, below, [0.2, 0.2]], Less),
            (&[[0.0, 0.0], [1e-300, 0.0], [0.0, 1e-300]], Greater),
            (&[[0.0, 0.0], [0.0, 1e300], [1e300, 0.0]], Less),
            (&[[1.0, 2.0], [3.0, 4.0]], Equal),
            (&[], Equal),
        ];
        let point = |&p: &[f64; 2]| Point::try_from(p).unwrap();
        for (ring, expected) in cases {
            let mut ring: Vec<Point> = ring.iter().map(point).collect();
            for _ in 0..ring.len().max(1) {
                assert_eq!(winding(&ring), expected, "{ring:?}");
                if !ring.is_empty() {
                    ring.rotate_left(1);
                }
            }
        }
    }

    #[test]
    fn differences_that_overflow_are_no_matter() {
        let huge = f64::MAX;
        let around = [[-huge, -huge], [huge, -huge], [0.0, huge]];
        assert_eq!(turn(around), Ordering::Greater);
        assert_eq!(turn([[-huge; 2], [huge; 2], [0.0; 2]]), Ordering::Equal);
    }
}
