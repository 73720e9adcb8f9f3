//! One line of sight and one triangle: where it meets the plane, and whether that point is of the triangle.
//!
//! ```text
//!                 n                n·p + d = 0         the plane
//!                  ╲   ╱           p = o + t·r         the ray
//!   o ●─────────────╳╱─────►       t = −(n·o + d) / (n·r)
//!                  ╱  r
//! ```
//!
//! Whether the ray passes inside is the sign of three determinants |r, Vᵢ, Vⱼ|, exact on the given coordinates: one for each edge, the side of
//! the plane through eye and edge that the ray runs on. On an edge the top-left rule decides, as it does for the rasteriser.

use std::{cmp::Ordering, ops::Range};

use crate::{
    geom::{Sight, minor_extent, sign_of_three},
    trace::Real,
};

use super::{Meeting, PlaneHit, Ray, Rays, Surfaces, coverage::TrianglePlane};

/// Bounds, and largest components of lines, that f32 takes without running over or under.
const BOUNDS: Range<f32> = 1e-24..1e18;
const LARGEST: Range<f32> = 1e-12..1e12;

#[derive(Clone, Copy, Debug)]
pub(super) struct RayTriangle {
    pub id: u32,
    pub corners: [[f64; 3]; 3],
    /// `Equal` where it is left out.
    pub turn: Ordering,
    n: [f64; 3],
    d: f64,
    /// So many times smaller n and d are, as a power of two.
    pub by: i32,
    /// Of each edge, Vᵢ × Vⱼ along the lines of sight, and the sums of the products' sizes.
    pub edges: [[[f64; 3]; 2]; 3],
    distances: [f64; 2],
}

impl RayTriangle {
    pub fn new(surfaces: &Surfaces, id: u32, corners: &[[f64; 3]; 3]) -> Self {
        let TrianglePlane { n, d, by } = TrianglePlane::of(corners);
        let lines = corners.map(|v| surfaces.sight_line(v));
        let edges = [0, 1, 2].map(|i| {
            let [p, q] = [lines[i], lines[(i + 1) % 3]];
            let products = |axis: usize| {
                let [j, k] = [(axis + 1) % 3, (axis + 2) % 3];
                [p[j] * q[k], p[k] * q[j]]
            };
            let normal = [0, 1, 2].map(|axis| {
                let [left, right] = products(axis);
                left - right
            });
            let size = [0, 1, 2].map(|axis| minor_extent(products(axis)));
            [normal, size]
        });
        let [a, b, c] = corners.map(|[_, _, z]| -z);
        Self {
            id,
            corners: *corners,
            turn: surfaces.shown_turn(corners),
            n,
            d,
            by,
            edges,
            distances: [a.min(b).min(c), a.max(b).max(c)],
        }
    }

    pub fn is_shown(&self) -> bool {
        self.turn != Ordering::Equal
    }

    /// Its corners, and where they would be as near as rounding can tell t of any of its points: n·p + d, which should be 0, over what t
    /// is divided by. So a box around these begins no later than any t that is told.
    pub fn reach(&self, surfaces: &Surfaces, eye_z: f64) -> [[f64; 3]; 6] {
        let (n, d) = (self.n, self.d);
        let (mut rest, mut size) = (0.0_f64, (n[2] * eye_z).abs());
        for v in self.corners {
            let products = [0, 1, 2].map(|i| n[i] * v[i]);
            rest = rest.max((products[0] + products[1] + products[2] + d).abs());
            size = size.max(products.iter().map(|x| x.abs()).sum::<f64>());
        }
        // Of four roundings is what t is divided by, and of four the other sum; t is one more. This leaves room for those here.
        let error = 4.0 * (rest + 16.0 * f64::EPSILON * (size + d.abs()));
        let is_told = |by: f64| (1e-250..1e250).contains(&by.abs()) && error < by.abs();
        let nearest = self
            .corners
            .map(|[x, y, z]| match surfaces.volume().sight() {
                Sight::Perspective if is_told(d) => [x, y, z].map(|x| x * (1.0 - error / d.abs())),
                Sight::Perspective => [0.0; 3],
                Sight::Parallel if is_told(n[2]) => {
                    [x, y, (z + error / n[2].abs()).min(eye_z).max(z)]
                }
                Sight::Parallel => [x, y, eye_z.max(z)],
            });
        let [a, b, c] = self.corners;
        let [near_a, near_b, near_c] = nearest;
        [a, b, c, near_a, near_b, near_c]
    }

    pub fn ask<R: Real>(&self, surfaces: &Surfaces, rays: &Rays, ray: &Ray) -> PlaneHit {
        let n = self.n.map(R::new);
        let [o, r] = [ray.origin, ray.direction].map(|v| v.map(R::new));
        if !self.is_shown() {
            return PlaneHit {
                numerator: 0.0,
                denominator: 0.0,
                t: None,
                meeting: Meeting::Culled,
            };
        }
        let numerator = n[0] * o[0] + n[1] * o[1] + n[2] * o[2] + R::new(self.d);
        let denominator = n[0] * r[0] + n[1] * r[1] + n[2] * r[2];
        let told = |t: Option<R>, meeting| PlaneHit {
            numerator: numerator.get(),
            denominator: denominator.get(),
            t: t.map(R::get),
            meeting,
        };
        if denominator == R::new(0.0) {
            return told(None, Meeting::Parallel);
        }
        let t = -numerator / denominator;
        let volume = surfaces.volume();
        let [nearest, farthest] = self.distances;
        let meeting = if t < R::new(0.0) {
            Meeting::Behind
        } else if nearest < volume.near() && (farthest < volume.near() || t < R::new(1.0)) {
            Meeting::BeforeNear
        } else if farthest > volume.far() && (nearest > volume.far() || t > R::new(rays.far())) {
            Meeting::BeyondFar
        } else if self.holds::<R>(surfaces, surfaces.sight_line(ray.at(1.0))) {
            Meeting::Hit
        } else {
            Meeting::Beside
        };
        told(Some(t), meeting)
    }

