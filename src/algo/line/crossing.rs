//! Where a segment crosses a border, and which of two crossings comes first.
//!
//! With `d1` and `d2` the signed distances of P₁ and P₂ from a border line (inside positive), the line
//! P(u) = P₁ + u (P₂ − P₁) meets it at
//!
//! ```text
//!   P₁ ●───── d1 ─────┊──── d2 ────● P₂          u = d1 / (d1 − d2)
//!                  border
//! ```
//!
//! Two rules make the answers exact where exactness can be had, and the same from both ends everywhere:
//!
//! - The free coordinate of a crossing is the weighted mean `(o1·(a2 − c) + o2·(c − a1)) / (a2 − a1)`.
//!   Swapping the ends negates numerator and denominator, so that the quotient keeps every bit; and where
//!   products and sum are exact, the one rounding left is the division's. `o1 + u·(o2 − o1)` has neither
//!   property.
//! - Which of two crossings comes first is decided on the distances: `u < u'` is a comparison of two
//!   products, done exactly. Quotients that round to the same number decide nothing.

use std::cmp::Ordering;

use serde::Serialize;

use crate::{
    geom::{Axis, Edge, Point, Segment, Window},
    trace::Real,
};

use super::End;

/// Differences beyond this range, or products of such, could overflow or lose bits to underflow: they
/// are scaled first. 2⁵⁰⁰ squared is still finite, and nothing on a screen comes near either limit.
const PLAIN: std::ops::RangeInclusive<f64> = 3.054_936_363_499_605e-151..=3.273_390_607_896_142e150;

/// A quotient kept as the two numbers that it was computed from, so that it can be shown as a fraction.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
pub struct Ratio {
    /// Numerator.
    pub num: f64,
    /// Denominator.
    pub den: f64,
}

/// Where the line through a segment meets a border: `axis` coordinate `c`, the other one computed.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Crossing<R> {
    /// The coordinate that the border does not fix. It lies between the ends' coordinates, up to
    /// rounding, where the segment reaches across the border.
    pub free: R,
    /// `c − a1` over `a2 − a1`: the parameter u.
    pub ratio: [R; 2],
}

/// Splits a point into the coordinate along `axis` and the other one.
pub fn split<R: Real>(point: Point, axis: Axis) -> [R; 2] {
    match axis {
        Axis::X => [R::new(point.x()), R::new(point.y())],
        Axis::Y => [R::new(point.y()), R::new(point.x())],
    }
}

/// The point with coordinate `c` along `axis` and `free` on the other.
pub fn join<R: Real>(axis: Axis, c: R, free: R) -> Point {
    match axis {
        Axis::X => Point::from_finite(c.get(), free.get()),
        Axis::Y => Point::from_finite(free.get(), c.get()),
    }
}

/// Meets the line through `segment` with the line of `edge`. Must not be parallel to it.
pub fn crossing<R: Real>(segment: &Segment, window: &Window, edge: Edge) -> Crossing<R> {
    let [a1, o1] = split::<R>(segment.p1, edge.axis());
    let [a2, o2] = split::<R>(segment.p2, edge.axis());
    let c = R::new(window.border(edge));
    let (w1, w2, whole) = (c - a1, a2 - c, a2 - a1);
    Crossing {
        free: weighted_mean(o1, o2, w1, w2, whole, [a1.get(), a2.get(), c.get()]),
        ratio: [w1, whole],
    }
}

/// `(o1·w2 + o2·w1) / whole`, where `w1 = c − a1`, `w2 = a2 − c` and `whole = a2 − a1 ≠ 0`.
#[inline]
pub fn weighted_mean<R: Real>(o1: R, o2: R, w1: R, w2: R, whole: R, raw: [f64; 3]) -> R {
    let sum = o1 * w2 + o2 * w1;
    if PLAIN.contains(&whole.get().abs()) && sum.get().is_finite() {
        sum / whole
    } else {
        R::new(scaled_mean(o1.get(), o2.get(), raw))
    }
}

