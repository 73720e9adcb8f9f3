//! What lies behind a triangle, as the eye sees it.

use glam::DVec3;

use crate::{
    algo::volume::signed_distance,
    geom::{Plane, pairs_around},
};

use super::Surfaces;

impl Surfaces {
    /// What lies inside of all of these is hidden by a triangle: beyond its plane, and between the planes from the eye through its edges.
    /// None where it is seen from its edge.
    #[must_use]
    pub fn behind(&self, id: u32) -> Option<[Plane; 4]> {
        let [x, y, z, w] = self.eye();
        let eye = DVec3::new(x, y, z);
        let [a, b, c] = self.triangles().get(id as usize)?.map(DVec3::from);
        let plane = |normal: DVec3, from: DVec3| {
            let [nx, ny, nz] = normal.to_array();
            Plane::new([nx, ny, nz, -normal.dot(from)]).ok()
        };
        let own = plane((b - a).cross(c - a), a)?;
        let is_before = DVec3::from(own.normal()).dot(eye) + own.d() * w > 0.0;
        let mut planes = [if is_before { own.turned() } else { own }; 4];
        let corners = [a, b, c];
        let edges = pairs_around(&corners).zip([c, a, b]);
        for (side, ([from, to], third)) in planes[1..].iter_mut().zip(edges) {
            *side = plane((to - from).cross(eye - w * from), from)?;
            if signed_distance::<f64>(side, third.into()) < 0.0 {
                *side = side.turned();
            }
        }
        Some(planes)
    }
}
