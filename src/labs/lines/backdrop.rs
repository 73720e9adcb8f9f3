//! What is on stage whatever the method and the step: the window and the segments out of focus.

use crate::{
    figure::{Mark, Role, Shape},
    geom::extent,
};

use super::{Method, Scene, crowd::crowd};

/// What lies under a step's marks: the clip region of `method`, and the segments out of focus. These show
/// what becomes of them once the focused one is decided (`at_end`), so as not to answer first.
#[must_use]
pub fn backdrop(scene: &Scene, method: Method, at_end: bool) -> Vec<Mark> {
    let region = scene.region(method);
    let outline = region.vertices().iter().map(|p| p.to_array()).collect();
    let mut marks = vec![Mark::new(Role::Ink, Shape::Area(vec![outline])).linked("window")];
    marks.extend(crowd(scene, at_end));
    marks
}

/// Up to this many segments are looked at one by one: a view shows all of them at first. Of more, the one in focus.
pub const MAX_FITTED: usize = 20;

/// The world rectangle that holds the clip region and the segments that matter: what a view shows at first.
#[must_use]
pub fn bounds(scene: &Scene) -> [[f64; 2]; 2] {
    let focused = [scene.focused()];
    let segments = match scene.segments() {
        few if few.len() <= MAX_FITTED => few,
        _ => &focused,
    };
    let region = scene.region(scene.method);
    let ends = segments.iter().flat_map(|s| [s.p1, s.p2]);
    extent(region.vertices().iter().copied().chain(ends))
}
