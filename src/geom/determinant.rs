//! Signs of determinants, exact on the numbers given.
//!
//! As computed, a determinant decides where it is larger than its own rounding error; else an expansion does. Exact for
//! numbers whose products of four neither overflow nor vanish, say between 10⁻⁷⁰ and 10⁷⁰.

use std::cmp::Ordering;

/// Of three rows: the columns of each one's minor.
const MINORS: [[usize; 2]; 3] = [[1, 2], [2, 0], [0, 1]];

/// Of three rows.
#[inline]
#[must_use]
pub fn sign_of_three([a, b, c]: [[f64; 3]; 3]) -> Ordering {
    let (mut sum, mut size) = (0.0, 0.0);
    for (axis, [i, j]) in MINORS.into_iter().enumerate() {
        sum += a[axis] * (b[i] * c[j] - b[j] * c[i]);
        size += a[axis].abs() * ((b[i] * c[j]).abs() + (b[j] * c[i]).abs());
    }
    certain(sum, size).unwrap_or_else(|| exact_sign_of_three([a, b, c]))
}

#[cold]
fn exact_sign_of_three([a, b, c]: [[f64; 3]; 3]) -> Ordering {
    let mut exact = Expansion::default();
    for (axis, [i, j]) in MINORS.into_iter().enumerate() {
        exact = exact.plus(&minor([b[i], b[j]], [c[i], c[j]]).times(a[axis]));
    }
    exact.sign()
}

/// Of four rows, by Laplace's expansion along the first two and the last two.
#[must_use]
pub fn sign_of_four([a, b, c, d]: [[f64; 4]; 4]) -> Ordering {
    const PAIRS: [([usize; 2], [usize; 2], f64); 6] = [
        ([0, 1], [2, 3], 1.0),
        ([0, 2], [1, 3], -1.0),
        ([0, 3], [1, 2], 1.0),
        ([1, 2], [0, 3], 1.0),
        ([1, 3], [0, 2], -1.0),
        ([2, 3], [0, 1], 1.0),
    ];
    let (mut sum, mut size) = (0.0, 0.0);
    for ([i, j], [k, l], sign) in PAIRS {
        sum += sign * (a[i] * b[j] - a[j] * b[i]) * (c[k] * d[l] - c[l] * d[k]);
        size += ((a[i] * b[j]).abs() + (a[j] * b[i]).abs())
            * ((c[k] * d[l]).abs() + (c[l] * d[k]).abs());
    }
    certain(sum, size).unwrap_or_else(|| {
        let mut exact = Expansion::default();
        for ([i, j], [k, l], sign) in PAIRS {
            let upper = minor([a[i], a[j]], [b[i], b[j]]);
            for (factors, sign) in [([c[k], d[l]], sign), ([c[l], d[k]], -sign)] {
                exact = exact.plus(&upper.times(factors[0] * sign).times(factors[1]));
            }
        }
        exact.sign()
    })
}

/// The sign of a sum of at most 24 products of at most four numbers, where rounding cannot have turned it. `size` is the sum of the
/// products' magnitudes.
#[inline]
#[must_use]
pub fn certain(sum: f64, size: f64) -> Option<Ordering> {
    let bound = 32.0 * f64::EPSILON * size;
    ((1e-250..1e250).contains(&size) && sum.abs() > bound)
        .then(|| sum.partial_cmp(&0.0))
        .flatten()
}

/// `a0·b1 − a1·b0`
fn minor(a: [f64; 2], b: [f64; 2]) -> Expansion {
    Expansion::product(a[0], b[1]).minus(&Expansion::product(a[1], b[0]))
}

/// A sum of numbers that do not overlap, the smallest first, which loses nothing as long as no product leaves the range in
/// which its rounding error is a number of its own: about 10⁻²⁹⁰ to 10³⁰⁰. J. R. Shewchuk, "Adaptive precision floating-point
/// arithmetic and fast robust geometric predicates", Discrete & Computational Geometry 18, 1997, pp. 305–363.
#[derive(Clone, PartialEq, Debug, Default)]
struct Expansion(Vec<f64>);

impl Expansion {
    fn product(a: f64, b: f64) -> Self {
        let high = a * b;
        let low = a.mul_add(b, -high);
        Self([low, high].into_iter().filter(|x| *x != 0.0).collect())
    }

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

    fn plus(mut self, other: &Self) -> Self {
        for &part in &other.0 {
            self.grow(part);
        }
        self
    }

    fn minus(mut self, other: &Self) -> Self {
        for &part in &other.0 {
            self.grow(-part);
        }
        self
    }

    fn times(&self, factor: f64) -> Self {
        let mut sum = Self::default();
        for &part in &self.0 {
            sum = sum.plus(&Self::product(part, factor));
        }
        sum
    }

    fn sign(&self) -> Ordering {
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
    use crate::geom::random_bits;

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

    #[test]
    fn rounding_decides_nothing() {
        // The third row is the sum of the others, but for one ulp.
        let [a, b] = [[0.1, 0.7, -0.3], [0.9, -0.2, 0.4]];
        let sum: [f64; 3] = [0.1, 0.7, -0.3];
        assert_eq!(sign_of_three([a, b, sum]), Ordering::Equal);
        for (above, expected) in [(true, 1.0), (false, -1.0)] {
            let [x, y, z] = sum;
            let row = [x, y, if above { z.next_up() } else { z.next_down() }];
            // The change of the determinant is that of its last entry, times the minor beside it.
            let minor: f64 = a[0] * b[1] - a[1] * b[0];
            let expected = (expected * minor).partial_cmp(&0.0).unwrap();
            assert_eq!(sign_of_three([a, b, row]), expected);
            let [a, b, row] = [a, b, row].map(|[x, y, z]| [x, y, z, 0.25]);
            assert_eq!(sign_of_four([a, b, row, [0.0, 0.0, 0.0, 1.0]]), expected);
        }
    }

    #[test]
    fn it_agrees_with_the_tetrahedron_of_shewchuk() {
        let mut bits = random_bits(3);
        let mut next = || ((bits() >> 33) % 7) as f64 * 0.1;
        for _ in 0..20_000 {
            let points = [(); 4].map(|()| [next(), next(), next()]);
            let [a, b, c, d] = points.map(|[x, y, z]| robust::Coord3D { x, y, z });
            let expected = robust::orient3d(a, b, c, d).partial_cmp(&0.0).unwrap();
            let rows = points.map(|[x, y, z]| [x, y, z, 1.0]);
            assert_eq!(sign_of_four(rows), expected, "{points:?}");
        }
    }
}
