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

use std::{
    convert::Infallible,
    ops::{ControlFlow, Range},
};

use super::{ScreenTriangle, Viewport, bands::for_each_band};

/// So many pixels beside each other are worked out at once: arrays and masks, which the compiler can vectorise.
pub const LANES: usize = 8;

/// Of pixels beside each other, from left to right.
pub type Lanes<T> = [T; LANES];

/// The first where all bits are set, the second where none is.
#[inline]
fn chosen(mask: Lanes<u32>, first: Lanes<u32>, second: Lanes<u32>) -> Lanes<u32> {
    std::array::from_fn(|lane| first[lane] & mask[lane] | second[lane] & !mask[lane])
}

/// Works on some numbers from a place on; beyond the end of the list they are `beyond`.
#[inline]
fn with_lanes<T: Copy, O>(
    list: &mut [T],
    place: usize,
    beyond: T,
    work: impl Fn(&mut Lanes<T>) -> O,
) -> O {
    let list = &mut list[place..];
    if let Some(lanes) = list.first_chunk_mut() {
        return work(lanes);
    }
    let mut lanes = [beyond; LANES];
    lanes[..list.len()].copy_from_slice(list);
    let output = work(&mut lanes);
    list.copy_from_slice(&lanes[..list.len()]);
    output
}

/// Draws triangles into some rows, in their order.
///
/// `depths` holds one number a pixel. What is nearer replaces it, and is put out by its place there, id and attributes, which are right
/// in perspective. Of equal depths the first stays.
pub fn draw_rows<const N: usize>(
    triangles: &[ScreenTriangle<N>],
    viewport: &Viewport,
    rows: Range<u32>,
    depths: &mut [f32],
    mut put: impl FnMut(usize, u32, [f32; N]),
) {
    for_each_band(triangles, viewport, &rows, |band, places, here| {
        let first = places.start;
        let depths = &mut depths[places];
        draw_band(
            here.iter().map(|&nth| &triangles[nth as usize]),
            viewport,
            band,
            depths,
            |place, id, is_nearer, attributes| {
                for lane in 0..LANES {
                    if is_nearer[lane] != 0 {
                        put(
                            first + place + lane,
                            id,
                            attributes.each_ref().map(|values| values[lane]),
                        );
                    }
                }
            },
        );
    });
}

/// The same on a clear picture: `samples` holds `background`, or what `shade` makes of the nearest id and attributes of some pixels
/// at once; what it says of those beyond the triangle or behind another is dropped.
pub fn shade_rows<const N: usize>(
    triangles: &[ScreenTriangle<N>],
    viewport: &Viewport,
    rows: Range<u32>,
    (depths, samples): (&mut [f32], &mut [u32]),
    background: u32,
    mut shade: impl FnMut(u32, &[Lanes<f32>; N]) -> Lanes<u32>,
) {
    for_each_band(triangles, viewport, &rows, |band, places, here| {
        let (depths, samples) = (&mut depths[places.clone()], &mut samples[places]);
        depths.fill(f32::INFINITY);
        samples.fill(background);
        draw_band(
            here.iter().map(|&nth| &triangles[nth as usize]),
            viewport,
            band,
            depths,
            |place, id, is_nearer, attributes| {
                let new = shade(id, attributes);
                with_lanes(samples, place, background, |samples| {
                    *samples = chosen(is_nearer, new, *samples);
                });
            },
        );
    });
}

/// Puts out the same as [`draw_rows`], some pixels beside each other at once, and all bits of those of them that are nearer.
#[inline]
fn draw_band<'a, const N: usize>(
    triangles: impl Iterator<Item = &'a ScreenTriangle<N>>,
    viewport: &Viewport,
    rows: &Range<u32>,
    depths: &mut [f32],
    mut put: impl FnMut(usize, u32, Lanes<u32>, &[Lanes<f32>; N]),
) {
    let width = viewport.size()[0];
    for triangle in triangles {
        for_each_span(triangle, viewport, rows, |row, columns| {
            let start = ((row - rows.start) * width + columns.start) as usize;
            let n = columns.end - columns.start;
            fill(triangle, [columns.start, row], start, n, depths, &mut put);
        });
    }
}

