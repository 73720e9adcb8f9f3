//! The one question that all of plane geometry is decided by: which way do three points turn?

use std::cmp::Ordering;

use super::Point;

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

/// 32 bits each, of which 2⁻²¹⁴⁸ is the lowest: with room for the sum of 2⁶⁰ products.
const N_DIGITS: usize = (2148 + 2048) / 32 + 6;

/// Of a ring of fewer than 2²⁹ corners, in integers of thousands of bits: every product of two coordinates is a whole number of
/// 2⁻²¹⁴⁸, below 2²⁰⁴⁸. For the few that leave the range in which expansions are exact, and for rings of next to no area.
fn exact_winding(ring: impl ExactSizeIterator<Item = [f64; 2]> + Clone) -> Ordering {
    let mut sum = [0_i64; N_DIGITS];
    let after = ring.clone().cycle().skip(1);
    for ([px, py], [qx, qy]) in ring.zip(after) {
        add_product(&mut sum, px, qy);
        add_product(&mut sum, -py, qx);
    }
    sign_of_sum(&sum)
}

fn add_product(sum: &mut [i64; N_DIGITS], x: f64, y: f64) {
    let [(mx, ex), (my, ey)] = [x, y].map(parts);
    let mantissa = u128::from(mx) * u128::from(my);
    let negative = (x < 0.0) != (y < 0.0);
    // Both exponents count from the lowest subnormal number.
    let shift = ex + ey;
    for (half, offset) in [(mantissa as u64, 0), ((mantissa >> 64) as u64, 64)] {
        let (first, within) = ((shift + offset) / 32, (shift + offset) % 32);
        let shifted = u128::from(half) << within;
        for k in 0..3 {
            let digit = i64::from((shifted >> (32 * k)) as u32);
            sum[first + k] += if negative { -digit } else { digit };
        }
    }
}

/// |x| as a whole number of 2⁻¹⁰⁷⁴, shifted to the left.
fn parts(x: f64) -> (u64, usize) {
    let bits = x.abs().to_bits();
    let (exponent, fraction) = ((bits >> 52) as usize, bits & ((1 << 52) - 1));
    match exponent {
        0 => (fraction, 0),
        _ => (fraction | 1 << 52, exponent - 1),
    }
}

fn sign_of_sum(sum: &[i64; N_DIGITS]) -> Ordering {
    let (mut carry, mut any) = (0, false);
    for digit in sum {
        let digit = digit + carry;
        any |= digit & 0xffff_ffff != 0;
        carry = digit >> 32;
    }
    match carry {
        ..0 => Ordering::Less,
        0 if !any => Ordering::Equal,
        _ => Ordering::Greater,
    }
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
