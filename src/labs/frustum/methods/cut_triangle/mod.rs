//! A triangle cut by planes, shown: triangle by triangle, as one polygon, and before the divide.

mod agreement;
mod clip_space;
mod homogeneous;
mod homogeneous_views;
mod list_view;
mod marks;
mod one_by_one;
mod one_polygon;
mod one_polygon_marks;
mod parts;
mod pieces_view;
mod prelude;
mod stages;
mod variant;

use serde::Serialize;

pub use marks::{vertex, vertex_symbol};
pub use variant::{EvenOnScreen, WithTexture};

const LISTS_VIEW: &str = "lists";
const PLANES_VIEW: &str = "planes";

/// What `output` holds of triangles, and of what goes with their corners where that is given.
#[derive(Serialize)]
struct ToldTriangles<T, U> {
    triangles: T,
    #[serde(skip_serializing_if = "Option::is_none")]
    uv: Option<U>,
}
