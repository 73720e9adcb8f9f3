//! Signs of determinants, exact on the numbers given.
//!
//! As computed, a determinant decides where it is larger than its own rounding error; else an expansion does. Exact for
//! numbers whose products of four neither overflow nor vanish, say between 10⁻⁷⁰ and 10⁷⁰.

use std::cmp::Ordering;

use super::expansion::Expansion;

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

/// The sign of a sum of at most 24 products of at most four numbers, where rounding cannot have turned it.
#[inline]
fn certain(sum: f64, size: f64) -> Option<Ordering> {
    let bound = 32.0 * f64::EPSILON * size;
    ((1e-250..1e250).contains(&size) && sum.abs() > bound)
        .then(|| sum.partial_cmp(&0.0))
        .flatten()
}

/// `a0·b1 − a1·b0`
fn minor(a: [f64; 2], b: [f64; 2]) -> Expansion {
    Expansion::product(a[0], b[1]).minus(&Expansion::product(a[1], b[0]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounding_decides_nothing() {
        // The third row is the sum of the others, but for one ulp.
        let [a, b] = [[0.1, 0.7, -0.3], [0.9, -0.2, 0.4]];
        let sum = [0.1, 0.7, -0.3];
        assert_eq!(sign_of_three([a, b, sum]), Ordering::Equal);
        for (above, expected) in [(true, 1.0), (false, -1.0)] {
            let mut row = sum;
            row[2] = if above {
                f64::next_up(row[2])
            } else {
                f64::next_down(row[2])
            };
            // The change of the determinant is that of its last entry, times the minor beside it.
            let minor: f64 = a[0] * b[1] - a[1] * b[0];
            let expected = (expected * minor).partial_cmp(&0.0).unwrap();
            assert_eq!(sign_of_three([a, b, row]), expected);
            let four = [a, b, row].map(|[x, y, z]| [x, y, z, 0.25]);
            assert_eq!(
                sign_of_four([four[0], four[1], four[2], [0.0, 0.0, 0.0, 1.0]]),
                expected
            );
        }
    }

    #[test]
    fn it_agrees_with_the_tetrahedron_of_shewchuk() {
        let mut state = 3_u64;
        let mut next = || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1);
            ((state >> 33) % 7) as f64 * 0.1
        };
        for _ in 0..20_000 {
            let points = [(); 4].map(|()| [next(), next(), next()]);
            let [a, b, c, d] = points.map(|[x, y, z]| robust::Coord3D { x, y, z });
            let expected = robust::orient3d(a, b, c, d).partial_cmp(&0.0).unwrap();
            let rows = points.map(|[x, y, z]| [x, y, z, 1.0]);
            assert_eq!(sign_of_four(rows), expected, "{points:?}");
        }
    }
}
