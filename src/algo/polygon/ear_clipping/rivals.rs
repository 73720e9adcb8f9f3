//! Who may lie inside a candidate for an ear: only vertices that are not convex, in boxes in boxes.
//!
//! ```text
//!                v                 A chain that reaches into the candidate a v b turns away from v
//!               ╱ ╲                where it comes nearest: some vertex in there is reflex, or
//!              ╱ ● ╲               straight and on ab. Those are kept in the order of x, and in boxes
//!             ╱ ╱ ╲ ╲              of halves of halves of them: one that lies beyond a side of the
//!          a ● ╱   ╲ ● b           candidate, as a whole, is passed by with all that is in it.
//! ```

use std::ops::Range;

use crate::{geom::Point, trace::Real};

use super::{
    Ring,
    corner::{Corner, double_area},
};

/// As many are asked one after the other sooner than boxes are.
const MOST_IN_LAST_BOX: usize = 32;

/// The vertices that are not convex, by x. A vertex that has become convex is passed over.
#[derive(Clone, PartialEq, Debug, Default)]
pub(super) struct Rivals {
    by_x: Vec<u32>,
    /// Places in `by_x`, so that every box has a stretch of them; that of a last box is in order.
    order: Vec<u32>,
    /// Of each vertex its place in `order`.
    place_of: Vec<u32>,
    /// The outermost first; the halves of box k are 2k + 1 and 2k + 2.
    boxes: Vec<RivalBox>,
    n_convex: usize,
}

#[derive(Clone, Copy, PartialEq, Debug)]
struct RivalBox {
    min: [f64; 2],
    max: [f64; 2],
    /// Whoever is in it has this place in `by_x`, or a later one.
    first: u32,
    n_left: u32,
}

pub(super) struct Rival {
    pub vertex_idx: usize,
    /// Twice the area that it spans with each side of the triangle, from the side a v on: none negative.
    pub double_areas: [f64; 3],
}

impl Rivals {
    pub fn new(points: &[Point], ring: &Ring, corners: &[Option<Corner>]) -> Self {
        let mut by_x: Vec<u32> = ring.iter().map(|i| i as u32).collect();
        by_x.retain(|&i| corners[i as usize] != Some(Corner::Convex));
        by_x.sort_by(|&i, &j| {
            let [x, other] = [i, j].map(|i| points[i as usize].x());
            x.total_cmp(&other)
        });
        Self::boxed(by_x, points)
    }

    fn boxed(by_x: Vec<u32>, points: &[Point]) -> Self {
        let n_last = by_x.len().div_ceil(MOST_IN_LAST_BOX).next_power_of_two();
        let nothing = RivalBox {
            min: [f64::INFINITY; 2],
            max: [f64::NEG_INFINITY; 2],
            first: 0,
            n_left: 0,
        };
        let mut rivals = Self {
            order: (0..by_x.len() as u32).collect(),
            place_of: vec![0; points.len()],
            boxes: vec![nothing; 2 * n_last - 1],
            by_x,
            n_convex: 0,
        };
        rivals.divide(0, 0..rivals.order.len(), points);
        for (place, &nth) in rivals.order.iter().enumerate() {
            rivals.place_of[rivals.by_x[nth as usize] as usize] = place as u32;
        }
        rivals
    }

    /// Cuts a box's longer side so that half of its stretch comes to lie on either side.
    fn divide(&mut self, number: usize, places: Range<usize>, points: &[Point]) {
        let at = |nth: u32| points[self.by_x[nth as usize] as usize].to_array();
        let stretch = &mut self.order[places.clone()];
        let own = &mut self.boxes[number];
        for &nth in &*stretch {
            let p = at(nth);
            own.min = [0, 1].map(|axis| own.min[axis].min(p[axis]));
            own.max = [0, 1].map(|axis| own.max[axis].max(p[axis]));
        }
        own.n_left = stretch.len() as u32;
        own.first = stretch.iter().copied().min().unwrap_or_default();
        let [width, height] = [0, 1].map(|axis| own.max[axis] - own.min[axis]);
        let Some(halves) = halves(self.boxes.len(), number, &places) else {
            stretch.sort_unstable();
            return;
        };
        let (axis, middle) = (usize::from(height > width), stretch.len() / 2);
        if middle > 0 {
            stretch.select_nth_unstable_by(middle, |&i, &j| at(i)[axis].total_cmp(&at(j)[axis]));
        }
        for (number, places) in halves {
            self.divide(number, places, points);
        }
    }

    /// A vertex has become convex.
    pub fn one_less(&mut self, vertex_idx: usize, points: &[Point], corners: &[Option<Corner>]) {
        self.n_convex += 1;
        // Each vertex is boxed at most as often again as this halves their number.
        if self.n_convex * 2 > self.by_x.len() {
            let mut by_x = std::mem::take(&mut self.by_x);
            by_x.retain(|&i| corners[i as usize] != Some(Corner::Convex));
            *self = Self::boxed(by_x, points);
            return;
        }
        let place = self.place_of[vertex_idx] as usize;
        let mut next = Some((0, 0..self.order.len()));
        while let Some((number, places)) = next {
            self.boxes[number].n_left -= 1;
            let halves = halves(self.boxes.len(), number, &places);
            next = halves.and_then(|halves| {
                let mut halves = halves.into_iter();
                halves.find(|(_, places)| places.contains(&place))
            });
        }
    }

