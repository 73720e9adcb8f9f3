//! A triangle cut by planes, shown: triangle by triangle, as one polygon, and before the divide.

mod agreement;
mod clip_space;
mod faulty;
mod homogeneous;
mod homogeneous_views;
mod list_view;
mod marks;
mod one_by_one;
mod one_polygon;
mod one_polygon_marks;
mod parts;
mod pieces_view;
mod small;
mod stages;
mod symbols;
mod texture;
mod variant;

pub use variant::{EvenOnScreen, WithTexture};

/// The view of lists in and out.
const LISTS_VIEW: &str = "lists";
/// The view of small drawings, one a plane.
const PLANES_VIEW: &str = "planes";
