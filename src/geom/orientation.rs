//! The one question that all of plane geometry is decided by: which way do three points turn?

use std::cmp::Ordering;

use super::{Point, exact::exact_winding};

/// Sign of the area of abc: `Greater` where c lies to the left of the line from a to b. Exact for any finite
/// numbers.
///
/// The determinant as computed decides where it is larger than its own rounding error; otherwise adaptive
/// expansions do (Shewchuk, Discrete & Computational Geometry 18, 1997, pp. 305–363), and beyond their range long
/// integers.
#[inline]
#[must_use]
pub fn orientation(a: Point, b: Point, c: Point) -> Ordering {
    let left = (a.x() - c.x()) * (b.y() - c.y());
    let right = (a.y() - c.y()) * (b.x() - c.x());
    let det = left - right;
    if is_certain(det, left, right) {
        if det > 0.0 {
            Ordering::Greater
        } else {
            Ordering::Less
        }
    } else {
        adaptive(a, b, c)
    }
}

/// Has `det = left − right` the sign of the exact determinant, where both products were rounded from rounded
/// differences?
///
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
        if area > 0.0 {
            Ordering::Greater
        } else {
            Ordering::Less
        }
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

#[cfg(test)]
mod tests {
    use super::*;

    fn turn(points: [[f64; 2]; 3]) -> Ordering {
        let [a, b, c] = points.map(|[x, y]| Point::new(x, y).unwrap());
        orientation(a, b, c)
    }

    #[test]
    fn one_unit_in_the_last_place_is_seen_at_any_size() {
        for scale in [1e-300, 1e-160, 1e-3, 1.0, 1e8, 1e160, 1e300] {
            let third = |y: f64| [[0.0, 0.0], [3.0, 3.0], [1.5, y]].map(|p| p.map(|x| x * scale));
            let on = 1.5_f64;
            let cases = [
                (on, Ordering::Equal),
                (on.next_up(), Ordering::Greater),
                (on.next_down(), Ordering::Less),
            ];
            for (y, expected) in cases {
                // A scale that is no power of two may round the three alike, never apart.
                let [a, b, c] = third(y);
                let exact = c[1].total_cmp(&c[0]);
                assert_eq!(turn([a, b, c]), exact, "{y} at {scale:e}");
                assert_eq!(turn([b, a, c]), exact.reverse(), "{y} at {scale:e}, turned");
                if scale == 1.0 {
                    assert_eq!(exact, expected);
                }
            }
        }
    }

    #[test]
    fn the_winding_of_a_ring_with_next_to_no_area() {
        let ring = |points: &[[f64; 2]]| -> Vec<Point> {
            points
                .iter()
                .map(|&p| Point::try_from(p).unwrap())
                .collect()
        };
        let third = 1.0 / 3.0;
        let cases = [
            (
                ring(&[[0.0, 0.0], [2.0, 0.0], [2.0, 1.0]]),
                Ordering::Greater,
            ),
            (
                ring(&[[0.1, 0.1], [0.7, 0.7], [third, third]]),
                Ordering::Equal,
            ),
            (
                ring(&[[0.1, 0.1], [0.7, 0.7], [third, third.next_up()]]),
                Ordering::Greater,
            ),
            (
                ring(&[
                    [0.1, 0.1],
                    [0.7, 0.7],
                    [third, third.next_down()],
                    [0.2, 0.2],
                ]),
                Ordering::Less,
            ),
            (
                ring(&[[0.0, 0.0], [1e-300, 0.0], [0.0, 1e-300]]),
                Ordering::Greater,
            ),
            (
                ring(&[[0.0, 0.0], [0.0, 1e300], [1e300, 0.0]]),
                Ordering::Less,
            ),
            (ring(&[[1.0, 2.0], [3.0, 4.0]]), Ordering::Equal),
            (ring(&[]), Ordering::Equal),
        ];
        for (mut ring, expected) in cases {
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
        assert_eq!(
            turn([[-huge, -huge], [huge, -huge], [0.0, huge]]),
            Ordering::Greater
        );
        assert_eq!(
            turn([[-huge, -huge], [huge, huge], [0.0, 0.0]]),
            Ordering::Equal
        );
    }
}
