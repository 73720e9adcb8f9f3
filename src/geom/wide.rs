//! Numbers that are as precise as `f64` and neither overflow nor vanish.

use std::{
    cmp::Ordering,
    ops::{Add, Div, Mul, Neg, Sub},
};

use super::power::{exponent, times_power};

/// An `f64` and a power of two. What is worked out keeps every bit that `f64` would give it, where that would be in its range: for the
/// few inputs for which it would not be, after the run over `f64` has found that out. Nothing is counted.
///
/// ```
/// use clipscope::geom::Wide;
/// let huge = Wide::new(1e200);
/// assert_eq!((huge * huge / huge).get(), 1e200);
/// assert_eq!((huge * huge).get(), f64::INFINITY);
/// assert_eq!((huge * huge - huge * huge).get(), 0.0);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Wide {
    /// From 1 up to 2 in magnitude, unless it is 0 or not finite.
    near_one: f64,
    by: i32,
}

impl Wide {
    /// This number.
    #[must_use]
    pub fn new(x: f64) -> Self {
        Self::normal(x, 0)
    }

    /// The number; infinite where it is larger than any that `f64` has.
    #[must_use]
    pub fn get(self) -> f64 {
        let [x] = times_power([self.near_one], self.by);
        x
    }

    const fn with(near_one: f64, by: i32) -> Self {
        Self { near_one, by }
    }

    fn normal(x: f64, by: i32) -> Self {
        if x == 0.0 || !x.is_finite() {
            return Self::with(x, 0);
        }
        let own = exponent(&[x]);
        let [near_one] = times_power([x], -own);
        Self::with(near_one, own + by)
    }

    /// The number, or the nearest of its sign that is neither 0 nor infinite.
    #[must_use]
    pub fn bounded(self) -> f64 {
        if self.near_one == 0.0 {
            return self.near_one;
        }
        let size = self.get().abs();
        size.clamp(f64::MIN_POSITIVE, f64::MAX)
            .copysign(self.near_one)
    }

    /// All over one power of two, by which the largest comes near 1, and its exponent: for numbers of which only the ratio counts.
    #[must_use]
    pub fn near_one<const N: usize>(numbers: [Self; N]) -> ([f64; N], i32) {
        let nonzero = numbers.iter().filter(|x| x.near_one != 0.0);
        let by = nonzero.map(|x| x.by).max().unwrap_or(0);
        let over = numbers.map(|x| x.times_power(-by).bounded());
        (over, by)
    }

    /// Times 2 to the power of an exponent.
    #[must_use]
    pub const fn times_power(self, exponent: i32) -> Self {
        Self::with(self.near_one, self.by + exponent)
    }

    /// The number near 1, or 0, and the exponent of the power of two.
    #[must_use]
    pub const fn parts(self) -> (f64, i32) {
        (self.near_one, self.by)
    }
}

impl Add for Wide {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        if self.near_one == 0.0 || other.near_one == 0.0 {
            let by = if self.near_one == 0.0 {
                other.by
            } else {
                self.by
            };
            return Self::with(self.near_one + other.near_one, by);
        }
        let by = self.by.max(other.by);
        let [a, b] = [self, other].map(|x| x.times_power(-by).get());
        Self::normal(a + b, by)
    }
}

impl Sub for Wide {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Wide {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self::normal(self.near_one * other.near_one, self.by + other.by)
    }
}

impl Div for Wide {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        Self::normal(self.near_one / other.near_one, self.by - other.by)
    }
}

impl Neg for Wide {
    type Output = Self;

    fn neg(self) -> Self {
        Self::with(-self.near_one, self.by)
    }
}

impl PartialEq for Wide {
    fn eq(&self, other: &Self) -> bool {
        (*self - *other).near_one == 0.0
    }
}

impl PartialOrd for Wide {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        (*self - *other).near_one.partial_cmp(&0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_bit_is_that_of_f64_where_f64_has_it() {
        let numbers = [0.0, -0.0, 1.0, 0.1, -0.3, 1e10, 3e-20, -7e100, 1.5e-100];
        for a in numbers {
            for b in numbers {
                let [x, y] = [a, b].map(Wide::new);
                let [sum, difference] = [x + y, x - y].map(|it| it.get().to_bits());
                assert_eq!(sum, (a + b).to_bits(), "{a} + {b}");
                assert_eq!(difference, (a - b).to_bits(), "{a} - {b}");
                assert_eq!((x * y).get().to_bits(), (a * b).to_bits(), "{a} * {b}");
                if b != 0.0 {
                    assert_eq!((x / y).get().to_bits(), (a / b).to_bits(), "{a} / {b}");
                }
                assert_eq!(x.partial_cmp(&y), a.partial_cmp(&b), "{a} and {b}");
                assert_eq!(x == y, a == b, "{a} and {b}");
            }
        }
    }

    #[test]
    fn what_f64_loses_comes_back() {
        let [large, small] = [f64::MAX, 5e-324].map(Wide::new);
        assert_eq!((large + large).get(), f64::INFINITY);
        assert_eq!((large + large - large).get(), f64::MAX);
        assert_eq!((small * small / small).get(), 5e-324);
        assert_eq!((small * small).get(), 0.0);
        assert_eq!((-small * small).bounded(), -f64::MIN_POSITIVE);
        assert_eq!((large * large).bounded(), f64::MAX);
        let ([huge, negative, zero], by) = Wide::near_one([large * large, -small, Wide::new(0.0)]);
        assert_eq!(
            (huge, zero, by),
            (2.0_f64.next_down().next_down(), 0.0, 2047)
        );
        assert_eq!(negative, -f64::MIN_POSITIVE, "its sign is kept");
        assert!(large * small < large && -large < small);
    }
}
