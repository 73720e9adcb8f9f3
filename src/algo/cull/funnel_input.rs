//! What goes down the funnel, and what it is asked by.

use std::sync::Arc;

use crate::geom::{Camera, Matrix, Mesh, Sight, SpaceError, Sphere};

use super::{CullRules, Viewer};

/// What is to be drawn, and by whom it is seen.
#[derive(Clone, PartialEq, Debug)]
pub struct FunnelInput {
    /// Who culls.
    pub camera: Camera,
    /// In the order in which they are asked.
    pub objects: Vec<FunnelObject>,
}

/// An object in the world.
#[derive(Clone, PartialEq, Debug)]
pub struct FunnelObject {
    /// Around all of it.
    pub sphere: Sphere,
    /// Where its model's origin lies: no test that is right asks for it.
    pub origin: [f64; 3],
    /// Its faces, counter-clockwise as seen from outside.
    pub triangles: Arc<[[[f64; 3]; 3]]>,
}

impl FunnelObject {
    /// A mesh, moved into the world, in the sphere around the centroid of its vertices.
    ///
    /// # Errors
    /// [`SpaceError::NotFinite`] where it is moved beyond all numbers.
    pub fn new(mesh: &Mesh, world_from_model: &Matrix) -> Result<Self, SpaceError> {
        let placed = |p: [f64; 3]| world_from_model.point(p);
        let points = mesh.positions().iter().map(|p| placed(p.map(f64::from)));
        let corners = |&face| mesh.corners(face).map(placed);
        let triangles = mesh.faces().iter().map(corners);
        Ok(Self {
            sphere: Sphere::around_centroid(&points.collect::<Vec<_>>())?,
            origin: placed([0.0; 3]),
            triangles: triangles.collect(),
        })
    }
}

/// The camera whose planes spheres are asked of, by these rules.
#[must_use]
pub const fn asked_camera<L: CullRules>(camera: &Camera) -> Camera {
    if L::ONE_ANGLE {
        camera.with_one_angle()
    } else {
        *camera
    }
}

/// What is asked of planes, by these rules.
#[must_use]
pub fn asked_sphere<L: CullRules>(object: &FunnelObject) -> Sphere {
    if L::AROUND_ORIGIN {
        object.sphere.moved_to(object.origin)
    } else {
        object.sphere
    }
}

/// Who faces are asked by, through a camera, by these rules.
#[must_use]
pub fn asked_viewer<L: CullRules>(camera: &Camera) -> Viewer {
    match camera.volume().sight() {
        Sight::Perspective if !L::CONSTANT_VIEW => Viewer::Eye(camera.position()),
        Sight::Perspective | Sight::Parallel => {
            let [_, _, back] = camera.axes();
            Viewer::Direction(back.map(|x| -x))
        }
    }
}
