//! Signs of determinants, exact on the numbers given, whatever finite numbers they are.
//!
//! As computed, a determinant decides where it is larger than its own rounding error; else long integers do.

use std::cmp::Ordering;

use super::long_sum::LongSum;

/// Of three rows: the columns of each one's minor.
const MINORS: [[usize; 2]; 3] = [[1, 2], [2, 0], [0, 1]];

/// Of three rows.
#[inline]
#[must_use]
pub fn sign_of_three([a, b, c]: [[f64; 3]; 3]) -> Ordering {
    let (mut sum, mut size) = (0.0, 0.0);
    for (axis, [i, j]) in MINORS.into_iter().enumerate() {
        sum += a[axis] * (b[i] * c[j] - b[j] * c[i]);
        size += a[axis].abs() * extent([b[i] * c[j], b[j] * c[i]]);
    }
    certain(sum, size).unwrap_or_else(|| exact_sign_of_three([a, b, c]))
}

#[cold]
fn exact_sign_of_three([a, b, c]: [[f64; 3]; 3]) -> Ordering {
    let mut exact = LongSum::zero();
    for (axis, [i, j]) in MINORS.into_iter().enumerate() {
        exact.add([a[axis], b[i], c[j]]);
        exact.add([-a[axis], b[j], c[i]]);
    }
    exact.sign()
}

/// Of two pairs of rows: the columns of both minors, and the sign of their product.
const PAIRS: [([usize; 2], [usize; 2], f64); 6] = [
    ([0, 1], [2, 3], 1.0),
    ([0, 2], [1, 3], -1.0),
    ([0, 3], [1, 2], 1.0),
    ([1, 2], [0, 3], 1.0),
    ([1, 3], [0, 2], -1.0),
    ([2, 3], [0, 1], 1.0),
];

/// Of four rows, by Laplace's expansion along the first two and the last two.
#[must_use]
pub fn sign_of_four([a, b, c, d]: [[f64; 4]; 4]) -> Ordering {
    let (mut sum, mut size) = (0.0, 0.0);
    for ([i, j], [k, l], sign) in PAIRS {
        let [upper, lower] = [[a[i] * b[j], a[j] * b[i]], [c[k] * d[l], c[l] * d[k]]];
        sum += sign * (upper[0] - upper[1]) * (lower[0] - lower[1]);
        size += extent(upper) * extent(lower);
    }
    certain(sum, size).unwrap_or_else(|| exact_sign_of_four([a, b, c, d]))
}

#[cold]
fn exact_sign_of_four([a, b, c, d]: [[f64; 4]; 4]) -> Ordering {
    let mut exact = LongSum::zero();
    for ([i, j], [k, l], sign) in PAIRS {
        for (a, b) in [(sign * a[i], b[j]), (-sign * a[j], b[i])] {
            exact.add([a, b, c[k], d[l]]);
            exact.add([-a, b, c[l], d[k]]);
        }
    }
    exact.sign()
}

/// How large the products of a minor are, and what may vanish from them: rounding takes no more than a part of this.
#[inline]
#[must_use]
pub const fn extent([one, other]: [f64; 2]) -> f64 {
    /// Of products below it rounding may take all.
    const VANISHING: f64 = 1e-290;
    one.abs() + other.abs() + VANISHING
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geom::random_bits;

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

    #[test]
    fn no_number_is_too_large_or_too_small() {
        let units = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        for scale in [f64::MAX, 1e110, 1e-110, 5e-324] {
            let [a, b, c] = units.map(|row| row.map(|x| x * scale));
            assert_eq!(sign_of_three([a, b, c]), Ordering::Greater, "{scale:e}");
            assert_eq!(sign_of_three([b, a, c]), Ordering::Less, "{scale:e}");
            let rows = [[0.0; 3], a, b, c].map(|[x, y, z]| [x, y, z, 1.0]);
            assert_eq!(sign_of_four(rows), Ordering::Less, "{scale:e}");
        }
    }

    #[test]
    fn products_that_lose_their_bits_decide_nothing_beside_large_factors() {
        // 1.4 and 1 of the smallest number: as computed, both come to one of it.
        let [lower, upper] = [2f64.powi(-500), 2f64.powi(-574)];
        let rows = [
            [1e80, 1.2e80, 0.0],
            [upper, 1.4 * upper, 0.0],
            [0.0, 0.0, lower],
        ];
        assert_eq!(sign_of_three(rows), Ordering::Greater);
    }
}
