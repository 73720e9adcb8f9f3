//! The samples of a picture of solids, averaged to pixels.

use std::{ops::Range, thread};

use egui::Color32;

use crate::figure::SolidPicture;

use super::solid_outlines::{NONE, Seen, outlines};

/// Fewer samples are drawn sooner by one thread.
const FEW: usize = 100_000;
/// More threads have too little to do.
const MOST_THREADS: usize = 4;

/// What pixels are made of.
pub struct Samples<'a> {
    /// Where facets are.
    pub picture: &'a SolidPicture<'a>,
    /// Of each facet.
    pub tones: &'a [Color32],
    /// Of the lines between facets, and how these are turned, where such lines are drawn.
    pub outline: Option<(Color32, &'a [[f32; 3]])>,
    /// Pixels in a row, and rows.
    pub size: [u32; 2],
    /// Samples for a pixel, in both directions.
    pub fine: u32,
}

impl Samples<'_> {
    /// Draws all rows, some by each thread.
    pub fn draw(&self, pixels: &mut [Color32]) {
        let [width, height] = self.size;
        let n_samples = (width * self.fine) as usize * (height * self.fine) as usize;
        let n_threads = thread::available_parallelism().map_or(1, usize::from);
        let n_threads = if n_samples < FEW { 1 } else { n_threads };
        let n_rows = height.div_ceil(n_threads.min(MOST_THREADS) as u32).max(1);
        let bands = pixels.chunks_mut((n_rows * width) as usize);
        let rows = (0..height)
            .step_by(n_rows as usize)
            .map(|first| first..(first + n_rows).min(height));
        let mut bands: Vec<_> = rows.zip(bands).collect();
        let last = bands.pop();
        thread::scope(|scope| {
            for (rows, pixels) in bands {
                scope.spawn(move || self.rows(rows, pixels));
            }
            if let Some((rows, pixels)) = last {
                self.rows(rows, pixels);
            }
        });
    }

    /// Some rows of pixels. The samples beside them say where outlines are.
    fn rows(&self, rows: Range<u32>, pixels: &mut [Color32]) {
        let n_columns = (self.size[0] * self.fine) as usize;
        let first = (rows.start * self.fine).saturating_sub(1);
        let end = (rows.end * self.fine + 1).min(self.size[1] * self.fine);
        let n_samples = (end - first) as usize * n_columns;
        let mut seen = Seen {
            n_columns,
            depths: vec![1.0; n_samples],
            facets: vec![NONE; n_samples],
        };
        self.picture
            .draw_rows(first..end, &mut seen.depths, &mut seen.facets);
        let is_dark = match self.outline {
            Some((_, normals)) => outlines(&seen, normals),
            None => Vec::new(),
        };
        let fine = self.fine as usize;
        let above = (rows.start * self.fine - first) as usize;
        for (row, pixels) in pixels.chunks_mut(self.size[0] as usize).enumerate() {
            let top = (above + row * fine) * n_columns;
            for (column, pixel) in pixels.iter_mut().enumerate() {
                let left = top + column * fine;
                let samples = (0..fine).flat_map(|i| {
                    let start = left + i * n_columns;
                    start..start + fine
                });
                *pixel = self.pixel(&seen, &is_dark, samples);
            }
        }
    }

    /// The mean of some samples.
    fn pixel(
        &self,
        seen: &Seen,
        is_dark: &[bool],
        samples: impl Iterator<Item = usize>,
    ) -> Color32 {
        let mut sum = [0; 4];
        let mut n = 0;
        for at in samples {
            n += 1;
            let facet = seen.facets[at];
            let tone = match self.outline {
                Some((ink, _)) if is_dark[at] => ink,
                _ if facet == NONE => continue,
                _ => self.tones[facet as usize],
            };
            for (sum, channel) in sum.iter_mut().zip(tone.to_array()) {
                *sum += u32::from(channel);
            }
        }
        let [r, g, b, a] = sum.map(|sum: u32| ((sum + n / 2) / n) as u8);
        Color32::from_rgba_premultiplied(r, g, b, a)
    }
}
