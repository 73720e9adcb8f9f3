//! Sums of floating-point numbers that lose nothing: for the few signs that rounding cannot tell.
//!
//! J. R. Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric predicates", Discrete &
//! Computational Geometry 18, 1997, pp. 305–363.

use std::cmp::Ordering;

/// An exact sum of numbers that do not overlap, the smallest first. Exact as long as no product leaves the range in
/// which its rounding error is a number of its own: about 10⁻²⁹⁰ to 10³⁰⁰.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Expansion(Vec<f64>);

impl Expansion {
    /// `a · b`
    pub fn product(a: f64, b: f64) -> Self {
        let high = a * b;
        let low = a.mul_add(b, -high);
        Self([low, high].into_iter().filter(|x| *x != 0.0).collect())
    }

    /// With one number more.
    fn grow(&mut self, number: f64) {
        let mut sum = number;
        let mut parts = Vec::with_capacity(self.0.len() + 1);
        for &part in &self.0 {
            let (high, low) = two_sum(sum, part);
            if low != 0.0 {
                parts.push(low);
            }
            sum = high;
        }
        if sum != 0.0 {
            parts.push(sum);
        }
        self.0 = parts;
    }

    /// The sum of both.
    pub fn plus(mut self, other: &Self) -> Self {
        for &part in &other.0 {
            self.grow(part);
        }
        self
    }

    /// The difference.
    pub fn minus(mut self, other: &Self) -> Self {
        for &part in &other.0 {
            self.grow(-part);
        }
        self
    }

    /// The multiple.
    pub fn times(&self, factor: f64) -> Self {
        let mut sum = Self::default();
        for &part in &self.0 {
            sum = sum.plus(&Self::product(part, factor));
        }
        sum
    }

    /// Below, at or above zero.
    pub fn sign(&self) -> Ordering {
        let largest = self.0.last().copied().unwrap_or(0.0);
        largest.partial_cmp(&0.0).unwrap_or(Ordering::Equal)
    }
}

/// The rounded sum, and what rounding took from it.
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let b_kept = sum - a;
    let a_kept = sum - b_kept;
    (sum, (a - a_kept) + (b - b_kept))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_is_lost() {
        let [large, small] = [2f64.powi(60), 2f64.powi(-60)];
        let one = Expansion::product(large, 1.0).plus(&Expansion::product(small, 1.0));
        let back = one.clone().minus(&Expansion::product(large, 1.0));
        assert_eq!(back, Expansion(vec![small]));
        assert_eq!(back.sign(), Ordering::Greater);
        assert_eq!(one.clone().minus(&one).sign(), Ordering::Equal);
        // (2⁶⁰ + 2⁻⁶⁰)·0.1 − 0.1·2⁶⁰ − 0.1·2⁻⁶⁰ = 0, with 0.1 as it is stored.
        let rest = one
            .times(0.1)
            .minus(&Expansion::product(large, 0.1))
            .minus(&Expansion::product(small, 0.1));
        assert_eq!(rest.sign(), Ordering::Equal);
    }
}
