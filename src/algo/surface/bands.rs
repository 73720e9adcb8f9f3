//! Rows of a picture, few at a time: what is drawn into few finds their depths and samples near the processor.

use std::ops::Range;

use super::{ScreenTriangle, Viewport};

const PIXELS_AT_ONCE: u32 = 1 << 16;

/// Calls back with rows from the top, their pixels' places among those of all rows, and the triangles that reach there, in order.
pub(super) fn for_each_band<const N: usize>(
    triangles: &[ScreenTriangle<N>],
    viewport: &Viewport,
    rows: &Range<u32>,
    mut draw: impl FnMut(&Range<u32>, Range<usize>, &[u32]),
) {
    let [width, _] = viewport.size();
    let few = (PIXELS_AT_ONCE / width).max(1);
    let reaches = triangles.iter().map(ScreenTriangle::rows);
    let sorted = Sorted::new(reaches, rows, few);
    let place = |row: u32| ((row - rows.start) * width) as usize;
    for (nth, start) in rows.clone().step_by(few as usize).enumerate() {
        let band = start..(start + few).min(rows.end);
        let places = place(band.start)..place(band.end);
        draw(&band, places, sorted.of(nth));
    }
}

struct Sorted {
    /// Where those of each band begin, and where the last ones end.
    starts: Vec<u32>,
    triangles: Vec<u32>,
}

impl Sorted {
    /// By counting; each from its first row to the one after its last.
    fn new(reaches: impl Iterator<Item = Range<u32>> + Clone, rows: &Range<u32>, few: u32) -> Self {
        let n_rows = rows.end.saturating_sub(rows.start);
        let n_bands = n_rows.div_ceil(few) as usize;
        let bands = |reach: Range<u32>| {
            let within = |row: u32| row.saturating_sub(rows.start).min(n_rows);
            let [first, end] = [reach.start, reach.end].map(within);
            let bands = first / few..end.div_ceil(few);
            if first < end { bands } else { 0..0 }
        };
        // One further on, so that filling leaves each start where it belongs.
        let mut starts = vec![0; n_bands + 2];
        for reach in reaches.clone() {
            for band in bands(reach) {
                starts[band as usize + 2] += 1;
            }
        }
        for band in 2..starts.len() {
            starts[band] += starts[band - 1];
        }
        let n_all = starts.last().map_or(0, |&n| n as usize);
        let mut sorted = vec![0; n_all];
        for (nth, reach) in (0..).zip(reaches) {
            for band in bands(reach) {
                let place = &mut starts[band as usize + 1];
                sorted[*place as usize] = nth;
                *place += 1;
            }
        }
        Self {
            starts,
            triangles: sorted,
        }
    }

    fn of(&self, band: usize) -> &[u32] {
        &self.triangles[self.starts[band] as usize..self.starts[band + 1] as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_stands_in_every_band_that_it_reaches_into_in_its_order() {
        let rows = 3..20;
        let reaches: Vec<Range<u32>> = (0..24)
            .flat_map(|first| (0..24).map(move |end| first..end))
            .collect();
        for few in 1..20 {
            let sorted = Sorted::new(reaches.iter().cloned(), &rows, few);
            let bands = rows.clone().step_by(few as usize).enumerate();
            for (nth, start) in bands {
                let band = start..(start + few).min(rows.end);
                let meets = |reach: &Range<u32>| reach.clone().any(|row| band.contains(&row));
                let here = (0..).zip(&reaches).filter(|(_, reach)| meets(reach));
                let here: Vec<u32> = here.map(|(nth, _)| nth).collect();
                assert_eq!(sorted.of(nth), here, "{few} rows, band {nth}");
            }
        }
        assert!(Sorted::new([].into_iter(), &rows, 5).of(0).is_empty());
        #[expect(clippy::reversed_empty_ranges, reason = "that is what is asked")]
        let none = Sorted::new(std::iter::once(0..9), &(7..2), 5);
        assert!(none.triangles.is_empty(), "no rows, no bands");
    }
}