/// [`weighted_mean`] for coordinates whose differences or products leave the range of f64.
#[cold]
fn scaled_mean(o1: f64, o2: f64, [a1, a2, c]: [f64; 3]) -> f64 {
    // Halves cannot overflow when subtracted; tiny differences are made large. Both scales are powers
    // of two, and the same from both ends.
    let scale = if (a2 - a1).abs() < 1.0 {
        2f64.powi(500)
    } else {
        0.5
    };
    let [a1, a2, c] = [a1, a2, c].map(|x| x * scale);
    let whole = a2 - a1;
    let mean = o1 * ((a2 - c) / whole) + o2 * ((c - a1) / whole);
    if mean.is_nan() {
        // The border is so far outside the segment that its crossing has no coordinate.
        o1.midpoint(o2)
    } else {
        mean.clamp(f64::MIN, f64::MAX)
    }
}

/// Keeps `x` between two bounds in either order.
#[inline]
pub fn clamp_between<R: Real>(x: R, bound: R, other: R) -> R {
    let (low, high) = if bound < other {
        (bound, other)
    } else {
        (other, bound)
    };
    if x < low {
        low
    } else if x > high {
        high
    } else {
        x
    }
}

/// A value of the parameter u: one of the ends, or the crossing with a border.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Param<R> {
    /// The quotient, as computed.
    pub u: R,
    /// The border that it belongs to; `None` for an end of the segment.
    pub edge: Option<Edge>,
    /// Does the line go outside here (`p > 0`), as it does at P₂?
    pub leaving: bool,
}

impl<R: Real> Param<R> {
    /// u = 0 at P₁, which the line enters by; u = 1 at P₂.
    pub fn at_end(end: End) -> Self {
        Self {
            u: R::new(if end == End::P1 { 0.0 } else { 1.0 }),
            edge: None,
            leaving: end == End::P2,
        }
    }

    /// Signed distances of both ends from the border, inside positive; for an end of the segment those
    /// of a border through it, square to the segment, which has length 1.
    fn distances(&self, segment: &Segment, window: &Window) -> [f64; 2] {
        match self.edge {
            None if self.leaving => [1.0, 0.0],
            None => [0.0, 1.0],
            Some(edge) => signed_distances(segment, window, edge),
        }
    }

    /// Is this parameter strictly less than `other`? Exact: see the module's second rule.
    pub fn is_before(&self, other: &Self, segment: &Segment, window: &Window) -> bool {
        let before = self.u < other.u;
        let (u, v) = (self.u.get(), other.u.get());
        // A quotient is within 1.5 ulp of the ratio of the distances: farther apart than 4 they cannot
        // have changed places. Below 2⁻⁹⁰⁰ an ulp is no longer relative.
        let largest = u.abs().max(v.abs());
        if (u - v).abs() > 4.0 * f64::EPSILON * largest && largest > 2f64.powi(-900) {
            return before;
        }
        let [a1, a2] = self.distances(segment, window);
        let [b1, b2] = other.distances(segment, window);
        let order = compare_products([a1, b2], [b1, a2]);
        if self.leaving == other.leaving {
            order == Ordering::Greater
        } else {
            order == Ordering::Less
        }
    }
}

/// Distances of P₁ and P₂ from a border, inside positive. One rounding each, and none in their signs.
pub fn signed_distances(segment: &Segment, window: &Window, edge: Edge) -> [f64; 2] {
    let c = window.border(edge);
    End::BOTH.map(|end| {
        let [a, _] = split::<f64>(end.of(segment), edge.axis());
        if edge.is_max() { c - a } else { a - c }
    })
}

/// Compares `a·b` with `c·d` exactly.
///
/// Rounding is monotone: where the rounded products differ, the true ones differ the same way, overflow
/// and underflow included. Only equal ones need their full 106 bits.
#[inline]
pub fn compare_products([a, b]: [f64; 2], [c, d]: [f64; 2]) -> Ordering {
    match (a * b).partial_cmp(&(c * d)) {
        Some(Ordering::Equal) | None => compare_products_exactly([a, b], [c, d]),
        Some(order) => order,
    }
}

#[cold]
fn compare_products_exactly(ab: [f64; 2], cd: [f64; 2]) -> Ordering {
    let sign = |[a, b]: [f64; 2]| {
        if a == 0.0 || b == 0.0 {
            0
        } else if (a < 0.0) == (b < 0.0) {
            1
        } else {
            -1
        }
    };
    let (sign_ab, sign_cd) = (sign(ab), sign(cd));
    let magnitudes = || magnitude(ab).cmp(&magnitude(cd));
    sign_ab.cmp(&sign_cd).then_with(|| match sign_ab {
        1 => magnitudes(),
        -1 => magnitudes().reverse(),
        _ => Ordering::Equal,
    })
}

