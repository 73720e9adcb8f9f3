//! Which triangles share a box.
//!
//! ```text
//!   │ △  △△ │ △      │    △  │ △△ △△ │     twelve bins along an axis, by the middles of the triangles' boxes; the cost of a border
//!     2 · surface    ▲   6 · surface       is each side's triangles times the surface of the box around them
//! ```
//!
//! Of three times eleven borders the cheapest divides; then each side is divided again, until no border saves as much as one more box costs.
//! Every second generation is left out in the end: four grandchildren stand where two children stood.
//!
//! *Source*: J. D. MacDonald and K. S. Booth, "Heuristics for ray tracing using space subdivision", The Visual Computer 6, 1990, pp. 153–166;
//! I. Wald, "On fast construction of SAH-based bounding volume hierarchies", Symposium on Interactive Ray Tracing 2007, pp. 33–40.

use super::rounded_box::{Contents, FourBoxes, RoundedBox};

const MOST_IN_LEAF: usize = 4;
const N_BINS: usize = 12;
/// Divided by cost no more than so often; then in the middle of the list, which is over after 31 times.
const MOST_BY_COST: usize = 32;

#[derive(Clone, Copy)]
pub(super) struct Boxed {
    bounds: RoundedBox,
    middle: [f32; 3],
    pub place: u32,
}

/// Boxes that wait at once on the way down, at most: three of each generation, and one that is opened.
pub(super) const MOST_WAITING: usize = 3 * (MOST_BY_COST + 31) + 1;

pub(super) struct Division {
    /// The first is opened first.
    pub nodes: Vec<FourBoxes>,
    pub most_waiting: usize,
}

struct Half {
    bounds: RoundedBox,
    first: usize,
    /// None: two boxes.
    n_triangles: usize,
}

struct Cut {
    axis: usize,
    /// The first bin of the upper side.
    border: usize,
    cost: f32,
}

struct Bins {
    low: [f32; 3],
    scale: [f32; 3],
}

/// Puts them in the order of the leaves.
pub(super) fn divide(boxed: &mut [Boxed]) -> Division {
    let mut division = Division {
        nodes: Vec::new(),
        most_waiting: 1,
    };
    if !boxed.is_empty() {
        division.gather(&halves(boxed));
    }
    division
}

/// Two by two; each is followed by all that is in it.
fn halves(boxed: &mut [Boxed]) -> Vec<Half> {
    let mut halves = vec![Half::of(boxed, 0)];
    let mut open = vec![(0, 0)];
    while let Some((i, level)) = open.pop() {
        let Half {
            bounds,
            first,
            n_triangles: n,
        } = halves[i];
        let part = &mut boxed[first..first + n];
        let cut = Some(part.len())
            .filter(|&n| n > 1 && level < MOST_BY_COST)
            .and_then(|_| Cut::cheapest(part));
        let n_lower = match cut {
            Some((bins, cut)) => {
                // Another box is met at about the cost of a triangle that is asked.
                let saved = (n as f32 - 1.0) * bounds.surface() - cut.cost;
                if n <= MOST_IN_LEAF && saved <= 0.0 {
                    continue;
                }
                bins.part(part, &cut)
            }
            None if n <= MOST_IN_LEAF => continue,
            None => n / 2,
        };
        let (lower, upper) = part.split_at(n_lower);
        let next = halves.len();
        let two = [Half::of(lower, first), Half::of(upper, first + n_lower)];
        halves.extend(two);
        halves[i].first = next;
        halves[i].n_triangles = 0;
        open.extend([(next, level + 1), (next + 1, level + 1)]);
    }
    halves
}

impl Boxed {
    pub fn new(bounds: RoundedBox, place: u32) -> Self {
        Self {
            bounds,
            middle: bounds.middle(),
            place,
        }
    }
}

impl Half {
    fn of(part: &[Boxed], first: usize) -> Self {
        let empty = RoundedBox::EMPTY;
        Self {
            bounds: part.iter().fold(empty, |all, one| all.joined(&one.bounds)),
            first,
            n_triangles: part.len(),
        }
    }
}

impl Bins {
    #[inline]
    fn bin(&self, one: &Boxed, axis: usize) -> usize {
        let bin = (one.middle[axis] - self.low[axis]) * self.scale[axis];
        // No number is below 0; what is none counts as 0.
        (bin as usize).min(N_BINS - 1)
    }

