//! The screen, and a triangle on it, ready to be filled.

use std::ops::Range;

use crate::trace::Real;

/// Pixels, row by row from the top left; each is sampled in its middle.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Viewport {
    size: [u32; 2],
    subpixel_bits: u32,
}

impl Viewport {
    /// As wide, and as high, as a picture may be.
    pub const MAX_SIDE: u32 = 4096;
    /// Fractions of a pixel that pictures need.
    pub const PICTURE_BITS: u32 = 8;
    /// Fractions of a pixel that answers need: no sample farther from an edge than that is on the wrong side.
    pub const ANSWER_BITS: u32 = 16;

    /// From 1 to [`Viewport::MAX_SIDE`] columns and rows, and 0 to 16 bits for fractions of a pixel; `None` beyond that.
    #[must_use]
    pub fn new(size: [u32; 2], subpixel_bits: u32) -> Option<Self> {
        let is_usable = size.iter().all(|side| (1..=Self::MAX_SIDE).contains(side))
            && subpixel_bits <= Self::ANSWER_BITS;
        is_usable.then_some(Self {
            size,
            subpixel_bits,
        })
    }

    /// Columns and rows.
    #[must_use]
    pub const fn size(&self) -> [u32; 2] {
        self.size
    }

    /// One pixel, in the units that vertices are snapped to.
    #[must_use]
    pub const fn pixel(&self) -> i64 {
        1 << self.subpixel_bits
    }

    /// The first row whose middle is not above y, or column whose middle is not left of x: ⌈(y − pixel/2) / pixel⌉.
    #[inline]
    pub(super) const fn first_middle(&self, y: i32) -> u32 {
        // y is not negative.
        (2 * y as u32 + (1 << self.subpixel_bits) - 1) >> (self.subpixel_bits + 1)
    }

    /// Where a point of the square −1 to 1 lies, in pixels from the top left, y down.
    #[inline]
    #[must_use]
    pub fn screen_from_ndc<R: Real>(&self, [x, y]: [R; 2]) -> [R; 2] {
        let [width, height] = self.size.map(|side| R::new(f64::from(side)));
        let half = R::new(0.5);
        [(half * x + half) * width, (half - half * y) * height]
    }

    /// The same, snapped; within the picture's edges.
    #[inline]
    pub(super) fn snapped(&self, ndc: [f64; 2]) -> [i32; 2] {
        let [x, y] = self.screen_from_ndc(ndc);
        let pixel = self.pixel() as f64;
        let snap = |along: f64, side: u32| {
            // To the nearest: what is cast is not negative.
            let (snapped, most) = (along * pixel + 0.5, f64::from(side) * pixel);
            let snapped = if snapped > 0.0 { snapped } else { 0.0 };
            (if snapped < most { snapped } else { most }) as i32
        };
        [snap(x, self.size[0]), snap(y, self.size[1])]
    }
}

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

/// Linear over the screen: the value in the middle of pixel (0, 0), and its steps from column to column and row to row.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Linear<T> {
    pub at: T,
    pub by_column: T,
    pub by_row: T,
}

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

    #[inline]
    pub fn of<R: Real>(&self, column: u32, row: u32) -> R {
        let [at, by_column, by_row] = [self.at, self.by_column, self.by_row].map(R::new);
        at + by_column * R::new(column.into()) + by_row * R::new(row.into())
    }
}

impl Linear<f32> {
    #[inline]
    pub fn of(&self, column: u32, row: u32) -> f32 {
        self.at + self.by_column * column as f32 + self.by_row * row as f32
    }
}
