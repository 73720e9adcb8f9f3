//! The coordinate of a crossing: a weighted mean of the ends' own.
//!
//! ```text
//!   a1 ●────── w1 ──────┊──── w2 ────● a2        o = (o1·w2 + o2·w1) / (w1 + w2)
//!      o1             border        o2
//! ```
//!
//! Swapping the ends negates numerator and denominator, so that the quotient keeps every bit; and where
//! products and sum are exact, the one rounding left is the division's. `o1 + u·(o2 − o1)` has neither
//! property.

use serde::Serialize;

use crate::trace::Real;

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

/// `(o1·w2 + o2·w1) / whole`, where `w1 = c − a1`, `w2 = a2 − c` and `whole = a2 − a1 ≠ 0`; `raw` is
/// `[a1, a2, c]`.
///
/// Where the border passes through an end, that end's own coordinate: `o·w / w` need not round back to it.
/// Otherwise all three are taken positive along the segment, so that even the sign of a zero is the same
/// from both ends.
#[inline]
pub fn weighted_mean<R: Real>([o1, o2]: [R; 2], [w1, w2]: [R; 2], whole: R, raw: [f64; 3]) -> R {
    if w1.get() == 0.0 {
        return o1;
    }
    if w2.get() == 0.0 {
        return o2;
    }
    let [w1, w2, whole] = along([w1, w2], whole);
    let sum = o1 * w2 + o2 * w1;
    if PLAIN.contains(&whole.get()) && sum.get().is_finite() {
        sum / whole
    } else {
        R::new(scaled_mean(o1.get(), o2.get(), raw))
    }
}

/// Weights and their sum, positive along the segment.
#[inline]
pub(super) fn along<R: Real>([w1, w2]: [R; 2], whole: R) -> [R; 3] {
    // By its bit: to guess whether a segment goes up or down costs more than a multiplication.
    let sign = whole.get().to_bits() & (1 << 63);
    let along = |w: R| R::new(f64::from_bits(w.get().to_bits() ^ sign));
    [along(w1), along(w2), along(whole)]
}

/// Does the border pass through no end, and is what is divided by neither too large nor too small? Of what [`along`] gives.
#[inline]
pub(super) fn are_plain([w1, w2]: [f64; 2], whole: f64) -> bool {
    w1 != 0.0 && w2 != 0.0 && PLAIN.contains(&whole)
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

/// Keeps `x` between two bounds in either order. Selections, not branches: neither outcome is likelier.
#[inline]
pub fn clamp_between<R: Real>(x: R, bound: R, other: R) -> R {
    let ordered = bound < other;
    let low = if ordered { bound } else { other };
    let high = if ordered { other } else { bound };
    let x = if x < low { low } else { x };
    if x > high { high } else { x }
}
