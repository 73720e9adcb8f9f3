//! Surfaces brought near 1 by a power of two, where products of their numbers as they are would leave the range of f64; and what is
//! found there, as it is of the surfaces that were given. In perspective the picture is the same, bit for bit. A parallel camera's rays
//! start one unit before the near plane, however small everything is: so its surfaces are not left much smaller than that.

use crate::geom::{Sight, times_power};

use super::{PlaneHit, Ray, RayHit, Rays, Surfaces, excess::excess};

pub(super) struct NearOne {
    pub surfaces: Surfaces,
    given: Rays,
    by: i32,
}

impl NearOne {
    pub fn of(surfaces: &Surfaces) -> Self {
        let by = excess(surfaces.volume(), surfaces.triangles().as_flattened());
        Self {
            surfaces: if by == 0 {
                surfaces.clone()
            } else {
                surfaces.scaled(-by)
            },
            given: Rays::of(surfaces),
            by,
        }
    }

    /// Is everything as it was given?
    #[inline]
    pub const fn is_given(&self) -> bool {
        self.by == 0
    }

    /// A ray of the camera that was given.
    pub fn ray(&self, ray: &Ray) -> Ray {
        let by = -self.by;
        match self.surfaces.volume().sight() {
            Sight::Perspective => Ray {
                direction: times_power(ray.direction, by),
                ..*ray
            },
            Sight::Parallel => {
                let [x, y, _] = times_power(ray.origin, by);
                Ray {
                    origin: [x, y, 1.0 - self.surfaces.volume().near()],
                    ..*ray
                }
            }
        }
    }

    /// The ray through a pixel, of the camera that was given.
    pub fn given_ray(&self, pixel: [u32; 2]) -> Ray {
        self.given.through(pixel)
    }

    /// What is told of a triangle whose plane's numbers are that power of two too small.
    #[cold]
    pub fn given_hit(&self, hit: &PlaneHit, of_plane: i32) -> PlaneHit {
        let t = hit.t.map(|t| self.given_t(t));
        let [numerator, denominator] = match self.surfaces.volume().sight() {
            Sight::Perspective => {
                times_power([hit.numerator, hit.denominator], of_plane + 3 * self.by)
            }
            Sight::Parallel => {
                let [denominator] = times_power([hit.denominator], of_plane + 2 * self.by);
                let [numerator] = times_power([hit.numerator], of_plane + 2 * self.by);
                [t.map_or(numerator, |t| -t * denominator), denominator]
            }
        };
        PlaneHit {
            numerator,
            denominator,
            t,
            ..*hit
        }
    }

    pub fn given_t(&self, t: f64) -> f64 {
        match self.surfaces.volume().sight() {
            Sight::Perspective => t,
            Sight::Parallel if self.is_given() => t,
            Sight::Parallel => {
                let [beyond_near] = times_power([t - 1.0], self.by);
                1.0 + beyond_near
            }
        }
    }

    pub fn given_nearest(&self, hit: Option<RayHit>) -> Option<RayHit> {
        hit.map(|hit| RayHit {
            t: self.given_t(hit.t),
            ..hit
        })
    }
}
