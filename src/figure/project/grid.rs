//! Which facets may hide a line: a grid over the picture, and in each of its cells the facets that reach into it.

use std::ops::RangeInclusive;

/// Of the picture so much on either side of its middle is divided into cells; what lies beyond belongs to the outermost.
const REACH: f64 = 2.0;
const MOST_CELLS: usize = 64;

#[derive(Clone, Debug)]
pub struct Grid {
    n: usize,
    /// Where each cell's facets start; one more at the end.
    starts: Vec<u32>,
    facets: Vec<u32>,
    n_facets: usize,
}

#[derive(Clone, Debug, Default)]
pub struct Found {
    facets: Vec<u32>,
    stamps: Vec<u32>,
    stamp: u32,
}

impl Found {
    fn begin(&mut self, n_facets: usize) {
        self.facets.clear();
        self.stamp = self.stamp.wrapping_add(1);
        if self.stamp == 0 || self.stamps.len() != n_facets {
            self.stamps.clear();
            self.stamps.resize(n_facets, 0);
            self.stamp = 1;
        }
    }

    fn add(&mut self, facet: u32) {
        let stamp = &mut self.stamps[facet as usize];
        if *stamp != self.stamp {
            *stamp = self.stamp;
            self.facets.push(facet);
        }
    }
}

impl Grid {
    pub fn new(bounds: &[Bounds]) -> Self {
        let n = (bounds.len() as f64).sqrt() as usize / 2;
        let mut grid = Self {
            n: n.clamp(1, MOST_CELLS),
            starts: Vec::new(),
            facets: Vec::new(),
            n_facets: bounds.len(),
        };
        let mut ends = vec![0_u32; grid.n * grid.n + 1];
        grid.for_each(bounds, |cell, _| ends[cell + 1] += 1);
        for cell in 1..ends.len() {
            ends[cell] += ends[cell - 1];
        }
        grid.starts.clone_from(&ends);
        let mut facets = vec![0; ends[grid.n * grid.n] as usize];
        grid.for_each(bounds, |cell, facet| {
            facets[ends[cell] as usize] = facet;
            ends[cell] += 1;
        });
        grid.facets = facets;
        grid
    }

    pub fn near<'a>(&self, [a, b]: [[f64; 2]; 2], found: &'a mut Found) -> &'a [u32] {
        found.begin(self.n_facets);
        for row in self.cells(a[1].min(b[1]), a[1].max(b[1])) {
            // The part of the segment in this row.
            let at = |y: f64| {
                let t = ((y - a[1]) / (b[1] - a[1])).clamp(0.0, 1.0);
                a[0] + t * (b[0] - a[0])
            };
            let [from, to] = if a[1] == b[1] {
                [a[0], b[0]]
            } else {
                [row, row + 1].map(|row| at(self.edge(row)))
            };
            for column in self.cells(from.min(to), from.max(to)) {
                let cell = row * self.n + column;
                let [start, end] = [cell, cell + 1].map(|i| self.starts[i] as usize);
                for &facet in &self.facets[start..end] {
                    found.add(facet);
                }
            }
        }
        &found.facets
    }

    fn for_each(&self, bounds: &[Bounds], mut put: impl FnMut(usize, u32)) {
        for (facet, bounds) in (0..).zip(bounds) {
            let Some([min, max]) = bounds.corners() else {
                continue;
            };
            for row in self.cells(min[1], max[1]) {
                for column in self.cells(min[0], max[0]) {
                    put(row * self.n + column, facet);
                }
            }
        }
    }

    fn cells(&self, low: f64, high: f64) -> RangeInclusive<usize> {
        let cell = |x: f64| {
            let at = (x + REACH) / (2.0 * REACH) * self.n as f64;
            // What is negative, or no number, becomes 0.
            (at as usize).min(self.n - 1)
        };
        cell(low)..=cell(high)
    }

    fn edge(&self, row: usize) -> f64 {
        match row {
            0 => f64::NEG_INFINITY,
            row if row == self.n => f64::INFINITY,
            row => row as f64 / self.n as f64 * 2.0 * REACH - REACH,
        }
    }
}

