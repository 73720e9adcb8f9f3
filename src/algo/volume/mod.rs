//! Points, lines and triangles against planes and the view volume.

mod batch;
mod clip_vertex;
mod cohen_sutherland_3d;
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
mod side_code;
mod space_vertex;

pub use batch::clip_triangles;
pub use clip_vertex::{Attributes, ClipPolygon, ClipVertex};
pub use cohen_sutherland_3d::{CohenSutherland3d, CohenSutherland3dEvent, CohenSutherland3dInput};
pub use homogeneous_line::{ClipSpace, HomogeneousLine, side_distances};
pub use homogeneous_triangle::{HomogeneousTriangle, HomogeneousTriangleEvent};
pub use intersection_polygon::{
    IntersectionPolygon, IntersectionPolygonEvent, IntersectionPolygonHeld,
};
pub use liang_barsky_3d::LiangBarsky3d;
pub use part_turn::{PartTurn, part_move_in, part_move_out};
pub use plane_at_a_time::{PlaneAtATime, PlaneAtATimeEvent, PlaneAtATimeHeld};
pub use plane_cut::{clipped, split};
pub use plane_line::{PlaneLine, plane_distances};
pub use point_plane::{PlaneSide, signed_distance, weighted_sum};
pub(super) use point_plane::{bounded_sum, is_plain};
pub use side_code::SideCode;
pub use space_vertex::{CutTriangles, SpaceVertex, TrianglePlanes, has_area};

use super::ring::{Right, Rules};

pub use super::segment::{Bounds, LineClip, LineEvent, LineInput, LineRules, VisibleLine};

/// What may be got wrong besides what any clipper of rings may. The values given here are right; [`faulty`] has the others.
pub trait VolumeRules: Rules + 'static {
    /// Is a triangle cut whose first vertex lies on the plane?
    const CUTS_FROM_PLANE: bool = true;
    /// Does a crossing get its own place in the texture, and not that of the end it stands for?
    const MIXES_UV: bool = true;
    /// Are the three edges clipped each by itself, and not the ring that they make?
    const EDGE_BY_EDGE: bool = false;
    /// Do outcodes say which sides there are to clip by?
    const ASKS_CODES: bool = true;
    /// Are the vertices divided by w before they are clipped?
    const DIVIDES_FIRST: bool = false;
}

impl VolumeRules for Right {}
