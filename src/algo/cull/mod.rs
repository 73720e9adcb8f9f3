//! Culling: what can be left out whole, before anything of it is clipped or drawn.
//!
//! A test of a bounding volume may keep what is not to be seen, and never leaves out what is: it is conservative.

mod back_face;
mod batch;
mod box_cull;
pub mod faulty;
mod funnel;
mod funnel_input;
mod funnel_levels;
mod point_planes;
mod rules;
mod sphere_cull;
mod triangle_turn;
mod verdict;

use serde::Serialize;

pub use back_face::{BackFace, BackFaceEvent, BackFaceInput, BackFaceOutput, Viewer};
pub use batch::SphereBatch;
pub use box_cull::{BoxCull, BoxCullEvent, BoxCullInput, BoxCullOutput};
pub use funnel::{Funnel, FunnelEvent, FunnelHeld, TriangleFate};
pub use funnel_input::{FunnelInput, FunnelObject, asked_camera, asked_sphere, asked_viewer};
pub use funnel_levels::{FunnelLevels, Level};
pub use point_planes::{PointPlanes, PointPlanesEvent, PointPlanesInput, PointPlanesOutput};
pub use rules::CullRules;
pub use sphere_cull::{
    SphereCull, SphereCullEvent, SphereCullInput, SphereCullOutput, sphere_side,
};
pub use triangle_turn::{FaceTurn, face_turn, triangle_move};
pub use verdict::{SphereVerdict, sphere_verdict};

/// Where something lies, as seen from one plane or from a volume.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Containment {
    /// All of it is inside: nothing of it need be asked again.
    Inside,
    /// All of it is outside: culled.
    Outside,
    /// It lies on both sides, or this test cannot tell: what it is made of is asked in turn.
    Straddles,
}

impl Containment {
    /// What is known after one plane more.
    const fn and(self, of_plane: Self) -> Self {
        match of_plane {
            Self::Inside => self,
            Self::Straddles | Self::Outside => of_plane,
        }
    }
}