#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Bounds {
    min: [f64; 2],
    max: [f64; 2],
}

impl Bounds {
    pub const NOWHERE: Self = Self {
        min: [f64::INFINITY; 2],
        max: [f64::NEG_INFINITY; 2],
    };

    pub fn around(places: impl IntoIterator<Item = [f64; 2]>) -> Self {
        let grown = |of: Self, [x, y]: [f64; 2]| Self {
            min: [of.min[0].min(x), of.min[1].min(y)],
            max: [of.max[0].max(x), of.max[1].max(y)],
        };
        places.into_iter().fold(Self::NOWHERE, grown)
    }

    pub fn corners(&self) -> Option<[[f64; 2]; 2]> {
        (self.min[0] <= self.max[0]).then_some([self.min, self.max])
    }

    /// Has it a place in common with the line through these two? Where rounding leaves that open, it has.
    pub fn meets_line(&self, [a, b]: [[f64; 2]; 2]) -> bool {
        let along = [b[0] - a[0], b[1] - a[1]];
        let half = |i: usize| 0.5 * (self.max[i] - self.min[i]);
        let middle = |i: usize| 0.5 * (self.max[i] + self.min[i]) - a[i];
        let beside = (along[0] * middle(1) - along[1] * middle(0)).abs();
        let reach = along[0].abs() * half(1) + along[1].abs() * half(0);
        let size = along[0].abs() * middle(1).abs() + along[1].abs() * middle(0).abs();
        beside <= reach + 1e-9 * (reach + size)
    }

    pub fn meets(&self, other: &Self) -> bool {
        (0..2).all(|i| self.min[i] <= other.max[i] && other.min[i] <= self.max[i])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_facet_whose_box_a_segment_meets_is_near_it() {
        let at = |i: usize, n: usize| ((i * n) % 101) as f64 / 20.0 - 2.5;
        let boxes: Vec<[[f64; 2]; 2]> = (0..300)
            .map(|i| {
                let min = [at(i, 7), at(i, 13)];
                [min, [min[0] + 0.1, min[1] + 0.02 * (i % 9) as f64]]
            })
            .collect();
        let bounds: Vec<Bounds> = boxes.iter().map(|&it| Bounds::around(it)).collect();
        let grid = Grid::new(&bounds);
        assert!(grid.n > 4);
        let (mut n_met, mut n_near) = (0, 0);
        let mut found = Found::default();
        for i in 0..200 {
            let ends = [[at(i, 3), at(i, 17)], [at(i, 29), at(i, 41)]];
            let near = grid.near(ends, &mut found);
            n_near += near.len();
            for (facet, [min, max]) in (0..).zip(&boxes) {
                let is_met = (0..=50).any(|k| {
                    let t = f64::from(k) / 50.0;
                    (0..2).all(|axis| {
                        let x = ends[0][axis] + t * (ends[1][axis] - ends[0][axis]);
                        min[axis] <= x && x <= max[axis]
                    })
                });
                n_met += usize::from(is_met);
                assert!(!is_met || near.contains(&facet), "{ends:?} {facet}");
            }
        }
        assert!(n_met > 100 && n_near < 200 * 150, "{n_met} {n_near}");
    }

    #[test]
    fn a_line_meets_a_box_or_passes_beside_it() {
        let unit = Bounds::around([[1.0, 1.0], [2.0, 3.0]]);
        for (line, meets) in [
            ([[0.0, 0.0], [4.0, 4.0]], true),
            ([[0.0, 0.0], [4.0, 1.0]], false),
            // It goes through a corner, or along a side.
            ([[0.0, 0.0], [4.0, 2.0]], true),
            ([[2.0, -7.0], [2.0, -5.0]], true),
            ([[2.5, -7.0], [2.5, -5.0]], false),
            // A point, of which no line is known.
            ([[9.0, 9.0], [9.0, 9.0]], true),
        ] {
            assert_eq!(unit.meets_line(line), meets, "{line:?}");
        }
        assert!(!Bounds::NOWHERE.meets_line([[0.0, 0.0], [1.0, 1.0]]));
    }
}
