//! How the ends of an edge share in its crossing with a border.

use crate::trace::Real;

use super::{
    Ratio, clamp_between,
    mean::{along, are_plain},
    weighted_mean,
};

/// How much each end of an edge has in its crossing with a border, as the distances that it follows from:
/// the crossing is the mean of both ends, each weighted by the *other* end's distance.
#[derive(Clone, Copy, Debug)]
pub struct Share<R> {
    /// Distances of inside and outside end along the edge's direction, and their sum.
    pub(in crate::algo) weights: [R; 2],
    pub(in crate::algo) whole: R,
    /// Three numbers whose differences these are, in case they overflow.
    pub(in crate::algo) raw: [f64; 3],
}

impl<R: Real> Share<R> {
    /// The value at the crossing of what is `inside` at the inside end and `outside` at the other, and
    /// between the two, whatever rounding does.
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

    /// The parameter of the crossing, as the two numbers of its quotient, from the end that is inside if
    /// `is_leaving`, else from the other.
    pub(in crate::algo) fn ratio(&self, is_leaving: bool) -> Ratio {
        let [w1, w2] = self.weights.map(R::get);
        let (w1, w2, whole) = if self.whole.get().is_finite() {
            (w1, w2, self.whole.get())
        } else {
            let [a1, a2, c] = self.raw.map(|x| 0.5 * x);
            (c - a1, a2 - c, a2 - a1)
        };
        if is_leaving {
            Ratio {
                num: w1,
                den: whole,
            }
        } else {
            Ratio {
                num: -w2,
                den: -whole,
            }
        }
    }
}
