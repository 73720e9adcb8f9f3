//! Boxes around boxes: most triangles are never asked.
//!
//! ```text
//!   ┌───────────────┐            A ray that misses a box misses all that is in it; one that has found something
//!   │ ┌───┐  ┌────┐ │  ───►      nearer than a box begins need not look into it. Which triangles go together is settled
//!   │ │△ △│  │△  △│ │            by the surfaces of their boxes: the chance that a ray which hits the outer box
//!   │ └───┘  └────┘ │            hits an inner one (J. D. MacDonald and K. S. Booth, "Heuristics for ray tracing using
//!   └───────────────┘            space subdivision", The Visual Computer 6, 1990, pp. 153–166).
//! ```
//!
//! Boxes are a little larger than what is in them, by more than the rounding of a ray's meeting with their sides. So what is
//! hit is what [`RayCasting`](super::RayCasting) hits: the same triangles are asked in the same way, only fewer of them.

use crate::geom::AlignedBox;

use super::{
    Ray, RayCastingOutput, RayHit, Rays, Surfaces, ray_casting::ray_triangles,
    ray_plane::RayTriangle,
};

/// So few triangles are not divided any more.
const MOST_IN_LEAF: usize = 4;
/// Where a box may be divided, along its longest side.
const N_BINS: usize = 12;
/// Divided no more than so often; beyond half of it, in the middle of the list.
const MOST_LEVELS: usize = 64;

/// Triangles in boxes in boxes.
pub struct Hierarchy {
    nodes: Vec<Node>,
    /// Those that can be seen at all, in the order of the leaves.
    triangles: Vec<RayTriangle>,
}

struct Node {
    min: [f64; 3],
    max: [f64; 3],
    /// Of a leaf its first triangle; else the first of two nodes.
    first: u32,
    /// None: it is no leaf.
    n_triangles: u32,
}

impl Hierarchy {
    /// Around all triangles that can be seen.
    #[must_use]
    pub fn new(surfaces: &Surfaces) -> Self {
        let triangles = ray_triangles(surfaces).filter(RayTriangle::is_shown);
        let mut hierarchy = Self {
            nodes: Vec::new(),
            triangles: triangles.collect(),
        };
        if hierarchy.triangles.is_empty() {
            return hierarchy;
        }
        let numbers = hierarchy.triangles.iter().flat_map(|t| t.corners);
        let largest = numbers.flatten().fold(0.0_f64, |most, x| most.max(x.abs()));
        // A box's side is met with a few roundings of numbers of this size.
        let margin = 64.0 * f64::EPSILON * largest;
        hierarchy.nodes.push(leaf(0, hierarchy.triangles.len()));
        let mut open = vec![(0, 0)];
        while let Some((node_idx, level)) = open.pop() {
            hierarchy.divide(node_idx, level, margin, &mut open);
        }
        hierarchy
    }

    /// What a ray hits first, and how many triangles were asked.
    #[must_use]
    pub fn cast(&self, surfaces: &Surfaces, rays: &Rays, ray: &Ray) -> (Option<RayHit>, u64) {
        let (mut nearest, mut n_asked): (Option<RayHit>, u64) = (None, 0);
        let inverse = ray.direction.map(|x| 1.0 / x);
        let mut open = [0_u32; 2 * MOST_LEVELS];
        let mut n_open = usize::from(!self.nodes.is_empty());
        while n_open > 0 {
            n_open -= 1;
            let node = &self.nodes[open[n_open] as usize];
            let limit = nearest.map_or(f64::INFINITY, |hit| hit.t);
            if node.met(ray, inverse).is_none_or(|t| t > limit) {
                continue;
            }
            let first = node.first as usize;
            if node.n_triangles == 0 {
                let begins = [first, first + 1].map(|i| self.nodes[i].met(ray, inverse));
                // What begins nearer is looked into first.
                let is_turned = match begins {
                    [Some(one), Some(other)] => one <= other,
                    [one, _] => one.is_some(),
                };
                let near_last = if is_turned { [1, 0] } else { [0, 1] };
                for i in near_last {
                    if begins[i].is_some() {
                        open[n_open] = node.first + i as u32;
                        n_open += 1;
                    }
                }
                continue;
            }
            for triangle in &self.triangles[first..first + node.n_triangles as usize] {
                n_asked += 1;
                let found = triangle.ask::<f64>(surfaces, rays, ray);
                let hit = found.hit::<f64>(triangle.id, rays);
                if hit.is_some_and(|hit| hit.is_nearer::<f64>(nearest.as_ref())) {
                    nearest = hit;
                }
            }
        }
        (nearest, n_asked)
    }

    /// A ray for every pixel: what [`RayCasting`](super::RayCasting) answers, but for how many were asked.
    #[must_use]
    pub fn picture(&self, surfaces: &Surfaces) -> RayCastingOutput {
        let rays = Rays::of(surfaces);
        let mut output = RayCastingOutput::empty(surfaces);
        let [width, height] = surfaces.size();
        for row in 0..height {
            for column in 0..width {
                let pixel = [column, row];
                let (hit, n_asked) = self.cast(surfaces, &rays, &rays.through(pixel));
                output.n_asked += n_asked;
                output.see(pixel, hit);
            }
        }
        output
    }

