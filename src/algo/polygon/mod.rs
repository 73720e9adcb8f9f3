//! Clipping a polygon against a window or another polygon: what is left is one polygon, several, or none.

mod border;
mod clipped_ring;
mod clipper;
mod ear_clipping;
pub mod faulty;
mod pipeline;
mod region;
mod sutherland_hodgman;
mod triangulate_and_clip;
mod vertex;
pub mod weiler_atherton;

pub use clipped_ring::{ClippedRing, RingOutcome};
pub use clipper::{Clipped, Clipper};
pub use ear_clipping::{
    Corner, EarClipping, EarClippingEvent, EarClippingHeld, Ring, Triangle, Triangulation,
};
pub use pipeline::{Pipeline, PipelineEvent, PipelineHeld, PipelineStage};
pub use region::ClipRegion;
pub use sutherland_hodgman::{
    SutherlandHodgman, SutherlandHodgmanEvent, SutherlandHodgmanHeld, SutherlandHodgmanInput,
};
pub use triangulate_and_clip::{
    EachTriangleEvent, Pieces, TriangulateAndClip, TriangulateAndClipEvent, TriangulateAndClipHeld,
    TriangulateAndClipInput,
};
pub use vertex::{Textured, Vertex};

pub use super::{
    parameter::Share,
    ring::{Crossing, EdgeTest, Known, Right, Rule, Rules},
};
