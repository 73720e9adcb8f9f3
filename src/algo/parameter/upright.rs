//! Borders on which one coordinate is constant: the sides of a window, the faces of a box.
//!
//! ```text
//!   a1 ●────── c − a1 ──────┊──── a2 − c ────● a2        distances: a − c on a low side, c − a on a high one
//!                         c ┊
//! ```

use crate::trace::Real;

use super::Share;

/// A side, and both ends of a segment, along the axis across it.
#[derive(Clone, Copy, Debug)]
pub struct Upright {
    /// Of P₁ and P₂.
    pub ends: [f64; 2],
    /// The side's own coordinate.
    pub at: f64,
    /// Is the inside where the coordinate is less?
    pub is_max: bool,
}

impl Upright {
    /// Distances of P₁ and P₂, inside positive. One rounding each, and none in their signs. Where one overflows, half of
    /// both: only their ratio counts.
    #[must_use]
    pub fn distances<R: Real>(&self) -> [R; 2] {
        let at_scale = |scale: f64| {
            let c = R::new(scale * self.at);
            self.ends.map(|a| {
                let a = R::new(scale * a);
                if self.is_max { c - a } else { a - c }
            })
        };
        let distances = at_scale(1.0);
        if distances.iter().all(|d| d.get().is_finite()) {
            distances
        } else {
            at_scale(0.5)
        }
    }

    /// `q / p`, by halves where a difference of huge coordinates has overflowed. A zero has no sign.
    pub fn quotient<R: Real>(&self, q: R, p: R) -> R {
        if q.get().is_finite() && p.get().is_finite() {
            return R::new((q / p).get() + 0.0);
        }
        let [a1, a2, c] = [self.ends[0], self.ends[1], self.at].map(|x| 0.5 * x);
        R::new(c - a1) / R::new(a2 - a1)
    }

    /// How the ends share in the crossing. They must not have the same coordinate.
    #[inline]
    pub fn share<R: Real>(&self) -> Share<R> {
        let raw = [self.ends[0], self.ends[1], self.at];
        let [a1, a2, c] = raw.map(R::new);
        Share {
            weights: [c - a1, a2 - c],
            whole: a2 - a1,
            raw,
        }
    }
}
