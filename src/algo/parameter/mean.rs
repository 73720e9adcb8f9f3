//! The coordinate of a crossing: the weighted mean (o1·w2 + o2·w1) / (w1 + w2) of the ends' own, each weighted by the other end's
//! distance.
//!
//! Swapping the ends negates numerator and denominator, so that the quotient keeps every bit; and where products and sum are
//! exact, the one rounding left is the division's. `o1 + u·(o2 − o1)` has neither property.

use serde::Serialize;

use crate::{
    geom::Wide,
    trace::{Real, wide_quotient},
};

/// Differences beyond this range, or products of such, could overflow or lose bits to underflow: they are scaled first.
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
        wide_mean([o1, o2], raw)
    }
}

/// Weights and their sum, positive along the segment.
#[inline]
fn along<R: Real>([w1, w2]: [R; 2], whole: R) -> [R; 3] {
    // By its bit: to guess whether a segment goes up or down costs more than a multiplication.
    let sign = whole.get().to_bits() & (1 << 63);
    let along = |w: R| R::new(f64::from_bits(w.get().to_bits() ^ sign));
    [along(w1), along(w2), along(whole)]
}

/// Does the border pass through no end, and is what is divided by neither too large nor too small? Of what [`along`] gives.
#[inline]
fn are_plain([w1, w2]: [f64; 2], whole: f64) -> bool {
    w1 != 0.0 && w2 != 0.0 && PLAIN.contains(&whole)
}

/// [`weighted_mean`] for coordinates whose differences or products leave the range of f64. Only the division has not been counted.
#[cold]
fn wide_mean<R: Real>([o1, o2]: [R; 2], raw: [f64; 3]) -> R {
    let [a1, a2, c] = raw.map(Wide::new);
    let (forward, back) = ([c - a1, a2 - c, a2 - a1], [a1 - c, c - a2, a1 - a2]);
    let [w1, w2, whole] = if a1 < a2 { forward } else { back };
    let sum = Wide::new(o1.get()) * w2 + Wide::new(o2.get()) * w1;
    let mean = wide_quotient::<R>(sum, whole).get();
    // The border may be so far outside the segment that its crossing has no coordinate.
    R::new(mean.clamp(f64::MIN, f64::MAX))
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

/// How much each end of an edge has in its crossing with a border.
#[derive(Clone, Copy, Debug)]
pub struct Share<R> {
    /// Distances of inside and outside end along the edge's direction, and their sum.
    pub(in crate::algo) weights: [R; 2],
    pub(in crate::algo) whole: R,
    /// Three numbers whose differences these are, in case they overflow.
    pub(in crate::algo) raw: [f64; 3],
}

impl<R: Real> Share<R> {
    /// What is `inside` at the inside end and `outside` at the other, at the crossing; between the two, whatever rounding does.
    #[inline]
    pub fn mean(&self, inside: f64, outside: f64) -> f64 {
        let ends = [inside, outside].map(R::new);
        let mean = weighted_mean(ends, self.weights, self.whole, self.raw);
        clamp_between(mean, ends[0], ends[1]).get()
    }

    /// [`Share::mean`] of each pair: what the weights alone tell is asked once, and nothing stands between the pairs.
    #[inline]
    pub fn means<const N: usize>(&self, inside: [f64; N], outside: [f64; N]) -> [f64; N] {
        let [w1, w2, whole] = along(self.weights, self.whole);
        // Nothing, unless one of the sums is not finite.
        let nothing = (0..N).fold(0.0, |nothing, i| {
            nothing + 0.0 * (inside[i] * w2.get() + outside[i] * w1.get())
        });
        if nothing != 0.0 || !are_plain([w1.get(), w2.get()], whole.get()) {
            return std::array::from_fn(|i| self.mean(inside[i], outside[i]));
        }
        std::array::from_fn(|i| {
            let [o1, o2] = [R::new(inside[i]), R::new(outside[i])];
            clamp_between((o1 * w2 + o2 * w1) / whole, o1, o2).get()
        })
    }

    /// The parameter of the crossing, from the end that is inside if `is_leaving`, else from the other.
    pub(in crate::algo) fn ratio(&self, is_leaving: bool) -> Ratio {
        let [w1, w2] = self.weights.map(R::get);
        let (w1, w2, whole) = if self.whole.get().is_finite() {
            (w1, w2, self.whole.get())
        } else {
            let [a1, a2, c] = self.raw.map(|x| 0.5 * x);
            (c - a1, a2 - c, a2 - a1)
        };
        let [num, den] = if is_leaving {
            [w1, whole]
        } else {
            [-w2, -whole]
        };
        Ratio { num, den }
    }
}
