//! Who may lie inside a candidate for an ear: only vertices that are not convex, asked from the left.
//!
//! ```text
//!                v                 A chain that reaches into the candidate a v b turns away from v
//!               ╱ ╲                where it comes nearest: some vertex in there is reflex, or
//!              ╱ ● ╲               straight and on ab. Those are kept in the order of x, so that
//!             ╱ ╱ ╲ ╲              only the ones between the candidate's left and right are asked.
//!          a ● ╱   ╲ ● b
//! ```

use crate::{geom::Point, trace::Real};

use super::{
    Ring,
    corner::{Corner, double_area},
};

/// The vertices that are not convex, by x. A vertex that has become convex is passed over.
#[derive(Clone, PartialEq, Debug, Default)]
pub(super) struct Rivals {
    by_x: Vec<usize>,
    n_convex: usize,
}

pub(super) struct Rival {
    pub vertex_idx: usize,
    /// Twice the area that it spans with each side of the triangle, from the side a v on: none negative.
    pub double_areas: [f64; 3],
}

impl Rivals {
    pub fn new(points: &[Point], ring: &Ring, corners: &[Option<Corner>]) -> Self {
        let mut by_x: Vec<usize> = ring.iter().collect();
        by_x.retain(|&i| corners[i] != Some(Corner::Convex));
        by_x.sort_by(|&i, &j| points[i].x().total_cmp(&points[j].x()));
        Self { by_x, n_convex: 0 }
    }

    pub fn one_less(&mut self, corners: &[Option<Corner>]) {
        self.n_convex += 1;
        // Each vertex is moved at most twice in all.
        if self.n_convex * 2 > self.by_x.len() {
            self.by_x.retain(|&i| corners[i] != Some(Corner::Convex));
            self.n_convex = 0;
        }
    }

    /// The leftmost one in the closed triangle, which runs counter-clockwise; its own corners do not count.
    pub fn inside<R: Real>(
        &self,
        points: &[Point],
        triangle: [usize; 3],
        corners: &[Option<Corner>],
    ) -> Option<Rival> {
        let abc = triangle.map(|i| points[i]);
        let [xs, ys] = [abc.map(Point::x), abc.map(Point::y)];
        let [left, right] = ends(xs);
        let [bottom, top] = ends(ys).map(R::new);
        let first = self.by_x.partition_point(|&i| points[i].x() < left);
        let in_reach = self.by_x[first..]
            .iter()
            .take_while(|&&i| points[i].x() <= right);
        let mut others =
            in_reach.filter(|&&i| corners[i] != Some(Corner::Convex) && !triangle.contains(&i));
        others.find_map(|&vertex_idx| {
            let p = points[vertex_idx];
            let y = R::new(p.y());
            if y < bottom || y > top {
                return None;
            }
            let mut double_areas = [0.0; 3];
            // The diagonal first: nearly all of the polygon lies beyond it.
            for side in [2, 0, 1] {
                let area = double_area::<R>(abc[side], abc[(side + 1) % 3], p);
                if area < R::new(0.0) {
                    return None;
                }
                double_areas[side] = area.get();
            }
            Some(Rival {
                vertex_idx,
                double_areas,
            })
        })
    }
}

fn ends([a, b, c]: [f64; 3]) -> [f64; 2] {
    [a.min(b).min(c), a.max(b).max(c)]
}
