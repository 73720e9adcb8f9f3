//! What differs between two pictures: a rectangle, and how much of it.

use super::palette::{CLEAR, Plane};

/// What everyone has seen, and what takes time to read, in milliseconds: a picture that is new from edge to edge stands for both.
pub const LEAST_MS: u16 = 800;
pub const MORE_MS: f64 = 1_600.0;

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Change {
    pub min: [usize; 2],
    pub size: [usize; 2],
    n_pixels: usize,
}

impl Change {
    /// A picture that is as the one before has a pixel of it written again: there is no frame without.
    pub fn between(before: &Plane, now: &Plane) -> Self {
        assert_eq!(now.size, before.size, "a loop's pictures are alike");
        let [width, _] = now.size;
        let (mut min, mut max, mut n_pixels) = ([usize::MAX; 2], [0; 2], 0);
        let pairs = before.indices.iter().zip(&now.indices);
        for (i, _) in pairs.enumerate().filter(|(_, (was, is))| was != is) {
            let at = [i % width, i / width];
            n_pixels += 1;
            for axis in 0..2 {
                min[axis] = min[axis].min(at[axis]);
                max[axis] = max[axis].max(at[axis] + 1);
            }
        }
        if n_pixels == 0 {
            (min, max) = ([0; 2], [1; 2]);
        }
        Self {
            min,
            size: [max[0] - min[0], max[1] - min[1]],
            n_pixels,
        }
    }

    pub fn milliseconds(&self, of: &Plane) -> u16 {
        let share = self.n_pixels as f64 / of.indices.len() as f64;
        LEAST_MS + (MORE_MS * share.min(1.0).sqrt()).round() as u16
    }

    /// What of it is as it was is left empty, which takes next to no bytes.
    pub fn indices(&self, before: &Plane, now: &Plane) -> Vec<u8> {
        let [width, _] = now.size;
        let rows = self.min[1]..self.min[1] + self.size[1];
        let mut indices = Vec::with_capacity(self.size[0] * self.size[1]);
        for row in rows {
            let row = row * width + self.min[0]..row * width + self.min[0] + self.size[0];
            let pairs = before.indices[row.clone()].iter().zip(&now.indices[row]);
            indices.extend(pairs.map(|(was, is)| if was == is { CLEAR } else { *is }));
        }
        indices
    }
}
