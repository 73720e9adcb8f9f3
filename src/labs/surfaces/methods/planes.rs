//! The plane of a triangle, and what is drawn of it.

use glam::DVec3;

use crate::{
    algo::surface::Surfaces,
    geom::{Camera, Plane},
    labs::space::prelude::*,
};

/// Inside where the triangle shows its front.
pub fn plane_of(surfaces: &Surfaces, id: u32) -> Option<Plane> {
    let triangle = surfaces.triangles().get(id as usize)?;
    let [a, b, c] = triangle.map(DVec3::from);
    let normal = (b - a).cross(c - a);
    let [x, y, z] = normal.to_array();
    Plane::new([x, y, z, -normal.dot(a)]).ok()
}

/// A part of it about the triangle.
pub fn plane_marks(triangle: &[[f64; 3]; 3], camera: &Camera, role: Role) -> [Mark3; 2] {
    const REACH: f64 = 1.28;
    let [a, b, c] = triangle.map(DVec3::from);
    let middle = (a + b + c) / 3.0;
    let along = (b - a).normalize_or_zero();
    let up = along.cross(c - a).cross(along).normalize_or_zero();
    let reach = [a, b, c].map(|at| at.distance(middle));
    let reach = REACH * reach.into_iter().fold(0.0, f64::max);
    let corners = [
        [-reach, -reach],
        [reach, -reach],
        [reach, reach],
        [-reach, reach],
    ]
    .map(|[u, v]| camera.world_from_view((middle + u * along + v * up).into()));
    [
        Mark3::new(role, Shape3::Wash(corners.to_vec())),
        Mark3::new(role, Shape3::Sheet(corners.to_vec())),
    ]
}
