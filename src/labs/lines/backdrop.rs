//! What is on stage whatever the method and the step: the window and the segments out of focus.

use crate::{
    figure::{Mark, Role, Shape},
    geom::Point,
};

use super::{Method, Scene};

/// The clip region of `method`, to be drawn under a step's marks.
#[must_use]
pub fn backdrop(scene: &Scene, method: Method) -> Vec<Mark> {
    let region = scene.region(method);
    let outline = region.vertices().iter().map(|p| p.to_array()).collect();
    vec![Mark::new(Role::Ink, Shape::Polygon(outline)).linked("window")]
}

/// The world rectangle that holds the clip region and the focused segment: what a view shows at first.
#[must_use]
pub fn bounds(scene: &Scene) -> [[f64; 2]; 2] {
    let region = scene.region(scene.method);
    let window = scene.window.corners();
    let segment = scene.focused();
    let points = region
        .vertices()
        .iter()
        .copied()
        .chain(window)
        .chain([segment.p1, segment.p2])
        .map(Point::to_array);
    points.fold(
        [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]],
        |[min, max], p| {
            [
                [min[0].min(p[0]), min[1].min(p[1])],
                [max[0].max(p[0]), max[1].max(p[1])],
            ]
        },
    )
}
