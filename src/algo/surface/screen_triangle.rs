//! A triangle on the screen, ready to be filled.

use std::ops::Range;

use crate::trace::Real;

use super::Viewport;

/// Snapped corners, and what is linear over the screen: depth, 1/w, and attributes over w.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ScreenTriangle<const N: usize> {
    /// Whose it is.
    pub id: u32,
    /// From the top to the bottom, in fractions of a pixel.
    pub(super) corners: [[i32; 2]; 3],
    /// Of each of these corners, the first row whose middle does not lie above it.
    pub(super) rows: [u32; 3],
    /// Does the long edge, from the first corner to the last, bound it on the left?
    pub(super) is_long_left: bool,
    /// (z/w + 1) / 2
    pub(super) depth: Linear<f64>,
    /// 1/w
    pub(super) inverse_w: Linear<f32>,
    /// Each over w.
    pub(super) attributes: [Linear<f32>; N],
}

/// What is linear over the screen: value at the origin of the picture's pixels, and how it changes from column to column
/// and from row to row.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Linear<T> {
    pub at: T,
    pub by_column: T,
    pub by_row: T,
}

/// A corner on its way to the screen.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Corner<const N: usize> {
    pub at: [i32; 2],
    /// (z/w + 1) / 2
    pub depth: f64,
    /// 1/w
    pub inverse_w: f64,
    pub attributes: [f32; N],
}

/// Twice the signed area in fractions of a pixel: negative where the corners turn counter-clockwise as seen, since y is down.
#[inline]
pub(super) fn double_area(corners: [[i32; 2]; 3]) -> i64 {
    let [a, b, c] = corners.map(|at| at.map(i64::from));
    (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])
}

impl<const N: usize> ScreenTriangle<N> {
    /// The rows whose middles it may cover.
    #[must_use]
    pub const fn rows(&self) -> Range<u32> {
        self.rows[0]..self.rows[2]
    }

    /// From corners in any order; `None` without area.
    #[inline]
    pub(super) fn new(id: u32, corners: &[Corner<N>; 3], viewport: &Viewport) -> Option<Self> {
        let places = corners.each_ref().map(|c| c.at);
        if double_area(places) == 0 {
            return None;
        }
        let scale = 1.0 / viewport.pixel() as f64;
        let slopes = Slopes::new(places.map(|at| at.map(|x| f64::from(x) * scale)));
        let attribute = |i: usize| {
            slopes.linear(
                corners
                    .each_ref()
                    .map(|c| f64::from(c.attributes[i]) * c.inverse_w),
            )
        };
        let [top, middle, bottom] = from_the_top(places);
        Some(Self {
            id,
            corners: [top, middle, bottom],
            rows: [top, middle, bottom].map(|[_, y]| viewport.first_middle(y)),
            is_long_left: double_area([top, middle, bottom]) > 0,
            depth: slopes.linear(corners.each_ref().map(|c| c.depth)),
            inverse_w: slopes
                .linear(corners.each_ref().map(|c| c.inverse_w))
                .narrow(),
            attributes: std::array::from_fn(|i| attribute(i).narrow()),
        })
    }
}

/// Sorted by y, and those as high by x: neither is negative, so both compare as one number.
#[inline]
fn from_the_top(places: [[i32; 2]; 3]) -> [[i32; 2]; 3] {
    let [a, b, c] = places.map(|[x, y]| u64::from(y as u32) << 32 | u64::from(x as u32));
    let (low, high) = (a.min(b), a.max(b));
    let sorted = [low.min(c), low.max(c).min(high), high.max(c)];
    sorted.map(|key| [key as i32, (key >> 32) as i32])
}

/// What turns three values at the corners into a linear function.
struct Slopes {
    origin: [f64; 2],
    edges: [[f64; 2]; 2],
    inverse_area: f64,
}

impl Slopes {
    #[inline]
    fn new([a, b, c]: [[f64; 2]; 3]) -> Self {
        let edges = [[b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]];
        let [p, q] = edges;
        Self {
            origin: a,
            edges,
            inverse_area: 1.0 / (p[0] * q[1] - q[0] * p[1]),
        }
    }

    #[inline]
    fn linear(&self, [a, b, c]: [f64; 3]) -> Linear<f64> {
        let [p, q] = self.edges;
        let (to_b, to_c) = ((b - a) * self.inverse_area, (c - a) * self.inverse_area);
        let by_column = to_b * q[1] - to_c * p[1];
        let by_row = to_c * p[0] - to_b * q[0];
        // At the middle of pixel (0, 0).
        let at = a + by_column * (0.5 - self.origin[0]) + by_row * (0.5 - self.origin[1]);
        Linear {
            at,
            by_column,
            by_row,
        }
    }
}

impl Linear<f64> {
    #[inline]
    fn narrow(self) -> Linear<f32> {
        Linear {
            at: self.at as f32,
            by_column: self.by_column as f32,
            by_row: self.by_row as f32,
        }
    }

    /// In the middle of a pixel.
    #[inline]
    pub fn of<R: Real>(&self, column: u32, row: u32) -> R {
        let [at, by_column, by_row] = [self.at, self.by_column, self.by_row].map(R::new);
        at + by_column * R::new(column.into()) + by_row * R::new(row.into())
    }
}

impl Linear<f32> {
    /// In the middle of a pixel.
    #[inline]
    pub fn of(&self, column: u32, row: u32) -> f32 {
        self.at + self.by_column * column as f32 + self.by_row * row as f32
    }
}
