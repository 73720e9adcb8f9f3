//! Many segments at once, as a renderer has them: every segment takes the same steps without a branch, so that the compiler makes
//! vector instructions of the loop. The few whose answer rounding could change are done again by [`super::LiangBarsky`]: the
//! results are its, bit for bit. *Cost* a segment, whatever it is: 14 +, 16 ×, 4 ÷ and 46 comparisons.
//!
//! *Source*: Liang and Barsky (1984), rearranged here; clamping as in the slabs of T. L. Kay and J. T. Kajiya, "Ray Tracing
//! Complex Scenes", SIGGRAPH '86, pp. 269–278, doi:10.1145/15922.15916.
//!
//! ```
//! use clipscope::{algo::line::batch::{ClippedSegments, Segments, clip_all}, geom::{Segment, Window}};
//! let window = Window::new(-1.0, -1.0, 1.0, 1.0)?;
//! let segments: Segments = [Segment::new(-2.0, -1.0, 2.0, 1.5)?, Segment::new(2.0, 0.0, 3.0, 1.0)?].into_iter().collect();
//! let mut clipped = ClippedSegments::default();
//! clip_all(&window, &segments, &mut clipped);
//! assert_eq!(clipped.get(0), Some(Segment::new(-1.0, -0.375, 1.0, 0.875)?));
//! assert_eq!(clipped.get(1), None);
//! # Ok::<(), clipscope::geom::GeomError>(())
//! ```

use fearless_simd::{Level, dispatch};

use crate::geom::{Segment, Window};

use super::{
    Visible,
    kernel::{self, WindowBorders, closed_form},
};

/// Segments a turn: enough to fill vector registers many times, few enough that its arrays stay in the first-level cache.
const N_LANES: usize = 64;

type Lanes = [f64; N_LANES];

/// Segments by coordinate: four arrays of the same length.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Segments {
    coordinates: [Vec<f64>; 4],
}

impl Segments {
    /// With room for `n` segments.
    #[must_use]
    pub fn with_capacity(n: usize) -> Self {
        Self {
            coordinates: std::array::from_fn(|_| Vec::with_capacity(n)),
        }
    }

    /// Adds one at the end.
    pub fn push(&mut self, segment: Segment) {
        for (column, x) in self.coordinates.iter_mut().zip(segment.to_array()) {
            column.push(x);
        }
    }

    /// How many there are.
    #[must_use]
    pub const fn len(&self) -> usize {
        self.coordinates[0].len()
    }

    /// Are there none?
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.coordinates[0].is_empty()
    }

    /// One of them, of which there are so many.
    #[must_use]
    pub fn get(&self, idx: usize) -> Segment {
        Segment::from_finite(self.coordinates.each_ref().map(|column| column[idx]))
    }
}

impl FromIterator<Segment> for Segments {
    fn from_iter<I: IntoIterator<Item = Segment>>(segments: I) -> Self {
        let segments = segments.into_iter();
        let mut all = Self::with_capacity(segments.size_hint().0);
        segments.for_each(|segment| all.push(segment));
        all
    }
}

/// What [`clip_all`] answers: kept from batch to batch, so that nothing is allocated twice.
#[derive(Clone, Debug, Default)]
pub struct ClippedSegments {
    /// Of a segment that is not visible: any number.
    coordinates: [Vec<f64>; 4],
    visible: Vec<bool>,
}

impl ClippedSegments {
    /// How many segments were clipped.
    #[must_use]
    pub const fn len(&self) -> usize {
        self.visible.len()
    }

    /// Were there none?
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.visible.is_empty()
    }

    /// What is left of segment `idx`, of which there are so many.
    #[must_use]
    pub fn get(&self, idx: usize) -> Visible {
        self.visible[idx]
            .then(|| Segment::from_finite(self.coordinates.each_ref().map(|column| column[idx])))
    }

    /// What is left of each segment, in order.
    #[must_use]
    pub fn iter(&self) -> impl ExactSizeIterator<Item = Visible> + '_ {
        (0..self.len()).map(|idx| self.get(idx))
    }

    fn set(&mut self, idx: usize, visible: Visible) {
        self.visible[idx] = visible.is_some();
        if let Some(segment) = visible {
            for (column, x) in self.coordinates.iter_mut().zip(segment.to_array()) {
                column[idx] = x;
            }
        }
    }

    fn resize(&mut self, n: usize) {
        for column in &mut self.coordinates {
            column.resize(n, 0.0);
        }
        self.visible.resize(n, false);
    }
}

/// Clips every segment against `window`. `out` afterwards holds as many answers as there are segments.
pub fn clip_all(window: &Window, segments: &Segments, out: &mut ClippedSegments) {
    clip_all_at(Level::new(), window, segments, out);
}

