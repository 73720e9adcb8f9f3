//! Which of two crossings comes first, exactly.
//!
//! With `a1` and `a2` the signed distances of P₁ and P₂ from one border (inside positive), `b1` and `b2` those from another, the
//! crossings lie at `u = a1 / (a1 − a2)` and `v = b1 / (b1 − b2)`. Multiplied out, u < v where a1·b2 > b1·a2 if the line enters
//! by both or leaves by both, and where a1·b2 < b1·a2 else. Quotients that round to the same number decide nothing, and as a
//! border's two distances change places when the segment is reversed, both directions decide alike.

use std::cmp::Ordering;

use crate::trace::Real;

use super::End;

/// A value of the parameter: one of the ends, or the crossing with a border `B`.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Param<R, B> {
    /// The quotient, as computed.
    pub u: R,
    /// The border that it belongs to; `None` for an end of the segment.
    pub border: Option<B>,
    /// Does the line go outside here, as it does at P₂?
    pub leaving: bool,
}

impl<R: Real, B: Copy> Param<R, B> {
    /// u = 0 at P₁, which the line enters by; u = 1 at P₂.
    #[must_use]
    pub fn at_end(end: End) -> Self {
        Self {
            u: R::new(if end == End::P1 { 0.0 } else { 1.0 }),
            border: None,
            leaving: end == End::P2,
        }
    }

    /// Signed distances of both ends from the border, inside positive: they grow from P₁ to P₂ where the line
    /// enters. For an end of the segment those from a border through it, square to the segment, which has length 1.
    fn distances(&self, of_border: impl Fn(B) -> [f64; 2]) -> [f64; 2] {
        match self.border {
            None if self.leaving => [1.0, 0.0],
            None => [0.0, 1.0],
            Some(border) => of_border(border),
        }
    }

    /// Which of two parameters comes first? Exact. `distances` gives a border's signed distances from both ends.
    // Compiled into each place that asks, it makes Liang–Barsky slower (BENCHMARKS.md).
    #[inline(never)]
    pub fn compare(&self, other: &Self, distances: impl Fn(B) -> [f64; 2]) -> Ordering {
        let quotients = self.u.partial_cmp(&other.u);
        let (u, v) = (self.u.get(), other.u.get());
        // A quotient is within 1.5 ulp of the ratio of the distances: farther apart than 4 they cannot
        // have changed places. Below 2⁻⁹⁰⁰ an ulp is no longer relative.
        let largest = u.abs().max(v.abs());
        let far_apart = (u - v).abs() > 4.0 * f64::EPSILON * largest;
        match quotients {
            Some(order) if far_apart && largest > 2f64.powi(-900) => order,
            _ => self.compare_distances(other, distances),
        }
    }

    #[cold]
    fn compare_distances(&self, other: &Self, distances: impl Fn(B) -> [f64; 2]) -> Ordering {
        let [[a1, a2], [b1, b2]] = [self, other].map(|param| param.distances(&distances));
        // u = d1 / (d1 − d2): the denominator is negative where the line enters.
        let order = compare_products([a1, b2], [b1, a2]);
        let are_alike = self.leaving == other.leaving;
        if are_alike { order.reverse() } else { order }
    }
}

/// Compares `a·b` with `c·d` exactly. Rounding is monotone: where the rounded products differ, the true ones differ the same way,
/// overflow and underflow included. Only equal ones need their full 106 bits.
#[inline]
pub fn compare_products<R: Real>([a, b]: [R; 2], [c, d]: [R; 2]) -> Ordering {
    match (a * b).partial_cmp(&(c * d)) {
        Some(Ordering::Equal) | None => {
            compare_products_exactly([a, b].map(R::get), [c, d].map(R::get))
        }
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

/// |a·b| as an exponent and 128 bits with the topmost set: ordered like the products.
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
            let orders = [compare_products(ab, cd), compare_products(cd, ab).reverse()];
            assert_eq!(orders, [expected; 2], "{ab:?} against {cd:?}");
        }
    }
}