    /// Puts a leaf's box around its triangles, and makes two of it where that pays.
    fn divide(
        &mut self,
        node_idx: usize,
        level: usize,
        margin: f64,
        open: &mut Vec<(usize, usize)>,
    ) {
        let Node {
            first, n_triangles, ..
        } = self.nodes[node_idx];
        let range = first as usize..(first + n_triangles) as usize;
        let triangles = &mut self.triangles[range.clone()];
        // They are finite, and there is one.
        let Some(bounds) = around(triangles) else {
            return;
        };
        let node = &mut self.nodes[node_idx];
        node.min = bounds.min().map(|x| x - margin);
        node.max = bounds.max().map(|x| x + margin);
        if triangles.len() <= MOST_IN_LEAF || level + 1 == MOST_LEVELS {
            return;
        }
        let middles = triangles.iter().map(middle);
        let Ok(middles) = AlignedBox::around(middles) else {
            return;
        };
        let sides: [f64; 3] = std::array::from_fn(|i| middles.max()[i] - middles.min()[i]);
        let axis = (0..3).fold(0, |most, i| if sides[i] > sides[most] { i } else { most });
        let halving = triangles.len() / 2;
        let cut = best_cut(triangles, axis, middles.min()[axis], sides[axis])
            .filter(|_| level < MOST_LEVELS / 2);
        let n_left = match cut {
            Some(border) => {
                let is_left = |t: &RayTriangle| middle(t)[axis] < border;
                triangles.sort_by_key(|t| !is_left(t));
                triangles.partition_point(is_left)
            }
            None => {
                triangles.sort_by(|a, b| middle(a)[axis].total_cmp(&middle(b)[axis]));
                halving
            }
        };
        let left = self.nodes.len();
        let (start, n) = (range.start, range.len());
        self.nodes[node_idx].first = left as u32;
        self.nodes[node_idx].n_triangles = 0;
        self.nodes.push(leaf(start, n_left));
        self.nodes.push(leaf(start + n_left, n - n_left));
        open.extend([(left, level + 1), (left + 1, level + 1)]);
    }
}

impl Node {
    /// Where a ray comes in; none where it passes by. The eye may be inside.
    #[inline]
    fn met(&self, ray: &Ray, inverse: [f64; 3]) -> Option<f64> {
        let (mut from, mut to) = (0.0_f64, f64::INFINITY);
        for (axis, inverse) in inverse.into_iter().enumerate() {
            let o = ray.origin[axis];
            if ray.direction[axis] == 0.0 {
                if o < self.min[axis] || o > self.max[axis] {
                    return None;
                }
                continue;
            }
            let one = (self.min[axis] - o) * inverse;
            let other = (self.max[axis] - o) * inverse;
            from = from.max(one.min(other));
            to = to.min(one.max(other));
        }
        (from <= to).then_some(from)
    }
}

fn leaf(first: usize, n_triangles: usize) -> Node {
    Node {
        min: [0.0; 3],
        max: [0.0; 3],
        // There are fewer than 2³¹ triangles.
        first: first as u32,
        n_triangles: n_triangles as u32,
    }
}

fn middle(triangle: &RayTriangle) -> [f64; 3] {
    let [a, b, c] = triangle.corners;
    std::array::from_fn(|i| {
        let (low, high) = (a[i].min(b[i]).min(c[i]), a[i].max(b[i]).max(c[i]));
        low.midpoint(high)
    })
}

fn around(triangles: &[RayTriangle]) -> Option<AlignedBox> {
    AlignedBox::around(triangles.iter().flat_map(|t| t.corners)).ok()
}

/// Half the surface of a box.
fn surface(bounds: &AlignedBox) -> f64 {
    let [x, y, z]: [f64; 3] = std::array::from_fn(|i| bounds.max()[i] - bounds.min()[i]);
    x * y + y * z + z * x
}

/// The border between bins where the surfaces of both sides, each times its triangles, are the least; none where there is nothing to
/// tell apart.
fn best_cut(triangles: &[RayTriangle], axis: usize, low: f64, side: f64) -> Option<f64> {
    let width = side / N_BINS as f64;
    if width <= 0.0 {
        return None;
    }
    let mut bins: [Vec<&RayTriangle>; N_BINS] = std::array::from_fn(|_| Vec::new());
    for triangle in triangles {
        let bin = ((middle(triangle)[axis] - low) / width) as usize;
        bins[bin.min(N_BINS - 1)].push(triangle);
    }
    // Of the bins up to each border, from either end: how many, times the surface around them.
    let costs = |order: &mut dyn Iterator<Item = usize>| {
        let (mut corners, mut costs) = (Vec::<[f64; 3]>::new(), [0.0; N_BINS]);
        let mut n = 0;
        for i in order {
            n += bins[i].len();
            // The box so far stands for all that are in it.
            corners.extend(bins[i].iter().flat_map(|t| t.corners));
            let bounds = AlignedBox::around(corners.iter().copied()).ok();
            corners = bounds.map_or_else(Vec::new, |b| vec![b.min(), b.max()]);
            costs[i] = bounds.map_or(0.0, |b| n as f64 * surface(&b));
        }
        costs
    };
    let (left, right) = (costs(&mut (0..N_BINS)), costs(&mut (0..N_BINS).rev()));
    let borders = (1..N_BINS).map(|i| (left[i - 1] + right[i], low + i as f64 * width));
    let best = borders.min_by(|a, b| a.0.total_cmp(&b.0))?;
    let n_left = triangles
        .iter()
        .filter(|t| middle(t)[axis] < best.1)
        .count();
    (n_left > 0 && n_left < triangles.len()).then_some(best.1)
}