    fn holds<R: Real>(&self, surfaces: &Surfaces, r: [f64; 3]) -> bool {
        (0..3).all(|i| match self.side::<R>(surfaces, i, r) {
            Ordering::Equal => self.is_top_left(surfaces, i),
            side => side == self.turn,
        })
    }

    /// Which way r and the ends of an edge turn. As computed it decides where it is larger than its rounding.
    fn side<R: Real>(&self, surfaces: &Surfaces, i: usize, r: [f64; 3]) -> Ordering {
        let [m, size] = self.edges[i];
        let [m, r_counted] = [m, r].map(|v| v.map(R::new));
        let det = m[0] * r_counted[0] + m[1] * r_counted[1] + m[2] * r_counted[2];
        let size: f64 = (0..3).map(|axis| size[axis] * r[axis].abs()).sum();
        // A term has two products, a difference and three sums.
        let bound = 8.0 * f64::EPSILON * size;
        if (1e-250..1e250).contains(&size) && det.get().abs() > bound {
            let is_left = det < R::new(0.0);
            return if is_left {
                Ordering::Greater
            } else {
                Ordering::Less
            };
        }
        let [p, q] = [self.corners[i], self.corners[(i + 1) % 3]];
        surfaces.turn([r, p, q])
    }

    /// Does what lies on this edge belong to the triangle: is its inside to the right of it, or below it where it is level?
    fn is_top_left(&self, surfaces: &Surfaces, i: usize) -> bool {
        let [p, q] = [self.corners[i], self.corners[(i + 1) % 3]].map(|v| surfaces.sight_line(v));
        // How the side changes along an axis of the screen.
        let grows = |axis: [f64; 3]| {
            let sign = sign_of_three([axis, p, q]).reverse();
            if self.turn == Ordering::Greater {
                sign
            } else {
                sign.reverse()
            }
        };
        match grows([1.0, 0.0, 0.0]) {
            Ordering::Greater => true,
            Ordering::Less => false,
            Ordering::Equal => grows([0.0, 1.0, 0.0]) == Ordering::Less,
        }
    }
}

/// Whether a ray passes a triangle by, in f32: the three determinants |r, Vᵢ, Vⱼ| side by side, turned to be positive inside.
///
/// *Conservative*: one below −bound is negative. With u = 2⁻²⁴ the three products and two sums are off by no more than 5.1·u of the sum
/// of their sizes, for which stands the sum of |Vᵢ × Vⱼ| times the largest of |r|; what the cross product was off by is added. The
/// bound has 8·u of it. Where f32 would run over or under it is infinite: nothing is told, and the exact question is asked.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub(super) struct RoughEdges {
    /// By axis; the fourth edge is the first once more.
    normals: [[f32; 4]; 3],
    /// Of a line whose largest component is 1.
    bound: f32,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct RoughLine {
    r: [f32; 3],
    largest: f32,
}

impl RoughEdges {
    pub fn new(triangle: &RayTriangle) -> Self {
        let sign = if triangle.turn == Ordering::Greater {
            -1.0
        } else {
            1.0
        };
        let normals =
            [0, 1, 2].map(|axis| [0, 1, 2, 0].map(|i| (sign * triangle.edges[i][0][axis]) as f32));
        let bounds = triangle.edges.map(|[normal, size]| {
            let sum: f64 = normal.iter().map(|x| x.abs()).sum();
            let size: f64 = size.iter().sum();
            4.0 * f64::from(f32::EPSILON) * sum + 16.0 * f64::EPSILON * size
        });
        let bound = bounds.into_iter().fold(0.0, f64::max) as f32;
        Self {
            normals,
            bound: if BOUNDS.contains(&bound) {
                bound
            } else {
                f32::INFINITY
            },
        }
    }

    #[inline]
    pub fn are_missed(&self, line: &RoughLine) -> bool {
        let ([x, y, z], r) = (&self.normals, line.r);
        let mut lowest = f32::INFINITY;
        for i in 0..4 {
            let det = x[i] * r[0] + y[i] * r[1] + z[i] * r[2];
            lowest = if det < lowest { det } else { lowest };
        }
        lowest < -(self.bound * line.largest)
    }
}

impl RoughLine {
    #[inline]
    pub fn new(sight_line: [f64; 3]) -> Self {
        let r = sight_line.map(|x| x as f32);
        let largest = r.into_iter().fold(0.0, |most: f32, x| most.max(x.abs()));
        Self {
            r,
            largest: if LARGEST.contains(&largest) {
                largest
            } else {
                f32::INFINITY
            },
        }
    }
}
