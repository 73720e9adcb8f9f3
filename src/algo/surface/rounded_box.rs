//! Boxes in f32, rounded outward, and which of four a ray meets.
//!
//! ```text
//!      x       ┌──────┐  far side of y       from = the largest t at which the ray comes between two sides
//!   ──────────►│      ├─────────────►        to   = the smallest t at which it leaves them
//!              └──────┘                      it meets the box where from ≤ to
//! ```
//!
//! A quarter of a node's bytes are read as numbers at once: four boxes lie side by side, so that what is done to one is done to four.
//!
//! *Conservative*: what the true ray meets is met here. With u = 2⁻²⁴ a side is below the true one by at least a step of f32 (or above it), an
//! origin is rounded to the other way, so a difference is too small before the box and too large behind it but for one rounding; the inverse
//! is off by one more, the product by a third. So `from` is no more than (1 + 3.01·u) times the true one and `to`, which is
//! lengthened by 16·u, no less than (1 + 11·u) times it. In a plane of a side the difference is not 0, so 0 · ∞ does not arise for a ray that
//! does not move across it. What is too large or too small for this to hold is let out: such a side is at infinity, and along such an axis
//! nothing is asked (its inverse is not a number, and what is not a number is never taken for the larger or the smaller).

use std::ops::Range;

use super::Ray;

/// Beyond it a side is at infinity.
const FARTHEST: f32 = (1_u64 << 60) as f32;
/// A direction is not larger, and its inverse is not.
const STEEPEST: f64 = (1_u64 << 40) as f64;
/// By so much a number that was rounded a few times is made larger than the true one.
const ABOVE: f32 = 1.0 + 8.0 * f32::EPSILON;

#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct RoundedBox {
    pub min: [f32; 3],
    pub max: [f32; 3],
}

/// Boxes side by side: of each axis, the lower and the upper sides.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub(super) struct FourBoxes {
    sides: [[[f32; 4]; 2]; 3],
    pub contents: [Contents; 4],
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Contents {
    /// Of its triangles, or its four boxes' place in the list.
    pub first: u32,
    n_triangles: u32,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct RayInBoxes {
    /// Of each axis, as seen from the side by which it comes in and from the other: not before the origin, and not behind it.
    origin: [[f32; 2]; 3],
    inverse: [f32; 3],
    /// By which side of each axis it comes in: 1 is the upper one.
    enters: [usize; 3],
}

impl RoundedBox {
    pub const EMPTY: Self = Self {
        min: [f32::INFINITY; 3],
        max: [f32::NEG_INFINITY; 3],
    };

    pub fn around(points: impl IntoIterator<Item = [f64; 3]>) -> Self {
        points.into_iter().fold(Self::EMPTY, |bounds, at| {
            bounds.joined(&Self {
                min: at.map(below),
                max: at.map(|x| -below(-x)),
            })
        })
    }

    #[inline]
    pub fn joined(&self, other: &Self) -> Self {
        Self {
            min: std::array::from_fn(|i| lesser(other.min[i], self.min[i])),
            max: std::array::from_fn(|i| greater(other.max[i], self.max[i])),
        }
    }

    /// Half of its surface.
    #[inline]
    pub fn surface(&self) -> f32 {
        let [x, y, z]: [f32; 3] = std::array::from_fn(|i| self.max[i] - self.min[i]);
        x * y + y * z + z * x
    }

    #[inline]
    pub fn middle(&self) -> [f32; 3] {
        std::array::from_fn(|i| 0.5 * self.min[i] + 0.5 * self.max[i])
    }
}

impl Contents {
    const BOXES: u32 = u32::MAX;

    pub const fn boxes(place: u32) -> Self {
        let n_triangles = Self::BOXES;
        Self {
            first: place,
            n_triangles,
        }
    }

    /// There are fewer than 2³¹.
    pub const fn triangles(first: u32, n_triangles: u32) -> Self {
        Self { first, n_triangles }
    }

    #[inline]
    pub const fn are_boxes(self) -> bool {
        self.n_triangles == Self::BOXES
    }

    #[inline]
    pub const fn range(self) -> Range<usize> {
        self.first as usize..(self.first + self.n_triangles) as usize
    }
}

impl FourBoxes {
    /// No ray meets these; one of which nothing can be asked finds no triangle in them.
    pub const EMPTY: Self = Self {
        sides: [[[f32::INFINITY; 4], [f32::NEG_INFINITY; 4]]; 3],
        contents: [Contents::triangles(0, 0); 4],
    };

    pub fn put(&mut self, i: usize, bounds: &RoundedBox, contents: Contents) {
        for (axis, [lower, upper]) in self.sides.iter_mut().enumerate() {
            lower[i] = bounds.min[axis];
            upper[i] = bounds.max[axis];
        }
        self.contents[i] = contents;
    }

    /// Where a ray comes into each, and a bit for each that it meets not beyond a limit. The eye may be inside.
    #[inline(always)]
    pub fn met(&self, ray: &RayInBoxes, limit: f32) -> ([f32; 4], u32) {
        let (mut from, mut to) = ([0.0; 4], [f32::INFINITY; 4]);
        for axis in 0..3 {
            let near = ray.enters[axis] & 1;
            let far = 1 - near;
            let (sides, inverse) = (&self.sides[axis], ray.inverse[axis]);
            let [before, behind] = ray.origin[axis];
            for i in 0..4 {
                from[i] = greater((sides[near][i] - before) * inverse, from[i]);
            }
            for i in 0..4 {
                to[i] = lesser((sides[far][i] - behind) * inverse, to[i]);
            }
        }
        let mut met = 0;
        for i in 0..4 {
            let to = lesser(to[i] * ABOVE, limit);
            met |= u32::from(from[i] <= to) << i;
        }
        (from, met)
    }
}

impl RayInBoxes {
    #[inline]
    pub fn new(ray: &Ray) -> Self {
        let mut new = Self {
            origin: [[0.0; 2]; 3],
            inverse: [f32::NAN; 3],
            enters: [0; 3],
        };
        for axis in 0..3 {
            let (o, r) = (ray.origin[axis], ray.direction[axis]);
            let rounded = o as f32;
            let [is_below, is_above] = [f64::from(rounded) < o, f64::from(rounded) > o];
            new.origin[axis] = [
                if is_below { rounded.next_up() } else { rounded },
                if is_above {
                    rounded.next_down()
                } else {
                    rounded
                },
            ];
            new.enters[axis] = usize::from(r < 0.0);
            if r < 0.0 {
                new.origin[axis].reverse();
            }
            if rounded.abs() >= FARTHEST {
                continue;
            }
            if r == 0.0 {
                new.inverse[axis] = f32::INFINITY;
            } else if (1.0 / STEEPEST..STEEPEST).contains(&r.abs()) {
                new.inverse[axis] = (1.0 / r) as f32;
            }
        }
        new
    }

    /// No box that holds what is met at t, or before, begins beyond it.
    #[inline]
    pub fn limit(t: f64) -> f32 {
        t as f32 * ABOVE
    }
}

/// A side below x.
fn below(x: f64) -> f32 {
    let rounded = (x as f32).next_down();
    if rounded < -FARTHEST {
        f32::NEG_INFINITY
    } else {
        rounded.min(FARTHEST)
    }
}

/// The other one where `a` is not a number.
#[inline]
fn lesser(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}

/// The other one where `a` is not a number.
#[inline]
fn greater(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}
