//! Outlines and creases of solids with very many edges, found between the samples of their picture.

use std::ops::Range;

pub const NONE: u32 = u32::MAX;

/// Facets that turn from one another by more than this meet in a crease: the cosine, of 40°.
const CREASE: f32 = 0.77;
/// One surface is behind the other where depth changes by so many times what it changes on either side,
const STEP: f32 = 3.0;
/// and by so much at least.
const LEAST_STEP: f32 = 0.002;

/// Samples that are looked at together, as most are like their neighbours.
const BLOCK: usize = 64;

/// Of an outline in dashes, samples on and off.
const DASH: usize = 7;
const GAP: usize = 5;

#[derive(Default)]
pub struct Seen {
    pub n_columns: usize,
    /// Of the whole picture's.
    pub first_row: usize,
    pub depths: Vec<f32>,
    /// [`NONE`] where there is none.
    pub facets: Vec<u32>,
    pub texels: Vec<Option<[u8; 3]>>,
}

/// What is to be known of each facet.
#[derive(Clone, Copy)]
pub struct Lined<'a> {
    /// Of length 1.
    pub normals: &'a [[f32; 3]],
    /// Are its lines found here? Others are drawn one by one.
    pub are_found: &'a [bool],
    /// Are they dashed?
    pub are_dashed: &'a [bool],
}

/// Which samples lie beside a line, on either side of it.
pub fn outlines(seen: &Seen, lined: Lined<'_>) -> Vec<bool> {
    let n = seen.n_columns.max(1);
    let n_samples = seen.facets.len();
    let mut is_dark = vec![false; n_samples];
    for start in (0..n_samples).step_by(BLOCK) {
        let end = (start + BLOCK).min(n_samples);
        if seen.is_alike(start..end, 1) && seen.is_alike(start..end, n) {
            continue;
        }
        for at in start..end {
            let is_last_column = at % n == n - 1;
            for (step, is_edge) in [(1, is_last_column), (n, false)] {
                if !is_edge && at + step < n_samples && seen.is_parted(at, step, lined) {
                    is_dark[at] = true;
                    is_dark[at + step] = true;
                }
            }
        }
    }
    is_dark
}

impl Seen {
    fn is_alike(&self, samples: Range<usize>, step: usize) -> bool {
        let further = self.facets.get(samples.start + step..samples.end + step);
        further.is_some_and(|further| self.facets[samples] == *further)
    }

    fn is_parted(&self, at: usize, step: usize, lined: Lined<'_>) -> bool {
        let [a, b] = [at, at + step].map(|at| self.facets[at]);
        if a == b {
            return false;
        }
        // The line is that of what is nearer.
        let is_first = b == NONE || (a != NONE && self.depths[at] < self.depths[at + step]);
        let own = if is_first { a } else { b } as usize;
        let place = at % self.n_columns.max(1) + at / self.n_columns.max(1) + self.first_row;
        let is_gap = lined.are_dashed[own] && place % (DASH + GAP) >= DASH;
        if !lined.are_found[own] || is_gap {
            return false;
        }
        if a == NONE || b == NONE {
            return true;
        }
        let [n, m] = [a, b].map(|facet| lined.normals[facet as usize]);
        let cosine = n[0] * m[0] + n[1] * m[1] + n[2] * m[2];
        cosine < CREASE || self.has_step(at, step)
    }

    fn has_step(&self, at: usize, step: usize) -> bool {
        // Outside, and where there is nothing, depth is as it is beside it.
        let depth = |at: Option<usize>, beside: usize| {
            let known = at.filter(|&at| self.facets.get(at).is_some_and(|&facet| facet != NONE));
            self.depths[known.unwrap_or(beside)]
        };
        let [a, b] = [self.depths[at], self.depths[at + step]];
        let before = (a - depth(at.checked_sub(step), at)).abs();
        let after = (depth(Some(at + 2 * step), at + step) - b).abs();
        (b - a).abs() > STEP * (before + after) + LEAST_STEP
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn seen(facets: [u32; 5], depths: [f32; 5]) -> Seen {
        Seen {
            n_columns: 5,
            depths: [depths, depths].concat(),
            facets: [facets, facets].concat(),
            ..Seen::default()
        }
    }

    fn dark(facets: [u32; 5], depths: [f32; 5]) -> [bool; 5] {
        dark_of(facets, depths, [true; 3])
    }

    fn dark_of(facets: [u32; 5], depths: [f32; 5], are_found: [bool; 3]) -> [bool; 5] {
        // 0 and 1 lie in one plane, 2 stands across it.
        let normals = [[0.0, 0.0, 1.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]];
        let lined = Lined {
            normals: &normals,
            are_found: &are_found,
            are_dashed: &[false; 3],
        };
        let found = outlines(&seen(facets, depths), lined);
        assert_eq!(found[..5], found[5..], "both rows are alike");
        std::array::from_fn(|i| found[i])
    }

    #[test]
    fn lines_are_where_a_solid_ends_where_it_turns_and_where_it_is_before_another() {
        let even = [0.1, 0.2, 0.3, 0.4, 0.5];
        assert_eq!(dark([0, 0, 1, 1, 1], even), [false; 5], "one plane");
        let ends = [false, false, true, true, false];
        assert_eq!(dark([0, 0, 0, NONE, NONE], even), ends);
        assert_eq!(dark([0, 0, 0, 2, 2], even), ends);
        assert_eq!(dark([0, 0, 0, 1, 1], [0.1, 0.1, 0.1, 0.5, 0.5]), ends);
        // The line is that of the nearer one, which is drawn by itself or not.
        let step = [0.1, 0.1, 0.1, 0.5, 0.5];
        assert_eq!(dark_of([0, 0, 0, 1, 1], step, [true, false, false]), ends);
        let none = dark_of([0, 0, 0, 1, 1], step, [false, true, true]);
        assert_eq!(none, [false; 5]);
    }
}
