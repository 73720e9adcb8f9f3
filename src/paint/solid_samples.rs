//! The samples of a picture of solids, averaged to pixels.

use egui::Color32;

use crate::figure::{Facet, SolidPicture};

/// No facet is seen.
const NONE: u32 = u32::MAX;

/// What pixels are made of.
pub struct Samples<'a> {
    /// Where facets are.
    pub picture: &'a SolidPicture<'a>,
    /// They themselves.
    pub facets: &'a [Facet],
    /// Of each of them.
    pub tones: &'a [Color32],
    /// Of the lines between them, where such lines are drawn.
    pub outline: Option<Color32>,
    /// Pixels in a row.
    pub width: u32,
    /// Samples for a pixel, in both directions.
    pub fine: u32,
}

impl Samples<'_> {
    /// Draws so many rows of pixels.
    pub fn draw(&self, height: u32, pixels: &mut [Color32]) {
        self.rows(0, height, pixels);
    }

    /// Some rows of pixels.
    fn rows(&self, first: u32, end: u32, pixels: &mut [Color32]) {
        let n_columns = (self.width * self.fine) as usize;
        let rows = first * self.fine..end * self.fine;
        let n_samples = rows.len() * n_columns;
        let mut depths = vec![1.0; n_samples];
        let mut seen = vec![NONE; n_samples];
        self.picture.draw_rows(rows, &mut depths, &mut seen);
        let fine = self.fine as usize;
        for (row, pixels) in pixels.chunks_mut(self.width as usize).enumerate() {
            let top = row * fine * n_columns;
            for (column, pixel) in pixels.iter_mut().enumerate() {
                let left = top + column * fine;
                let of_row = |i: usize| &seen[left + i * n_columns..][..fine];
                *pixel = self.pixel((0..fine).map(of_row));
            }
        }
    }

    fn pixel<'s>(&self, rows: impl Iterator<Item = &'s [u32]> + Clone) -> Color32 {
        let mut samples = rows.flatten();
        let mut sum = [0u32; 4];
        let mut n = 0;
        for &facet in &mut samples {
            n += 1;
            if facet != NONE {
                let tone = self.tones[facet as usize].to_array();
                for (sum, channel) in sum.iter_mut().zip(tone) {
                    *sum += u32::from(channel);
                }
            }
        }
        let [r, g, b, a] = sum.map(|sum| ((sum + n / 2) / n) as u8);
        Color32::from_rgba_premultiplied(r, g, b, a)
    }
}
