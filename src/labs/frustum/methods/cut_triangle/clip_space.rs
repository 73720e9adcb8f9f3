//! A triangle in clip space as the lab clips it, and how its points and bounds are written.

use crate::{algo::volume::HomogeneousTriangleEvent, labs::frustum::prelude::*};

use super::variant::UV;

/// Where in the texture a vertex is; in a scene that is its share of the corners.
pub type Uv = Option<[f64; 2]>;
pub type Vertex = ClipVertex<Uv>;
pub type Event = HomogeneousTriangleEvent<Uv>;

/// `(1, −2, 0.5, 3)`
pub fn point(at: [f64; 4]) -> Formula {
    sym("(").list(&at).sym(")")
}

/// `w − x`, `w + x`: how far inside a side a point is.
pub fn bound_symbol(side: VolumeSide) -> String {
    let axis = ["x", "y", "z"][side.axis()];
    let sign = if side.is_high() { "−" } else { "+" };
    format!("w {sign} {axis}")
}

pub fn triangle(scene: &Scene) -> [Vertex; 3] {
    let clip_from_world = scene.culler().clip_from_world();
    let corners = scene.places().triangle;
    std::array::from_fn(|i| {
        let [x, y, z] = corners[i];
        ClipVertex {
            at: clip_from_world.times([x, y, z, 1.0]),
            attributes: Some(UV[i]),
        }
    })
}

/// Where in the world a vertex is, by its share of the triangle's corners.
pub fn in_world(v: &Vertex, scene: &Scene) -> [f64; 3] {
    let [a, b, c] = scene.places().triangle;
    let [s, t] = v.attributes.unwrap_or_default();
    std::array::from_fn(|i| a[i] + s * (b[i] - a[i]) + t * (c[i] - a[i]))
}

/// The place in the world, well before the camera, that is seen where a point of clip space lands once divided.
pub fn on_screen(camera: &Camera, [x, y, _, w]: [f64; 4]) -> [f64; 3] {
    let volume = camera.volume();
    let depth = volume.near().midpoint(volume.far());
    let spread = match volume.sight() {
        Sight::Perspective => depth,
        Sight::Parallel => 1.0,
    };
    let [half_width, half_height] = volume.half_size();
    let w = if w == 0.0 { 1.0 } else { w };
    camera.world_from_view([
        x / w * half_width * spread,
        y / w * half_height * spread,
        -depth,
    ])
}
