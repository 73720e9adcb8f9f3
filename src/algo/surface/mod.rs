//! Which surface is seen at each pixel.
//!
//! [`assemble`] takes a mesh from the vertices to triangles on the screen: transformed, clipped before the divide by
//! the clipper that is taught ([`super::volume::HomogeneousTriangle`]), divided, snapped to fractions of a pixel, culled.
//! [`draw_rows`] fills them into a range of rows, so that rows can be drawn side by side, and hands out values, never
//! colours; [`shade_rows`] goes the same way and keeps what its caller makes of them. It is the project's only way from a mesh
//! to pixels.
//!
//! The algorithms that are taught start from triangles in view space ([`Surfaces`]) and go the same way: by the same
//! clipper, the same snapping and the same walk over a triangle's rows.

mod assembly;
mod bands;
mod box_division;
mod bsp;
mod bsp_choice;
mod bsp_tree;
mod coverage;
mod depth_buffer;
mod depth_buffer_input;
mod depth_format;
pub mod faulty;
mod fragment;
mod hierarchy;
mod lanes;
mod occlusion;
mod occlusion_query;
mod painter;
mod painter_event;
mod picture;
mod precedence;
mod ray_casting;
mod ray_plane;
mod rays;
mod rough_edges;
mod rounded_box;
mod rules;
mod scan;
mod screen_triangle;
mod surface_list;
mod viewport;

pub use assembly::{Cull, MeshRef, assemble};
pub use bsp::{Bsp, BspEvent, BspHeld, BspInput, BspOutput};
pub use bsp_choice::{BspChoice, BspTooLarge};
pub use bsp_tree::{BspNode, BspPiece, BspSide};
pub use depth_buffer::{
    DepthBuffer, DepthBufferEvent, DepthBufferHeld, DepthBufferOutput, pixel_story,
};
pub use depth_buffer_input::{DepthBufferInput, DepthSteps};
pub use depth_format::{DepthBits, DepthFormat, DepthNumber};
pub use fragment::{Fragment, FragmentTally};
pub use hierarchy::Hierarchy;
pub use lanes::{LANES, Lanes};
pub use occlusion::{
    Occlusion, OcclusionEvent, OcclusionHeld, OcclusionInput, OcclusionObject, OcclusionOutput,
    QueryResult,
};
pub use painter::{Painter, PainterAnswer, PainterHeld, PainterOutput};
pub use painter_event::{PainterEvent, PairTally};
pub use picture::Picture;
pub use precedence::{Occupant, PairTest};
pub use ray_casting::{
    RayCasting, RayCastingEvent, RayCastingHeld, RayCastingInput, RayCastingOutput, RayHit,
};
pub use ray_plane::{Meeting, PlaneHit};
pub use rays::{Ray, Rays};
pub use rules::SurfaceRules;
pub use scan::{draw_rows, shade_rows};
pub use screen_triangle::ScreenTriangle;
pub use surface_list::Surfaces;
pub use viewport::Viewport;
