//! Most triangles that a ray's boxes lead to are passed by, and in f32 this can be told at once.
//!
//! The three determinants |r, Vᵢ, Vⱼ| of a [`RayTriangle`], side by side and turned so that inside all are positive. *Conservative*: one that is below
//! −bound is negative. With u = 2⁻²⁴ the three products and two sums are off by no more than 5.1·u of the sum of their sizes, for which
//! stands the sum of |Vᵢ × Vⱼ| times the largest of |r|; what the cross product was off by before is added. The bound has 8·u of it. Where numbers are so
//! large or so small that f32 would run over or under, the bound is infinite: then nothing is told, and the exact question is asked.

use std::{cmp::Ordering, ops::Range};

use super::ray_plane::RayTriangle;

/// Bounds that are used.
const BOUNDS: Range<f32> = 1e-24..1e18;
/// Largest components of lines that are used.
const LARGEST: Range<f32> = 1e-12..1e12;

/// Three edges in f32.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub(super) struct RoughEdges {
    /// By axis; the fourth edge is the first once more.
    normals: [[f32; 4]; 3],
    /// Of a line whose largest component is 1.
    bound: f32,
}

/// A line of sight in f32.
#[derive(Clone, Copy, Debug)]
pub(super) struct RoughLine {
    r: [f32; 3],
    largest: f32,
}

impl RoughEdges {
    /// Of a triangle that is shown.
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

    /// Does a line of sight surely not pass through it, nor along its edges?
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