    /// Those of the lower side first; how many.
    fn part(&self, part: &mut [Boxed], cut: &Cut) -> usize {
        let mut n_lower = 0;
        for i in 0..part.len() {
            if self.bin(&part[i], cut.axis) < cut.border {
                part.swap(i, n_lower);
                n_lower += 1;
            }
        }
        n_lower
    }
}

impl Cut {
    fn cheapest(part: &[Boxed]) -> Option<(Bins, Self)> {
        let middles = part.iter().fold(RoundedBox::EMPTY, |all, one| {
            all.joined(&RoundedBox {
                min: one.middle,
                max: one.middle,
            })
        });
        let sides: [f32; 3] = std::array::from_fn(|i| middles.max[i] - middles.min[i]);
        let bins = Bins {
            low: middles.min,
            scale: sides.map(|side| N_BINS as f32 / side),
        };
        let axes = (0..3).filter(|&axis| sides[axis] > 0.0);
        let cuts = axes.filter_map(|axis| Self::along(axis, part, &bins));
        let best = cuts.min_by(|a, b| a.cost.total_cmp(&b.cost))?;
        Some((bins, best))
    }

    /// The cheapest along an axis that leaves something on either side.
    fn along(axis: usize, part: &[Boxed], bins: &Bins) -> Option<Self> {
        let mut filled = [(RoundedBox::EMPTY, 0_u32); N_BINS];
        for one in part {
            let (bounds, n) = &mut filled[bins.bin(one, axis)];
            *bounds = bounds.joined(&one.bounds);
            *n += 1;
        }
        let cost = |(bounds, n): &(RoundedBox, u32)| *n as f32 * bounds.surface();
        let join = |(all, n): &mut (RoundedBox, u32), (bounds, m): &(RoundedBox, u32)| {
            *all = all.joined(bounds);
            *n += m;
        };
        let (mut lower, mut costs) = ((RoundedBox::EMPTY, 0), [f32::INFINITY; N_BINS]);
        for (border, bin) in (1..N_BINS).zip(&filled) {
            join(&mut lower, bin);
            costs[border] = cost(&lower);
        }
        let mut upper = (RoundedBox::EMPTY, 0);
        let mut best: Option<Self> = None;
        for border in (1..N_BINS).rev() {
            if filled[border].1 == 0 {
                // The same as with the border one further, or nothing yet.
                continue;
            }
            join(&mut upper, &filled[border]);
            if upper.1 as usize == part.len() {
                break;
            }
            let cost = costs[border] + cost(&upper);
            if best.as_ref().is_none_or(|best| cost < best.cost) {
                best = Some(Self { axis, border, cost });
            }
        }
        best
    }
}

impl Division {
    /// Four by four: of two boxes that with the larger surface gives way to what is in it.
    fn gather(&mut self, halves: &[Half]) {
        self.nodes.push(FourBoxes::EMPTY);
        let mut open = vec![(0, 0, 1)];
        while let Some((half, at, n_waiting)) = open.pop() {
            let mut four = vec![half];
            while four.len() < 4 {
                let divided = (0..four.len()).filter(|&i| halves[four[i]].n_triangles == 0);
                let surface = |&i: &usize| halves[four[i]].bounds.surface();
                let largest = divided.max_by(|a, b| surface(a).total_cmp(&surface(b)));
                let Some(i) = largest else { break };
                let first = halves[four[i]].first;
                four[i] = first;
                four.push(first + 1);
            }
            // The one that is opened next does not wait.
            let n_waiting = n_waiting + four.len() - 1;
            self.most_waiting = self.most_waiting.max(n_waiting);
            for (i, half) in four.into_iter().enumerate() {
                let Half {
                    bounds,
                    first,
                    n_triangles,
                } = &halves[half];
                let contents = if *n_triangles > 0 {
                    Contents::triangles(*first as u32, *n_triangles as u32)
                } else {
                    let place = self.nodes.len();
                    self.nodes.push(FourBoxes::EMPTY);
                    open.push((half, place, n_waiting));
                    Contents::boxes(place as u32)
                };
                self.nodes[at].put(i, bounds, contents);
            }
        }
    }
}
