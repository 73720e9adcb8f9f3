//! Points, lines and triangles against planes and the view volume.

mod clip_polygon;
mod clip_vertex;
mod cohen_sutherland_3d;
pub mod faulty;
mod homogeneous_line;
mod homogeneous_triangle;
mod liang_barsky_3d;
mod line_clip;
mod line_rules;
mod plane_line;
mod point_plane;
mod side_code;
mod split;

pub use clip_polygon::ClipPolygon;
pub use clip_vertex::{Attributes, ClipVertex};
pub use cohen_sutherland_3d::{
    CohenSutherland3d, CohenSutherland3dEvent, CohenSutherland3dInput, CohenSutherland3dState,
};
pub use homogeneous_line::{ClipSpace, HomogeneousLine, side_distances};
pub use homogeneous_triangle::{
    HomogeneousTriangle, HomogeneousTriangleEvent, HomogeneousTriangleState,
};
pub use liang_barsky_3d::LiangBarsky3d;
pub use line_clip::{Bounds, LineClip, LineEvent, LineInput, LineRow, LineState, VisibleLine};
pub use line_rules::LineRules;
pub use plane_line::{PlaneLine, plane_distances};
pub use point_plane::{PlaneSide, signed_distance, weighted_sum};
pub use side_code::SideCode;
pub use split::{clipped, split};
