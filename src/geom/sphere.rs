//! Spheres around what is to be culled whole.

use glam::DVec3;

use super::{SpaceError, error::finite};

/// A closed ball; of radius 0 it is a point.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Sphere {
    center: [f64; 3],
    radius: f64,
}

impl Sphere {
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
    use crate::geom::random_bits;

    #[test]
    fn every_point_lies_in_the_sphere() {
        let mut bits = random_bits(11);
        let mut next = || (bits() >> 40) as f64 / f64::from(1 << 22) - 2.0;
        for n in [1, 2, 3, 4, 8, 40] {
            for _ in 0..100 {
                let points: Vec<[f64; 3]> =
                    (0..n).map(|_| [next(), 2.0 * next(), next()]).collect();
                let sphere = Sphere::around_centroid(&points).unwrap();
                let from_center = |&p| DVec3::from(p).distance(sphere.center().into());
                let is_in = |p| from_center(p) <= sphere.radius();
                assert!(points.iter().all(is_in), "{points:?}");
            }
        }
    }

    #[test]
    fn of_one_far_vertex_the_centroid_makes_too_much() {
        let points = [[0.0; 3], [0.0; 3], [0.0; 3], [8.0, 0.0, 0.0]];
        let sphere = Sphere::around_centroid(&points).unwrap();
        assert_eq!((sphere.center(), sphere.radius()), ([2.0, 0.0, 0.0], 6.0));
    }
}
