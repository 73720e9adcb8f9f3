//! Signs of determinants over a scalar that counts. The exact arithmetic that decides where rounding leaves a sign open is no part of the
//! algorithm and is not counted.

use std::cmp::Ordering;

use crate::{
    geom::{certain_sign, minor_extent, sign_of_four, sign_of_three},
    trace::Real,
};

/// Where `v` lies by the plane of a triangle, as the sign of |a b c v|, points having 1 as their last coordinate.
#[inline]
pub fn side_of<R: Real>(triangle: &[[f64; 3]; 3], v: [f64; 4]) -> Ordering {
    let [a, b, c] = triangle.map(point);
    let rows = [a, b, c, v];
    let counted = rows.map(|row| row.map(R::new));
    let (mut sum, mut size) = (R::new(0.0), 0.0);
    for ([i, j], [k, l], is_added) in PAIRS {
        let product =
            minor([counted[0], counted[1]], [i, j]) * minor([counted[2], counted[3]], [k, l]);
        sum = if is_added {
            sum + product
        } else {
            sum - product
        };
        size += extent([rows[0], rows[1]], [i, j]) * extent([rows[2], rows[3]], [k, l]);
    }
    sign(sum, size).unwrap_or_else(|| sign_of_four(rows))
}

/// Which way three vectors turn: the sign of |a b c|.
#[inline]
pub fn turn_of<R: Real>(vectors: [[f64; 3]; 3]) -> Ordering {
    let [a, b, c] = vectors;
    let counted = vectors.map(|vector| vector.map(R::new));
    let (mut sum, mut size) = (R::new(0.0), 0.0);
    for (axis, columns) in [[1, 2], [2, 0], [0, 1]].into_iter().enumerate() {
        sum = sum + counted[0][axis] * minor([counted[1], counted[2]], columns);
        size += a[axis].abs() * extent([b, c], columns);
    }
    sign(sum, size).unwrap_or_else(|| sign_of_three(vectors))
}

/// Laplace's expansion along the first two rows and the last two: the columns of both minors, and whether their product is added.
const PAIRS: [([usize; 2], [usize; 2], bool); 6] = [
    ([0, 1], [2, 3], true),
    ([0, 2], [1, 3], false),
    ([0, 3], [1, 2], true),
    ([1, 2], [0, 3], true),
    ([1, 3], [0, 2], false),
    ([2, 3], [0, 1], true),
];

#[inline]
fn minor<R: Real, const N: usize>([a, b]: [[R; N]; 2], [i, j]: [usize; 2]) -> R {
    a[i] * b[j] - a[j] * b[i]
}

/// Of a minor's products.
#[inline]
fn extent<const N: usize>([a, b]: [[f64; N]; 2], [i, j]: [usize; 2]) -> f64 {
    minor_extent([a[i] * b[j], a[j] * b[i]])
}

/// Counted as the comparison with 0 that it is.
#[inline]
fn sign<R: Real>(sum: R, size: f64) -> Option<Ordering> {
    let order = sum.partial_cmp(&R::new(0.0));
    certain_sign(sum.get(), size).and(order)
}

pub const fn point([x, y, z]: [f64; 3]) -> [f64; 4] {
    [x, y, z, 1.0]
}
