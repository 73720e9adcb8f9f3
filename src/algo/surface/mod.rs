//! Which surface is seen at each pixel.
//!
//! [`assemble`] takes a mesh from the vertices to triangles on the screen: transformed, clipped before the divide by
//! the clipper that is taught ([`super::volume::HomogeneousTriangle`]), divided, snapped to fractions of a pixel, culled.
//! [`draw_rows`] fills them into a range of rows, so that rows can be drawn side by side, and hands out values, never
//! colours. Both are the project's only way from a mesh to pixels.

mod assembly;
mod scan;
mod screen_triangle;
mod viewport;

pub use assembly::{Cull, MeshRef, assemble};
pub use scan::draw_rows;
pub use screen_triangle::ScreenTriangle;
pub use viewport::Viewport;
