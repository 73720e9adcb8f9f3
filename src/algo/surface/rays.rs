//! The line of sight through each pixel's middle, and how deep a point on it lies.
//!
//! ```text
//!             raster = near plane           far plane
//!                 │                             │
//!   eye ●─────────┼──────●──────────────────────┼──►       p(t) = origin + t · direction
//!      t = 0      │    t = 2.4                  │
//!               t = 1                    t = far / near       depth = far/(far − near) · (1 − 1/t)
//! ```
//!
//! A parallel camera's rays start one unit before the near plane, so that t is 1 there too; their depth is
//! (t − 1) / (far − near).

use serde::Serialize;

use crate::{
    geom::{Sight, ViewVolume},
    trace::Real,
};

use super::{Surfaces, screen_triangle::Linear};

/// A line of sight in view space: all points `origin + t · direction`.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
pub struct Ray {
    /// The eye; of a parallel camera, one unit before the near plane.
    pub origin: [f64; 3],
    /// To the pixel's middle on the near plane, where t = 1.
    pub direction: [f64; 3],
}

impl Ray {
    /// The point at t.
    #[inline]
    #[must_use]
    pub fn at(&self, t: f64) -> [f64; 3] {
        std::array::from_fn(|i| self.origin[i] + t * self.direction[i])
    }
}

/// The lines of sight of a picture.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Rays {
    volume: ViewVolume,
    size: [u32; 2],
}

impl Rays {
    /// Through the pixels that these surfaces are asked at.
    #[must_use]
    pub const fn of(surfaces: &Surfaces) -> Self {
        Self::through_all(*surfaces.volume(), surfaces.size())
    }

    /// Through all pixels.
    pub(super) const fn through_all(volume: ViewVolume, size: [u32; 2]) -> Self {
        Self { volume, size }
    }

    /// Through the middle of a pixel.
    #[must_use]
    pub fn through(&self, [column, row]: [u32; 2]) -> Ray {
        let [width, height] = self.size.map(f64::from);
        let ndc = [
            (2.0 * f64::from(column) + 1.0) / width - 1.0,
            1.0 - (2.0 * f64::from(row) + 1.0) / height,
        ];
        let [half_x, half_y] = self.volume.half_size();
        let near = self.volume.near();
        let [x, y] = [ndc[0] * half_x, ndc[1] * half_y];
        match self.volume.sight() {
            Sight::Perspective => Ray {
                origin: [0.0; 3],
                direction: [x * near, y * near, -near],
            },
            Sight::Parallel => Ray {
                origin: [x, y, 1.0 - near],
                direction: [0.0, 0.0, -1.0],
            },
        }
    }

    /// t on the far plane.
    #[must_use]
    pub fn far(&self) -> f64 {
        let [near, far] = [self.volume.near(), self.volume.far()];
        match self.volume.sight() {
            Sight::Perspective => far / near,
            Sight::Parallel => 1.0 + (far - near),
        }
    }

    /// (z/w + 1) / 2 at t, after clip space and the divide: 0 on the near plane, 1 on the far plane.
    #[must_use]
    pub fn depth<R: Real>(&self, t: R) -> R {
        let (one, scale) = (R::new(1.0), R::new(self.scale()));
        match self.volume.sight() {
            Sight::Perspective => scale * (one - one / t),
            Sight::Parallel => scale * (t - one),
        }
    }

    /// t where the depth is this.
    #[must_use]
    pub fn t_at(&self, depth: f64) -> f64 {
        match self.volume.sight() {
            Sight::Perspective => 1.0 / (1.0 - depth / self.scale()),
            Sight::Parallel => 1.0 + depth / self.scale(),
        }
    }

    /// How far before the eye's plane t is: −z in view space.
    #[must_use]
    pub fn distance(&self, t: f64) -> f64 {
        match self.volume.sight() {
            Sight::Perspective => t * self.volume.near(),
            Sight::Parallel => t - 1.0 + self.volume.near(),
        }
    }

    /// How far away the near and the far plane are.
    #[must_use]
    pub fn ends(&self) -> [f64; 2] {
        [1.0, self.far()].map(|t| self.distance(t))
    }

    /// t at a distance before the eye's plane.
    #[must_use]
    pub fn t_of(&self, distance: f64) -> f64 {
        match self.volume.sight() {
            Sight::Perspective => distance / self.volume.near(),
            Sight::Parallel => distance - self.volume.near() + 1.0,
        }
    }

    fn scale(&self) -> f64 {
        let [near, far] = [self.volume.near(), self.volume.far()];
        match self.volume.sight() {
            Sight::Perspective => far / (far - near),
            Sight::Parallel => 1.0 / (far - near),
        }
    }

    /// The sum n·(x, y, z) + d over the picture's pixels, where the rays meet the plane at t = 1.
    fn over_pixels(&self, n: [f64; 3], [x0, y0, z0]: [f64; 3], scale: [f64; 2]) -> Linear<f64> {
        let [width, height] = self.size.map(f64::from);
        let by_column = n[0] * (2.0 / width) * scale[0];
        let by_row = -n[1] * (2.0 / height) * scale[1];
        Linear {
            at: n[0] * x0 + n[1] * y0 + n[2] * z0,
            by_column,
            by_row,
        }
    }

    /// Linear, as perspective leaves planes flat. `None` where the plane n·p + d = 0 is seen edge-on.
    pub(super) fn plane_depth(&self, n: [f64; 3], d: f64) -> Option<Linear<f64>> {
        let first = self.through([0, 0]);
        let [half_x, half_y] = self.volume.half_size();
        let (linear, factor, offset) = match self.volume.sight() {
            // 1/t = −(n·r)/d
            Sight::Perspective => {
                let near = self.volume.near();
                let linear = self.over_pixels(n, first.direction, [half_x * near, half_y * near]);
                (linear, self.scale() / d, self.scale())
            }
            // t = (n·o + d)/n_z
            Sight::Parallel => {
                let mut linear = self.over_pixels(n, first.origin, [half_x, half_y]);
                linear.at += d;
                (linear, self.scale() / n[2], -self.scale())
            }
        };
        let depth = Linear {
            at: linear.at * factor + offset,
            by_column: linear.by_column * factor,
            by_row: linear.by_row * factor,
        };
        let numbers = [depth.at, depth.by_column, depth.by_row];
        numbers.iter().all(|x| x.is_finite()).then_some(depth)
    }

    /// On which side of another plane the points of a plane lie that are seen at each pixel: positive where that one's normal points.
    pub(super) fn side_of_plane(
        &self,
        (n, d): ([f64; 3], f64),
        (other, other_d): ([f64; 3], f64),
    ) -> Linear<f64> {
        let first = self.through([0, 0]);
        let [half_x, half_y] = self.volume.half_size();
        // What the plane's own equation is subtracted, so often that what is unknown of the point falls out: its t, or its z.
        match self.volume.sight() {
            Sight::Perspective => {
                let times = other_d / d;
                let rest = std::array::from_fn(|i| other[i] - times * n[i]);
                let near = self.volume.near();
                self.over_pixels(rest, first.direction, [half_x * near, half_y * near])
            }
            Sight::Parallel => {
                let times = other[2] / n[2];
                let rest = [other[0] - times * n[0], other[1] - times * n[1], 0.0];
                let mut side = self.over_pixels(rest, first.origin, [half_x, half_y]);
                side.at += other_d - times * d;
                side
            }
        }
    }
}
