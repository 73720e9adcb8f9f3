//! Which surface is seen at each pixel.
//!
//! [`assemble`] takes a mesh to triangles on the screen: transformed, clipped before the divide by the clipper that is taught
//! ([`super::volume::HomogeneousTriangle`]), divided, snapped, culled. [`draw_rows`] and [`shade_rows`] fill them into a range of rows:
//! the project's only way from a mesh to pixels. The algorithms that are taught start from triangles in view space ([`Surfaces`]) and go
//! the same way.

mod assembly;
mod bands;
mod behind;
mod box_division;
mod bsp;
mod bsp_tree;
mod coverage;
mod depth_buffer;
mod depth_format;
mod excess;
pub mod faulty;
mod glass;
mod hierarchy;
mod near_one;
mod occlusion;
mod painter;
mod precedence;
mod ray_casting;
mod ray_hit;
mod ray_plane;
mod rays;
mod rounded_box;
mod scan;
mod screen_triangle;
mod sides;
mod stories;
mod surface_list;

use super::ring::Right;

pub use assembly::{Cull, MeshRef, assemble};
pub use bsp::{Bsp, BspEvent, BspHeld, BspInput, BspOutput, BspTooLarge};
pub use bsp_tree::{BspChoice, BspNode, BspPiece, BspSide};
pub use depth_buffer::{
    DepthBuffer, DepthBufferEvent, DepthBufferHeld, DepthBufferInput, DepthBufferOutput,
    DepthSteps, Fragment, FragmentTally,
};
pub use depth_format::{DepthBits, DepthFormat, DepthNumber};
pub use glass::Tint;
pub use hierarchy::Hierarchy;
pub use occlusion::{
    Occlusion, OcclusionEvent, OcclusionHeld, OcclusionInput, OcclusionObject, OcclusionOutput,
    QueryResult,
};
pub use painter::{Painter, PainterAnswer, PainterEvent, PainterHeld, PainterOutput, PairTally};
pub use precedence::{Occupant, PairTest, is_order};
pub use ray_casting::{
    RayCasting, RayCastingEvent, RayCastingHeld, RayCastingInput, RayCastingOutput,
};
pub use ray_hit::{Meeting, PlaneHit, RayHit};
pub use rays::{Ray, Rays};
pub use scan::{LANES, Lanes, draw_rows, shade_rows};
pub use screen_triangle::{ScreenTriangle, Viewport};
pub use stories::{pixel_story, times_computed};
pub use surface_list::{Picture, Surfaces};

/// What may be got wrong, known at compile time. The values given here are right; [`faulty`] has the others.
pub trait SurfaceRules: Copy + 'static {
    /// Is the depth buffer cleared to the near plane's depth, and not to nothing at all?
    const CLEARS_TO_NEAR: bool = false;
    /// Does the farther fragment win?
    const TURNS_COMPARISON: bool = false;
    /// Is a fragment compared before it is written?
    const COMPARES: bool = true;
    /// Is the distance in view space interpolated straight across the screen, and not the depth after the divide?
    const STRAIGHT_DISTANCE: bool = false;
    /// Are triangles sorted by their nearest vertex, and not by the farthest?
    const SORTS_BY_NEAREST: bool = false;
    /// Is the sorted list painted as it is, without asking which triangle hides which?
    const KEYS_ONLY: bool = false;
}

impl SurfaceRules for Right {}