/// |a·b| as an exponent and 128 bits with the topmost set: ordered like the products. An infinite factor
/// (a distance that overflowed) counts as 2¹⁰²⁴, above every finite one.
fn magnitude([a, b]: [f64; 2]) -> (i32, u128) {
    let [(ma, ea), (mb, eb)] = [a, b].map(|x| {
        let bits = x.abs().to_bits();
        let exponent = (bits >> 52) as i32;
        let fraction = bits & ((1 << 52) - 1);
        // A subnormal number has no hidden bit, and the exponent of the smallest normal one.
        if exponent == 0 {
            (fraction, 1)
        } else {
            (fraction | 1 << 52, exponent)
        }
    });
    let product = u128::from(ma) * u128::from(mb);
    let shift = product.leading_zeros();
    (ea + eb - shift as i32, product << shift)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn segment(s: [f64; 4]) -> Segment {
        Segment::try_from(s).unwrap()
    }

    #[test]
    fn products_are_compared_beyond_their_rounding() {
        let x = 1.0 + f64::EPSILON;
        // (1 + ε)² = 1 + 2ε + ε², whose rounding drops ε².
        assert_eq!(x * x, 1.0 + 2.0 * f64::EPSILON);
        let cases = [
            ([x, x], [1.0 + 2.0 * f64::EPSILON, 1.0], Ordering::Greater),
            ([-x, x], [1.0 + 2.0 * f64::EPSILON, -1.0], Ordering::Less),
            ([1e-300, 1e-300], [1e-300, 1.1e-300], Ordering::Less),
            ([1e300, 1e300], [1.1e300, 1e300], Ordering::Less),
            ([-1e300, 1e300], [1e300, 1e300], Ordering::Less),
            ([0.0, 1e300], [-0.0, 1.0], Ordering::Equal),
            ([5e-324, 0.5], [5e-324, 0.5], Ordering::Equal),
            ([5e-324, 0.25], [5e-324, 0.5], Ordering::Less),
            ([3.0, 7.0], [21.0, 1.0], Ordering::Equal),
        ];
        for (ab, cd, expected) in cases {
            assert_eq!(compare_products(ab, cd), expected, "{ab:?} against {cd:?}");
            assert_eq!(
                compare_products(cd, ab),
                expected.reverse(),
                "{cd:?} against {ab:?}"
            );
        }
    }

    #[test]
    fn a_crossing_is_the_same_from_both_ends() {
        let window = Window::new(-1.0, -1.0, 1.0, 1.0).unwrap();
        for s in [
            [-2.0, -1.0, 2.0, 1.5],
            [-0.1, 0.3, 0.7, 0.9],
            [-1e308, -3.0, 1.5e308, 7.0],
            [-1e-310, 2e-310, 3e-310, -1.0],
        ] {
            let s = segment(s);
            for edge in Edge::ALL {
                let [there, back] =
                    [s, s.reversed()].map(|s| crossing::<f64>(&s, &window, edge).free);
                assert_eq!(there.to_bits(), back.to_bits(), "{edge:?} of {s:?}");
            }
        }
    }

    #[test]
    fn huge_coordinates_do_not_overflow() {
        let window = Window::new(-1.0, -1.0, 1.0, 1.0).unwrap();
        let s = segment([-1.5e308, -1.5e308, 1.5e308, 1.5e308]);
        let free = crossing::<f64>(&s, &window, Edge::Left).free;
        assert!(
            free.abs() <= 1e293,
            "{free} is far from −1 only by rounding"
        );
    }

    #[test]
    fn tiny_coordinates_do_not_vanish() {
        let window = Window::new(-1e-200, -1e-200, 1e-200, 1e-200).unwrap();
        let s = segment([-2e-200, -2e-200, 2e-200, 2e-200]);
        let free = crossing::<f64>(&s, &window, Edge::Left).free;
        assert!((free + 1e-200).abs() < 1e-215, "{free}");
    }
}
