//! A triangle on the screen, ready to be filled.

use crate::trace::Real;

/// Snapped corners, and what is linear over the screen: depth, 1/w, and attributes over w.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ScreenTriangle<const N: usize> {
    /// Whose it is.
    pub id: u32,
    /// From the top to the bottom, in fractions of a pixel.
    pub(super) corners: [[i64; 2]; 3],
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
    pub at: [i64; 2],
    /// (z/w + 1) / 2
    pub depth: f64,
    /// 1/w
    pub inverse_w: f64,
    pub attributes: [f32; N],
}

impl<const N: usize> ScreenTriangle<N> {
    /// Twice the signed area in fractions of a pixel: negative where the corners turn counter-clockwise as seen, since y is
    /// down.
    #[inline]
    pub(super) fn double_area(corners: &[Corner<N>; 3]) -> i64 {
        let [a, b, c] = corners.each_ref().map(|corner| corner.at);
        (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])
    }

    /// From corners in any order, `pixel` fractions to a pixel; `None` without area.
    pub(super) fn new(id: u32, corners: &[Corner<N>; 3], pixel: i64) -> Option<Self> {
        let double_area = Self::double_area(corners);
        if double_area == 0 {
            return None;
        }
        let scale = 1.0 / pixel as f64;
        let at = corners.each_ref().map(|c| c.at.map(|x| x as f64 * scale));
        let slopes = Slopes::new(at);
        let attribute = |i: usize| {
            slopes.linear(
                corners
                    .each_ref()
                    .map(|c| f64::from(c.attributes[i]) * c.inverse_w),
            )
        };
        let mut sorted = corners.each_ref().map(|c| c.at);
        sorted.sort_unstable_by_key(|&[x, y]| (y, x));
        let [top, middle, bottom] = sorted;
        let turn = (middle[0] - top[0]) * (bottom[1] - top[1])
            - (bottom[0] - top[0]) * (middle[1] - top[1]);
        Some(Self {
            id,
            corners: sorted,
            is_long_left: turn > 0,
            depth: slopes.linear(corners.each_ref().map(|c| c.depth)),
            inverse_w: slopes
                .linear(corners.each_ref().map(|c| c.inverse_w))
                .narrow(),
            attributes: std::array::from_fn(|i| attribute(i).narrow()),
        })
    }
}

/// What turns three values at the corners into a linear function.
struct Slopes {
    origin: [f64; 2],
    edges: [[f64; 2]; 2],
    inverse_area: f64,
}

impl Slopes {
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