/// With the vector instructions of a level that the machine has: the same operations in the same order, some lanes at a time.
fn clip_all_at(level: Level, window: &Window, segments: &Segments, out: &mut ClippedSegments) {
    let n = segments.len();
    out.resize(n);
    dispatch!(level, _ => clip_turns(window, segments, out));
    for idx in n - n % N_LANES..n {
        out.set(idx, kernel::clip(window, &segments.get(idx)));
    }
}

/// All turns that are full; compiled once for each level.
#[inline(always)]
fn clip_turns(window: &Window, segments: &Segments, out: &mut ClippedSegments) {
    let borders = WindowBorders::new(window);
    let mut status = [0; N_LANES];
    let columns = segments.coordinates.each_ref();
    let turns = columns.map(|column| column.as_chunks::<N_LANES>().0);
    for turn in 0..segments.len() / N_LANES {
        let [x1, y1, x2, y2] = &mut out.coordinates;
        let any = clip_turn(
            &borders,
            turns.map(|column| &column[turn]),
            [x1, y1, x2, y2].map(|column| &mut column.as_chunks_mut::<N_LANES>().0[turn]),
            &mut out.visible.as_chunks_mut::<N_LANES>().0[turn],
            &mut status,
        );
        if any {
            for lane in (0..N_LANES).filter(|&lane| status[lane] & UNCERTAIN != 0) {
                let idx = turn * N_LANES + lane;
                out.set(idx, kernel::clip_exactly(window, &segments.get(idx)));
            }
        }
    }
}

/// Bits of a status, which is as wide as a coordinate, so that the loop has one width.
const HIDDEN: u64 = 1;
const UNCERTAIN: u64 = 2;

/// Clips one turn of segments; true where an answer is uncertain.
#[inline(always)]
fn clip_turn(
    borders: &WindowBorders,
    [x1, y1, x2, y2]: [&Lanes; 4],
    [out_x1, out_y1, out_x2, out_y2]: [&mut Lanes; 4],
    visible: &mut [bool; N_LANES],
    status: &mut [u64; N_LANES],
) -> bool {
    let borders = *borders;
    for i in 0..N_LANES {
        let answer = closed_form([x1[i], y1[i], x2[i], y2[i]], &borders);
        [out_x1[i], out_y1[i], out_x2[i], out_y2[i]] = answer.ends;
        status[i] = u64::from(answer.hidden) * HIDDEN + u64::from(answer.uncertain) * UNCERTAIN;
    }
    let mut all = 0;
    for i in 0..N_LANES {
        visible[i] = status[i] & HIDDEN == 0;
        all |= status[i];
    }
    all & UNCERTAIN != 0
}

#[cfg(test)]
mod tests {
    use super::*;

    /// All that the machine has, the plainest first.
    fn levels() -> Vec<Level> {
        let best = Level::new();
        #[cfg(target_arch = "x86_64")]
        let between = best.as_sse4_2().map(fearless_simd::Simd::level);
        #[cfg(not(target_arch = "x86_64"))]
        let between = None;
        let levels = std::iter::once(Level::baseline()).chain(between);
        levels.chain([best]).collect()
    }

    /// Ties at corners and borders, and numbers of every size.
    fn segments() -> Segments {
        let small = |i: i32| f64::from(i % 7 - 3);
        let on_grid = (0..7_i32.pow(4)).map(|i| [i, i / 7, i / 49, i / 343].map(small));
        let mut state = 1_u64;
        let mut number = || {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            f64::from_bits(state & !(3 << 61) | (state >> 9 & 1) << 61)
        };
        let of_any_size = (0..20_000).map(|i| {
            let [a, b, c, d] = [(); 4].map(|()| number());
            if i % 2 == 0 {
                [a, b, c, d]
            } else {
                [a, b, c, d].map(|x| 3.0 * libm::sin(x))
            }
        });
        let all = on_grid.chain(of_any_size.filter(|s| s.iter().all(|x| x.is_finite())));
        all.map(|s| Segment::try_from(s).unwrap()).collect()
    }

    #[test]
    fn every_level_answers_with_the_same_bits() {
        let segments = segments();
        let bits = |visible: Visible| visible.map(|s| s.to_array().map(f64::to_bits));
        for window in [[-1.0, -1.0, 1.0, 1.0], [-2.0, 0.0, 3.0, 1e-300]] {
            let window = Window::try_from(window).unwrap();
            for level in levels() {
                let mut out = ClippedSegments::default();
                clip_all_at(level, &window, &segments, &mut out);
                assert_eq!(out.len(), segments.len());
                for (idx, visible) in out.iter().enumerate() {
                    let segment = segments.get(idx);
                    let expected = kernel::clip(&window, &segment);
                    assert_eq!(bits(visible), bits(expected), "{level:?}: {segment:?}");
                }
            }
        }
    }
}
