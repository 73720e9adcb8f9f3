//! Rows of a picture, few at a time: what is drawn into few finds their depths and samples near the processor.

use std::ops::Range;

use super::Viewport;

/// So many pixels are near enough.
const PIXELS_AT_ONCE: u32 = 1 << 16;
/// So many pixels take longer to fill than one triangle that it is somewhere else.
const PIXELS_A_QUESTION: usize = 16;

/// Calls back with some of the rows, from the top, and the places of their pixels among those of all rows. Every triangle has
/// to be asked whether it is there: where they are many, all rows come at once.
pub(super) fn for_each_band(
    n_triangles: usize,
    viewport: &Viewport,
    rows: &Range<u32>,
    mut draw: impl FnMut(&Range<u32>, Range<usize>),
) {
    let [width, _] = viewport.size();
    let few = (PIXELS_AT_ONCE / width).max(1);
    let n_rows = rows.end.saturating_sub(rows.start);
    let n_questions = n_triangles * n_rows.div_ceil(few) as usize;
    let is_cheap = n_questions * PIXELS_A_QUESTION <= (n_rows * width) as usize;
    let n_at_once = if is_cheap { few } else { n_rows.max(1) };
    let place = |row: u32| ((row - rows.start) * width) as usize;
    for start in rows.clone().step_by(n_at_once as usize) {
        let band = start..(start + n_at_once).min(rows.end);
        let places = place(band.start)..place(band.end);
        draw(&band, places);
    }
}
