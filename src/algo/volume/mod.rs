//! Points, lines and triangles against planes and the view volume.

mod batch;
mod clip_polygon;
mod clip_vertex;
mod cohen_sutherland_3d;
mod cut_triangles;
pub mod faulty;
mod homogeneous_line;
mod homogeneous_triangle;
mod intersection_polygon;
mod liang_barsky_3d;
mod part_turn;
mod plane_at_a_time;
mod plane_cut;
mod plane_line;
mod point_plane;
mod rules;
mod side_code;
mod space_vertex;
mod split;

pub use batch::clip_triangles;
pub use clip_polygon::ClipPolygon;
pub use clip_vertex::{Attributes, ClipVertex};
pub use cohen_sutherland_3d::{CohenSutherland3d, CohenSutherland3dEvent, CohenSutherland3dInput};
pub use cut_triangles::{CutTriangles, TrianglePlanes};
pub use homogeneous_line::{ClipSpace, HomogeneousLine, side_distances};
pub use homogeneous_triangle::{HomogeneousTriangle, HomogeneousTriangleEvent};
pub use intersection_polygon::{
    IntersectionPolygon, IntersectionPolygonEvent, IntersectionPolygonHeld,
};
pub use liang_barsky_3d::LiangBarsky3d;
pub use part_turn::{PartTurn, part_move_in, part_move_out};
pub use plane_at_a_time::{PlaneAtATime, PlaneAtATimeEvent, PlaneAtATimeHeld};
pub use plane_line::{PlaneLine, plane_distances};
pub use point_plane::{PlaneSide, signed_distance, weighted_sum};
pub use rules::VolumeRules;
pub use side_code::SideCode;
pub use space_vertex::{SpaceVertex, has_area};
pub use split::{clipped, split};

pub use super::segment::{Bounds, LineClip, LineEvent, LineInput, LineRules, VisibleLine};
