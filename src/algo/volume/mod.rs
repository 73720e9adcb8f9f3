//! Points, lines and triangles against planes and the view volume.

mod point_plane;

pub use point_plane::{PlaneSide, signed_distance, weighted_sum};