/// The pixels of one row, some at once: where none is nearer than what is there, nothing more is worked out.
#[inline]
fn fill<const N: usize>(
    triangle: &ScreenTriangle<N>,
    [column, row]: [u32; 2],
    start: usize,
    n: u32,
    depths: &mut [f32],
    put: &mut impl FnMut(usize, u32, Lanes<u32>, &[Lanes<f32>; N]),
) {
    let depth = triangle.depth.of::<f64>(column, row) as f32;
    let depth_step = triangle.depth.by_column as f32;
    let inverse_w = triangle.inverse_w.of(column, row);
    let first = triangle.attributes.map(|linear| linear.of(column, row));
    let end = n as f32;
    let mut steps: Lanes<f32> = std::array::from_fn(|lane| lane as f32);
    let mut place = start;
    while steps[0] < end {
        let along = |first: f32, step: f32| steps.map(|steps| first + step * steps);
        let new = along(depth, depth_step);
        let is_nearer = with_lanes(depths, place, f32::NEG_INFINITY, |stored| {
            let is_nearer = std::array::from_fn(|lane| {
                (u32::from(new[lane] < stored[lane]) & u32::from(steps[lane] < end)).wrapping_neg()
            });
            let bits = chosen(is_nearer, new.map(f32::to_bits), stored.map(f32::to_bits));
            *stored = bits.map(f32::from_bits);
            is_nearer
        });
        if is_nearer.iter().fold(0, |any, lane| any | lane) != 0 {
            let mut attributes = [[0.0; LANES]; N];
            if N > 0 {
                let w = along(inverse_w, triangle.inverse_w.by_column).map(|x| 1.0 / x);
                for (n, values) in attributes.iter_mut().enumerate() {
                    *values = along(first[n], triangle.attributes[n].by_column);
                    for (value, w) in values.iter_mut().zip(w) {
                        *value *= w;
                    }
                }
            }
            put(place, triangle.id, is_nearer, &attributes);
        }
        place += LANES;
        steps = steps.map(|step| step + LANES as f32);
    }
}

#[inline]
fn for_each_span<const N: usize>(
    triangle: &ScreenTriangle<N>,
    viewport: &Viewport,
    rows: &Range<u32>,
    mut span: impl FnMut(u32, Range<u32>),
) {
    let ControlFlow::Continue(()) = try_for_each_span(triangle, viewport, rows, |row, columns| {
        span(row, columns);
        ControlFlow::<Infallible>::Continue(())
    });
}

#[inline]
pub(super) fn try_for_each_span<const N: usize, S>(
    triangle: &ScreenTriangle<N>,
    viewport: &Viewport,
    rows: &Range<u32>,
    mut span: impl FnMut(u32, Range<u32>) -> ControlFlow<S>,
) -> ControlFlow<S> {
    let [first, turn, end] = triangle.rows;
    if first >= rows.end || end <= rows.start || first == end {
        return ControlFlow::Continue(());
    }
    let [top, middle, bottom] = triangle.corners;
    let start = first.max(rows.start);
    let mut long = Side::new(top, bottom, start, viewport);
    for is_lower in [false, true] {
        let (upper, lower, rows) = if is_lower {
            (middle, bottom, turn.max(rows.start)..end.min(rows.end))
        } else {
            (top, middle, start..turn.min(rows.end))
        };
        if rows.is_empty() {
            continue;
        }
        let mut short = Side::new(upper, lower, rows.start, viewport);
        for row in rows {
            let [left, right] = if triangle.is_long_left {
                [long.column, short.column]
            } else {
                [short.column, long.column]
            };
            if left < right {
                span(row, left as u32..right as u32)?;
            }
            long.step();
            short.step();
        }
    }
    ControlFlow::Continue(())
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
    #[inline]
    fn new(upper: [i32; 2], lower: [i32; 2], row: u32, viewport: &Viewport) -> Self {
        let pixel = viewport.pixel();
        let [upper, lower] = [upper, lower].map(|corner| corner.map(i64::from));
        let [dx, dy] = [lower[0] - upper[0], lower[1] - upper[1]];
        // Everything twice, so that half a pixel is a whole number even where there are no fractions.
        let row_middle = (2 * i64::from(row) + 1) * pixel;
        let whole = 2 * pixel * dy;
        let about_whole = 1.0 / whole as f64;
        let numerator = (2 * upper[0] - pixel) * dy + (row_middle - 2 * upper[1]) * dx;
        // Rounded up: the quotient q with numerator = q·whole + rest, −whole < rest ≤ 0.
        let column = -quotient(-numerator, whole, about_whole);
        let rest = numerator - column * whole;
        let numerator = 2 * pixel * dx;
        let step = quotient(numerator, whole, about_whole);
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

/// A whole number over another, rounded down, by about one over the other: below 2³⁰, the product errs by less than 1.
#[inline]
fn quotient(numerator: i64, whole: i64, about_inverse: f64) -> i64 {
    // Doubles from 2⁵² on hold whole numbers in their last bits.
    const WHOLE: f64 = 1.5 * (1_u64 << 52) as f64;
    let about =
        (numerator as f64 * about_inverse + WHOLE).to_bits() as i64 - WHOLE.to_bits() as i64;
    let rest = numerator - about * whole;
    about - i64::from(rest < 0) + i64::from(rest >= whole)
}
