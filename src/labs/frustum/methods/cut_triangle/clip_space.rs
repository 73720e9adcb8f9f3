//! A triangle in clip space as the lab clips it, and how its points and bounds are written.

use crate::{
    algo::volume::{ClipVertex, HomogeneousTriangleEvent, HomogeneousTriangleState},
    geom::VolumeSide,
    text::Formula,
};

/// Where in the texture a vertex is; in a scene that is its share of the corners.
pub type Uv = Option<[f64; 2]>;
/// A vertex in clip space.
pub type Vertex = ClipVertex<Uv>;
/// What happens.
pub type Event = HomogeneousTriangleEvent<Uv>;
/// What is known.
pub type State = HomogeneousTriangleState<Uv>;
/// `(1, −2, 0.5, 3)`
pub fn point(at: [f64; 4]) -> Formula {
    Formula::default().sym("(").list(&at).sym(")")
}

/// `w − x`, `w + x`: how far inside a side a point is.
pub fn bound_symbol(side: VolumeSide) -> String {
    let axis = ["x", "y", "z"][side.axis()];
    let sign = if side.is_high() { "−" } else { "+" };
    format!("w {sign} {axis}")
}