    /// The leftmost one in the closed triangle, which runs counter-clockwise; its own corners do not count.
    pub fn inside<R: Real>(
        &self,
        points: &[Point],
        triangle: [usize; 3],
        corners: &[Option<Corner>],
    ) -> Option<Rival> {
        let mut search = Search {
            rivals: self,
            points,
            corners,
            triangle,
            abc: triangle.map(|i| points[i]),
            found: None,
        };
        search.look_into::<R>(0, 0..self.order.len());
        let (nth, double_areas) = search.found?;
        Some(Rival {
            vertex_idx: self.by_x[nth as usize] as usize,
            double_areas,
        })
    }
}

/// Numbers and stretches of a box's halves; none of a last box.
fn halves(
    n_boxes: usize,
    number: usize,
    places: &Range<usize>,
) -> Option<[(usize, Range<usize>); 2]> {
    let middle = places.start + places.len() / 2;
    let halves = [
        (2 * number + 1, places.start..middle),
        (2 * number + 2, middle..places.end),
    ];
    (halves[1].0 < n_boxes).then_some(halves)
}

/// The diagonal first: nearly all of the polygon lies beyond it.
const SIDES: [usize; 3] = [2, 0, 1];

struct Search<'a> {
    rivals: &'a Rivals,
    points: &'a [Point],
    corners: &'a [Option<Corner>],
    triangle: [usize; 3],
    abc: [Point; 3],
    /// Its place in `by_x`, and its areas.
    found: Option<(u32, [f64; 3])>,
}

impl Search<'_> {
    fn look_into<R: Real>(&mut self, number: usize, places: Range<usize>) {
        let rivals = self.rivals;
        let Some([first, second]) = halves(rivals.boxes.len(), number, &places) else {
            self.ask_all::<R>(&rivals.order[places]);
            return;
        };
        // Who comes first in the order of x is in the half that begins first.
        let begins = |half: &(usize, Range<usize>)| rivals.boxes[half.0].first;
        let halves = if begins(&second) < begins(&first) {
            [second, first]
        } else {
            [first, second]
        };
        for (number, places) in halves {
            let half = &rivals.boxes[number];
            let is_late = self.found.is_some_and(|(nth, _)| nth < half.first);
            if half.n_left > 0 && !is_late && !self.is_beyond::<R>(half) {
                self.look_into::<R>(number, places);
            }
        }
    }

    /// Lies a box beyond one of the triangle's ends, or beyond a side? Exact.
    fn is_beyond<R: Real>(&self, one: &RivalBox) -> bool {
        let [[left, right], [bottom, top]] = self.extent().map(|ends| ends.map(R::new));
        let [[x0, y0], [x1, y1]] = [one.min, one.max].map(|corner| corner.map(R::new));
        if x1 < left || x0 > right || y1 < bottom || y0 > top {
            return true;
        }
        SIDES.into_iter().any(|side| {
            let [p, q] = [self.abc[side], self.abc[(side + 1) % 3]];
            // The corner that lies farthest inside.
            let x = if q.y() > p.y() {
                one.min[0]
            } else {
                one.max[0]
            };
            let y = if q.x() > p.x() {
                one.max[1]
            } else {
                one.min[1]
            };
            Point::new(x, y).is_ok_and(|corner| double_area::<R>(p, q, corner) < R::new(0.0))
        })
    }

    /// Those of a last box, from the left.
    fn ask_all<R: Real>(&mut self, stretch: &[u32]) {
        let [[left, right], [bottom, top]] = self.extent();
        for &nth in stretch {
            let vertex_idx = self.rivals.by_x[nth as usize] as usize;
            let p = self.points[vertex_idx];
            if p.x() > right || self.found.is_some_and(|(found, _)| found < nth) {
                return;
            }
            let is_other = !self.triangle.contains(&vertex_idx);
            let is_left = self.corners[vertex_idx] != Some(Corner::Convex);
            if p.x() < left || !is_other || !is_left {
                continue;
            }
            let y = R::new(p.y());
            if y < R::new(bottom) || y > R::new(top) {
                continue;
            }
            if let Some(double_areas) = self.areas::<R>(p) {
                self.found = Some((nth, double_areas));
                return;
            }
        }
    }

    /// What a point in the closed triangle spans with each of its sides.
    fn areas<R: Real>(&self, p: Point) -> Option<[f64; 3]> {
        let mut double_areas = [0.0; 3];
        for side in SIDES {
            let area = double_area::<R>(self.abc[side], self.abc[(side + 1) % 3], p);
            if area < R::new(0.0) {
                return None;
            }
            double_areas[side] = area.get();
        }
        Some(double_areas)
    }

    /// From left to right, and from bottom to top.
    fn extent(&self) -> [[f64; 2]; 2] {
        [Point::x, Point::y].map(|axis| {
            let [a, b, c] = self.abc.map(axis);
            [a.min(b).min(c), a.max(b).max(c)]
        })
    }
}
