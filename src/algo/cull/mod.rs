//! Culling: what can be left out whole, before anything of it is clipped or drawn.
//!
//! A test of a bounding volume may keep what is not to be seen, and never leaves out what is: it is conservative.

mod back_face;
mod batch;
mod box_cull;
pub mod faulty;
mod funnel;
mod funnel_input;
mod point_planes;
mod sphere_cull;
mod verdict;

use serde::Serialize;

use super::ring::Right;

pub(super) use back_face::normal_and_viewer;
pub use back_face::{BackFace, BackFaceEvent, BackFaceInput, BackFaceOutput, Viewer};
pub use batch::SphereBatch;
pub use box_cull::{BoxCull, BoxCullEvent, BoxCullInput, BoxCullOutput};
pub use funnel::{Funnel, FunnelEvent, FunnelHeld, FunnelLevels, Level, TriangleFate};
pub use funnel_input::{FunnelInput, FunnelObject, asked_camera, asked_sphere, asked_viewer};
pub use point_planes::{PointPlanes, PointPlanesEvent, PointPlanesInput, PointPlanesOutput};
pub use sphere_cull::{
    SphereCull, SphereCullEvent, SphereCullInput, SphereCullOutput, sphere_side,
};
pub use verdict::{FaceTurn, SphereVerdict, face_turn, sphere_verdict, triangle_move};

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

/// What may be got wrong. The values given here are right; [`faulty`] has the others.
pub trait CullRules: Copy + 'static {
    /// Is the one angle of the field of view taken for width and height alike?
    const ONE_ANGLE: bool = false;
    /// Is a sphere beyond a plane taken for one on the inner side of it?
    const TURNS_SIGN: bool = false;
    /// Does the sphere stand around the object's origin, with the radius that it has around the centroid?
    const AROUND_ORIGIN: bool = false;
    /// Are corners taken to run clockwise as seen from outside?
    const CLOCKWISE: bool = false;
    /// Is the way to the viewer the same for all faces, whatever the projection?
    const CONSTANT_VIEW: bool = false;
}

impl CullRules for Right {}
