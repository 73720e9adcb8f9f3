//! What the nearest triangle hides from the eye: the shadow that it throws on whatever lies behind it.

use crate::{algo::volume::clipped, geom::Camera};

use super::super::prelude::*;

/// Of every other triangle the part behind this one, in the world.
pub fn shadow(surfaces: &Surfaces, camera: &Camera, id: u32) -> Vec<Mark3> {
    let Some(planes) = surfaces.behind(id) else {
        return Vec::new();
    };
    let others = surfaces.ids().filter(|&other| other != id);
    let shaded = others.filter_map(|other| {
        let whole = surfaces.triangles()[other as usize].to_vec();
        let shaded = planes
            .iter()
            .fold(whole, |left, plane| clipped(&left, plane));
        (shaded.len() > 2).then(|| shaded.into_iter().map(|at| camera.world_from_view(at)))
    });
    let marks = shaded.flat_map(|corners| {
        let corners: Vec<[f64; 3]> = corners.collect();
        let wash = Mark3::new(Role::Ink, Shape3::Wash(corners.clone()));
        let outline = Mark3::new(Role::Ink, Shape3::Outline(corners));
        [wash, outline.dashed()]
    });
    marks.collect()
}
