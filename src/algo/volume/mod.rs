//! Points, lines and triangles against planes and the view volume.

mod clip_polygon;
mod clip_vertex;
mod homogeneous_triangle;
mod point_plane;
mod side_code;
mod split;

pub use clip_polygon::ClipPolygon;
pub use clip_vertex::{Attributes, ClipVertex};
pub use homogeneous_triangle::{
    HomogeneousTriangle, HomogeneousTriangleEvent, HomogeneousTriangleState,
};
pub use point_plane::{PlaneSide, signed_distance, weighted_sum};
pub use side_code::SideCode;
pub use split::{clipped, split};
