//! What is on stage whatever the step: the clip region, and the subject polygon as given.

use crate::{
    figure::{Mark, Role, Shape},
    geom::{Polygon, extent},
};

use super::{Method, Scene};

/// The clip region of `method`, if it has one, and the subject's outlines as they were given.
#[must_use]
pub fn backdrop(scene: &Scene, method: Method, at_end: bool) -> Vec<Mark> {
    let clip = region(scene, method).map(|clip| vec![outline(&clip)]);
    let subject = scene.rings().map(outline).collect();
    let clip = clip.map(|clip| Mark::new(Role::Ink, Shape::Area(clip)).linked("window"));
    // What is not covered by the result has been cut off.
    let role = if at_end && method.info().clips {
        Role::Discarded
    } else {
        Role::Soft
    };
    let subject = Mark::new(role, Shape::Area(subject)).linked("subject");
    clip.into_iter().chain([subject]).collect()
}

/// The world rectangle that holds everything.
#[must_use]
pub fn bounds(scene: &Scene) -> [[f64; 2]; 2] {
    let clip = region(scene, scene.method);
    let rings = scene.rings().chain(&clip);
    extent(rings.flat_map(|ring| ring.vertices().iter().copied()))
}

/// What `method` clips against, if it clips.
fn region(scene: &Scene, method: Method) -> Option<Polygon> {
    method.info().clips.then(|| scene.clip_outline())
}

fn outline(polygon: &Polygon) -> Vec<[f64; 2]> {
    polygon.vertices().iter().map(|p| p.to_array()).collect()
}
