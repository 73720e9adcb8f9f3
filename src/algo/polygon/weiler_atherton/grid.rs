//! Which edges of the clip polygon may meet an edge of the subject?
//!
//! ```text
//!   ┌───┬───┬───┬───┐     The common box of both polygons, cut into about as many cells as there are edges.
//!   │   │  ╱│   │   │     Each clip edge is entered in the cells that it passes through, row by row; an edge
//!   ├───┼─╱─┼───┼───┤     of the subject meets none but those in its own cells.
//!   └───┴╱──┴───┴───┘     Nothing is decided here: a cell too many costs a test, none is missed.
//! ```

use crate::{
    geom::{Point, Rings},
    trace::Real,
};

pub struct Grid {
    /// Lower left corner of the common box; upper right one.
    bounds: [[f64; 2]; 2],
    n_columns: usize,
    n_rows: usize,
    /// Cells for each quarter of a unit: coordinates are divided by 4 so that no difference overflows.
    scale: [f64; 2],
    /// Of each cell the first of its entries; and their number at the end.
    starts: Vec<u32>,
    entries: Vec<u32>,
    /// Of each clip edge the last subject edge that it was proposed to: once is enough.
    proposed: Vec<u32>,
}

/// How far beyond where an edge leaves a row it still counts as there: at least this much, in cells.
const MARGIN: f64 = 1e-9;

impl Grid {
    /// Enters every edge of `clip` that reaches into the box of `subject`.
    pub fn new<R: Real>(subject: &Rings, clip: &Rings) -> Self {
        let [a, b] = [subject, clip].map(bounds);
        let bounds = [
            [a[0][0].max(b[0][0]), a[0][1].max(b[0][1])],
            [a[1][0].min(b[1][0]), a[1][1].min(b[1][1])],
        ];
        let n_edges = subject.points().len() + clip.points().len();
        let [width, height] = [0, 1].map(|axis| 0.25 * bounds[1][axis] - 0.25 * bounds[0][axis]);
        let n_cells = n_edges as f64;
        let columns = (n_cells * (width / height)).sqrt().clamp(1.0, n_cells);
        // Without an extent there is one column.
        let n_columns = (columns as usize).max(1);
        let n_rows = ((n_cells / columns) as usize).max(1);
        let mut grid = Self {
            bounds,
            n_columns,
            n_rows,
            scale: [n_columns as f64 / width, n_rows as f64 / height],
            starts: Vec::new(),
            entries: Vec::new(),
            proposed: vec![u32::MAX; clip.points().len()],
        };
        grid.fill::<R>(clip);
        grid
    }

    fn fill<R: Real>(&mut self, clip: &Rings) {
        let mut passed: Vec<[u32; 2]> = Vec::with_capacity(4 * clip.points().len());
        for edge_idx in 0..clip.points().len() {
            self.each_cell::<R>(clip.edge(edge_idx), |cell| {
                passed.push([cell as u32, edge_idx as u32]);
            });
        }
        let n_cells = self.n_columns * self.n_rows;
        (self.entries, self.starts) = dealt(n_cells, passed.into_iter());
    }

    /// Calls `propose` once with every clip edge that may meet the subject's edge, in no particular order.
    pub fn candidates<R: Real>(
        &mut self,
        edge_idx: usize,
        edge: [Point; 2],
        mut propose: impl FnMut(usize),
    ) {
        let mut proposed = std::mem::take(&mut self.proposed);
        self.each_cell::<R>(edge, |cell| {
            let [start, end] = [self.starts[cell], self.starts[cell + 1]].map(|i| i as usize);
            for &clip_edge in &self.entries[start..end] {
                let last = &mut proposed[clip_edge as usize];
                if *last != edge_idx as u32 {
                    *last = edge_idx as u32;
                    propose(clip_edge as usize);
                }
            }
        });
        self.proposed = proposed;
    }

    /// Every cell that an edge passes through, and perhaps a few beside it. That an edge stays out of the common box is counted: where
    /// nothing crosses nothing else finds it out.
    fn each_cell<R: Real>(&self, edge: [Point; 2], mut visit: impl FnMut(usize)) {
        let [p, q] = edge.map(Point::to_array);
        let beyond = |axis: usize| {
            let (least, most) = if R::new(p[axis]) <= R::new(q[axis]) {
                (p[axis], q[axis])
            } else {
                (q[axis], p[axis])
            };
            R::new(most) < R::new(self.bounds[0][axis])
                || R::new(least) > R::new(self.bounds[1][axis])
        };
        if beyond(0) || beyond(1) {
            return;
        }
        // Monotone in each coordinate: a point between both ends lies between their cells.
        let [p, q] = [p, q].map(|point| [0, 1].map(|axis| self.in_cells(point[axis], axis)));
        let (low, high) = if p[1] <= q[1] { (p, q) } else { (q, p) };
        let [left, right] = [p[0].min(q[0]), p[0].max(q[0])];
        let column = |x: f64| (x as usize).min(self.n_columns - 1);
        let row = |y: f64| (y as usize).min(self.n_rows - 1);
        let rise = high[1] - low[1];
        // Coordinates have rounding errors of some ε times the largest; so have both differences, whose
        // quotient is multiplied by one of them.
        let largest = [left, right, low[1], high[1]]
            .map(f64::abs)
            .into_iter()
            .fold(0.0, f64::max);
        let margin = MARGIN + 16.0 * f64::EPSILON * largest * (largest / rise);
        for r in row(low[1])..=row(high[1]) {
            let (mut from, mut to) = (left, right);
            // An edge that hardly rises is in at most two rows, and may run all along both.
            if rise > 0.5 {
                let slope = (high[0] - low[0]) / rise;
                let at = |y: f64| low[0] + (y.clamp(low[1], high[1]) - low[1]) * slope;
                let [x0, x1] = [at(r as f64), at(r as f64 + 1.0)];
                from = from.max(x0.min(x1) - margin);
                to = to.min(x0.max(x1) + margin);
            }
            for c in column(from)..=column(to) {
                visit(r * self.n_columns + c);
            }
        }
    }

    /// A coordinate in cells from the corner. Far outside it stops where nothing can overflow.
    fn in_cells(&self, x: f64, axis: usize) -> f64 {
        let cells = (0.25 * x - 0.25 * self.bounds[0][axis]) * self.scale[axis];
        // NaN where a box without an extent meets its own corner: there is one cell.
        if cells.is_nan() { 0.0 } else { cells }
    }
}

/// The items of pairs of a key and an item, sorted by key (stably), and where each key's begin.
pub fn dealt(n_keys: usize, pairs: impl Iterator<Item = [u32; 2]> + Clone) -> (Vec<u32>, Vec<u32>) {
    let mut starts = vec![0_u32; n_keys + 2];
    for [key, _] in pairs.clone() {
        starts[key as usize + 2] += 1;
    }
    for key in 2..starts.len() {
        starts[key] += starts[key - 1];
    }
    let mut items = vec![0_u32; starts[n_keys + 1] as usize];
    for [key, item] in pairs {
        let place = &mut starts[key as usize + 1];
        items[*place as usize] = item;
        *place += 1;
    }
    (items, starts)
}

fn bounds(rings: &Rings) -> [[f64; 2]; 2] {
    crate::geom::extent(rings.points().iter().copied())
}
