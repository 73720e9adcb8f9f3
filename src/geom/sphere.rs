//! Spheres around what is to be culled whole.

use glam::DVec3;

use super::{SpaceError, space_error::finite};

/// A closed ball; of radius 0 it is a point.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Sphere {
    center: [f64; 3],
    radius: f64,
}

impl Sphere {
    /// `[x, y, z, r]`.
    ///
    /// # Errors
    /// [`SpaceError::NotFinite`]; [`SpaceError::NegativeRadius`].
    pub fn new([x, y, z, radius]: [f64; 4]) -> Result<Self, SpaceError> {
        finite(&[x, y, z, radius])?;
        if radius < 0.0 {
            return Err(SpaceError::NegativeRadius(radius));
        }
        let center = [x, y, z];
        Ok(Self { center, radius })
    }

    /// Around a centre, as far as the farthest of some points.
    ///
    /// # Errors
    /// [`SpaceError::NotFinite`]; [`SpaceError::NoVertices`].
    pub fn around(center: [f64; 3], points: &[[f64; 3]]) -> Result<Self, SpaceError> {
        if points.is_empty() {
            return Err(SpaceError::NoVertices);
        }
        finite(points.as_flattened())?;
        let [x, y, z] = center;
        let middle = DVec3::from(center);
        let distances = points.iter().map(|&p| DVec3::from(p).distance(middle));
        Self::new([x, y, z, distances.fold(0.0, f64::max)])
    }

    /// Around the centroid of the points, as S1 has it: sum of the vertices over their number, and the farthest vertex.
    ///
    /// # Errors
    /// As for [`Sphere::around`].
    pub fn around_centroid(points: &[[f64; 3]]) -> Result<Self, SpaceError> {
        let sum: DVec3 = points.iter().map(|&p| DVec3::from(p)).sum();
        let n = points.len().max(1) as f64;
        Self::around((sum / n).into(), points)
    }

    /// A tighter one: from two points that lie far apart the sphere grows just as far as every point needs; where that is
    /// no smaller, the centroid's.
    ///
    /// J. Ritter, "An efficient bounding sphere", *Graphics Gems*, 1990.
    ///
    /// # Errors
    /// As for [`Sphere::around`].
    pub fn tighter(points: &[[f64; 3]]) -> Result<Self, SpaceError> {
        let simple = Self::around_centroid(points)?;
        let farthest_from = |from: DVec3| {
            let all = points.iter().map(|&p| DVec3::from(p));
            all.fold(from, |far, p| {
                if p.distance_squared(from) > far.distance_squared(from) {
                    p
                } else {
                    far
                }
            })
        };
        let one = farthest_from(DVec3::from(points[0]));
        let other = farthest_from(one);
        let mut center = one.midpoint(other);
        let mut radius = 0.5 * one.distance(other);
        for p in points.iter().map(|&p| DVec3::from(p)) {
            let distance = p.distance(center);
            if distance > radius {
                radius = radius.midpoint(distance);
                center += (p - center) * ((distance - radius) / distance);
            }
        }
        let grown = Self::around(center.into(), points)?;
        Ok(if grown.radius < simple.radius {
            grown
        } else {
            simple
        })
    }

    /// As large, around another point, which is finite.
    pub(crate) const fn moved_to(&self, center: [f64; 3]) -> Self {
        Self { center, ..*self }
    }

    /// c
    #[must_use]
    pub const fn center(&self) -> [f64; 3] {
        self.center
    }

    /// r
    #[must_use]
    pub const fn radius(&self) -> f64 {
        self.radius
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_point_lies_in_both_spheres_and_the_second_is_no_larger() {
        let mut state = 11_u64;
        let mut next = || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1);
            (state >> 40) as f64 / f64::from(1 << 22) - 2.0
        };
        for n in [1, 2, 3, 4, 8, 40] {
            for _ in 0..100 {
                let points: Vec<[f64; 3]> =
                    (0..n).map(|_| [next(), 2.0 * next(), next()]).collect();
                let simple = Sphere::around_centroid(&points).unwrap();
                let tight = Sphere::tighter(&points).unwrap();
                for sphere in [simple, tight] {
                    let center = DVec3::from(sphere.center());
                    for &p in &points {
                        assert!(
                            DVec3::from(p).distance(center) <= sphere.radius(),
                            "{points:?}"
                        );
                    }
                }
                assert!(tight.radius() <= simple.radius(), "{points:?}");
            }
        }
    }

    #[test]
    fn of_one_far_vertex_the_centroid_makes_too_much() {
        let points = [[0.0; 3], [0.0; 3], [0.0; 3], [8.0, 0.0, 0.0]];
        let simple = Sphere::around_centroid(&points).unwrap();
        let tight = Sphere::tighter(&points).unwrap();
        assert_eq!((simple.center(), simple.radius()), ([2.0, 0.0, 0.0], 6.0));
        assert_eq!((tight.center(), tight.radius()), ([4.0, 0.0, 0.0], 4.0));
    }
}
