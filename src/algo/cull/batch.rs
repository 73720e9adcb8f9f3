//! Many bounding spheres against one volume: [`super::SphereCull`] rearranged for speed. Every plane is asked, without a branch,
//! of four spheres and more at once, in f32. What rounding may take is given beforehand, so that no sphere is left out that the
//! exact test keeps; one that lies outside by less than about a millionth of its coordinates may be kept.

use crate::geom::{Plane, Sphere};

/// More than all roundings of a distance, as a part of what goes into it: each is at most 2⁻²⁴.
const SLACK: f32 = 1.0 / (1 << 21) as f32;

/// Spheres, coordinate by coordinate.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct SphereBatch {
    x: Vec<f32>,
    y: Vec<f32>,
    z: Vec<f32>,
    radius: Vec<f32>,
}

impl SphereBatch {
    /// One more.
    pub fn push(&mut self, sphere: &Sphere) {
        let [x, y, z] = sphere.center().map(|x| x as f32);
        let radius = sphere.radius() as f32;
        let size = x.abs() + y.abs() + z.abs() + radius;
        self.x.push(x);
        self.y.push(y);
        self.z.push(z);
        self.radius.push(radius + SLACK * size);
    }

    /// How many there are.
    #[must_use]
    pub const fn len(&self) -> usize {
        self.x.len()
    }

    /// Is there none?
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.x.is_empty()
    }

    /// Which of them are to be looked at further: not outside of any plane. `kept` is cleared first.
    pub fn keep(&self, planes: &[Plane; 6], kept: &mut Vec<bool>) {
        let planes = planes.map(|plane| {
            let scale = 1.0 / plane.length();
            let [a, b, c, d] = plane.to_array().map(|x| (x * scale) as f32);
            [a, b, c, d + SLACK * d.abs()]
        });
        let n = self.len();
        let (x, y, z) = (&self.x[..n], &self.y[..n], &self.z[..n]);
        let radius = &self.radius[..n];
        kept.clear();
        kept.extend((0..n).map(|i| {
            let n_inside: u8 = planes
                .iter()
                .map(|&[a, b, c, d]| u8::from(a * x[i] + b * y[i] + c * z[i] + d >= -radius[i]))
                .sum();
            n_inside == 6
        }));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        algo::{
            cull::{Containment, SphereCull, SphereCullInput},
            volume::signed_distance,
        },
        geom::{Camera, ViewVolume, random_bits},
        trace::silent,
    };

    #[test]
    fn many_at_once_are_kept_as_one_is() {
        let volume = ViewVolume::perspective(60.0, 1.5, 0.5, 20.0).unwrap();
        let (position, target) = ([9.0, -4.0, 700.0], [0.0, 0.0, 690.0]);
        let camera = Camera::new(position, target, [0.0, 1.0, 0.1], volume).unwrap();
        let planes = camera.planes_in_world();
        let mut bits = random_bits(5);
        let mut next = || (bits() >> 40) as f64 / f64::from(1 << 24);
        let (mut batch, mut spheres) = (SphereBatch::default(), Vec::new());
        for _ in 0..3003 {
            let [x, y, z] = [next(), next(), next()].map(|x| 40.0 * x - 20.0);
            let mut sphere = [x, y, 690.0 + z, 3.0 * next()];
            if next() < 0.3 {
                // It touches a plane, as nearly as f64 can tell.
                let plane = &planes[(6.0 * next()) as usize];
                let distance: f64 = signed_distance(plane, [sphere[0], sphere[1], sphere[2]]);
                sphere[3] = (-distance).max(0.0);
            }
            let sphere = Sphere::new(sphere).unwrap();
            batch.push(&sphere);
            spheres.push(sphere);
        }
        let mut kept = Vec::new();
        batch.keep(&planes, &mut kept);
        for (sphere, &kept) in spheres.into_iter().zip(&kept) {
            let planes = planes.to_vec();
            let output = silent::<SphereCull>(&SphereCullInput { planes, sphere });
            let by = -output.distances.last().unwrap() - sphere.radius();
            if output.class != Containment::Outside {
                assert!(kept, "{sphere:?}");
            } else if by > 2e-3 {
                assert!(!kept, "{sphere:?}, outside by {by}");
            }
        }
        assert!(kept.contains(&true) && kept.contains(&false));
    }
}
