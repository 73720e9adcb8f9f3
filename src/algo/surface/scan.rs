//! Filling triangles, row by row.
//!
//! ```text
//!         ●  top                     a row's first pixel is the first whose middle is not left of the left edge,
//!        ╱·╲                         its end the first whose middle is not left of the right edge: so every middle
//!       ╱···╲                        belongs to one of two neighbours, and to one only (the top-left rule)
//!      ╱·····●  middle
//!     ●───────  bottom
//! ```
//!
//! Where an edge passes a row's middle is stepped in whole numbers with a remainder, as Bresenham does: no rounding.

use std::ops::Range;

use super::{ScreenTriangle, Viewport};

/// Draws triangles, in their order, into the pixels of some rows.
///
/// `depths` holds those rows, one number a pixel; what is nearer than the number there replaces it, and is put out by its
/// place in `depths`, its id, and its attributes, divided by w and multiplied again, so that they are right in
/// perspective. Of equal depths the first stays.
pub fn draw_rows<const N: usize>(
    triangles: &[ScreenTriangle<N>],
    viewport: &Viewport,
    rows: Range<u32>,
    depths: &mut [f32],
    mut put: impl FnMut(usize, u32, [f32; N]),
) {
    let width = viewport.size()[0];
    for triangle in triangles {
        for_each_span(triangle, viewport, &rows, |row, columns| {
            let offset = ((row - rows.start) * width) as usize;
            let start = offset + columns.start as usize;
            let span = &mut depths[start..offset + columns.end as usize];
            fill(triangle, [columns.start, row], start, span, &mut put);
        });
    }
}

/// As many pixels are worked out at once.
const LANES: usize = 4;

/// The pixels of one row, some at once: where none is nearer than what is there, nothing more is worked out.
#[inline]
fn fill<const N: usize>(
    triangle: &ScreenTriangle<N>,
    [column, row]: [u32; 2],
    start: usize,
    span: &mut [f32],
    put: &mut impl FnMut(usize, u32, [f32; N]),
) {
    let along = |first: f32, step: f32, done: usize| -> [f32; LANES] {
        std::array::from_fn(|lane| first + step * (done + lane) as f32)
    };
    let depth = triangle.depth.of::<f64>(column, row) as f32;
    let depth_step = triangle.depth.by_column as f32;
    let inverse_w = triangle.inverse_w.of(column, row);
    let first = triangle.attributes.map(|linear| linear.of(column, row));
    for (chunk_idx, stored) in span.chunks_mut(LANES).enumerate() {
        let done = chunk_idx * LANES;
        let depths = along(depth, depth_step, done);
        let is_nearer = stored
            .iter()
            .zip(depths)
            .any(|(stored, depth)| depth < *stored);
        if !is_nearer {
            continue;
        }
        let mut attributes = [[0.0; LANES]; N];
        if N > 0 {
            let w = along(inverse_w, triangle.inverse_w.by_column, done).map(|x| 1.0 / x);
            for (n, values) in attributes.iter_mut().enumerate() {
                *values = along(first[n], triangle.attributes[n].by_column, done);
                for (value, w) in values.iter_mut().zip(w) {
                    *value *= w;
                }
            }
        }
        for (lane, stored) in stored.iter_mut().enumerate() {
            if depths[lane] < *stored {
                *stored = depths[lane];
                put(
                    start + done + lane,
                    triangle.id,
                    attributes.each_ref().map(|values| values[lane]),
                );
            }
        }
    }
}

/// Calls back with every row, and the columns that the triangle covers there.
#[inline]
pub(super) fn for_each_span<const N: usize>(
    triangle: &ScreenTriangle<N>,
    viewport: &Viewport,
    rows: &Range<u32>,
    mut span: impl FnMut(u32, Range<u32>),
) {
    let [top, middle, bottom] = triangle.corners;
    let pixel = viewport.pixel();
    let [first, turn, end] = [top, middle, bottom].map(|[_, y]| first_row(y, pixel));
    let (from, to) = (i64::from(rows.start), i64::from(rows.end));
    if first >= to || end <= from {
        return;
    }
    let start = first.max(from);
    let mut long = Side::new(top, bottom, start, pixel);
    let halves = [
        (top, middle, start..turn.min(to)),
        (middle, bottom, turn.max(from)..end.min(to)),
    ];
    for (upper, lower, range) in halves {
        if range.is_empty() {
            continue;
        }
        let mut short = Side::new(upper, lower, range.start, pixel);
        for row in range {
            let [left, right] = if triangle.is_long_left {
                [long.column, short.column]
            } else {
                [short.column, long.column]
            };
            if left < right {
                span(row as u32, left as u32..right as u32);
            }
            long.step();
            short.step();
        }
    }
}

/// The first row whose middle does not lie above y: (y − pixel/2) / pixel, rounded up.
#[inline]
const fn first_row(y: i64, pixel: i64) -> i64 {
    -(pixel - 2 * y).div_euclid(2 * pixel)
}

/// An edge, row by row: the first column whose middle does not lie to its left.
#[derive(Clone, Copy, Debug)]
struct Side {
    column: i64,
    /// Of the numerator over `whole`: above −whole, up to 0.
    rest: i64,
    step: i64,
    step_rest: i64,
    whole: i64,
}

impl Side {
    /// At `row`, which the edge passes.
    fn new(upper: [i64; 2], lower: [i64; 2], row: i64, pixel: i64) -> Self {
        let [dx, dy] = [lower[0] - upper[0], lower[1] - upper[1]];
        // Everything twice, so that half a pixel is a whole number even where there are no fractions.
        let row_middle = (2 * row + 1) * pixel;
        let whole = 2 * pixel * dy;
        let numerator = (2 * upper[0] - pixel) * dy + (row_middle - 2 * upper[1]) * dx;
        // Rounded up: the quotient q with numerator = q·whole + rest, −whole < rest ≤ 0.
        let column = -(-numerator).div_euclid(whole);
        let rest = numerator - column * whole;
        let numerator = 2 * pixel * dx;
        let step = numerator.div_euclid(whole);
        Self {
            column,
            rest,
            step,
            step_rest: numerator - step * whole,
            whole,
        }
    }

    #[inline]
    fn step(&mut self) {
        self.column += self.step;
        self.rest += self.step_rest;
        if self.rest > 0 {
            self.column += 1;
            self.rest -= self.whole;
        }
    }
}
