//! One file a method: its sentences, marks and watched values.

mod clip_edge;
mod clippers;
mod drawing;
mod ear_clipping;
mod fates;
mod list_view;
mod lists;
mod panels;
mod pipeline;
mod prelude;
mod result;
#[cfg(test)]
mod shown_lists;
mod skin;
mod sutherland_hodgman;
mod triangles;
mod triangulate_and_clip;
mod variant;
mod weiler_atherton;
mod why_bridge;

pub use clip_edge::clip_edge_name;
pub use sutherland_hodgman::region;
