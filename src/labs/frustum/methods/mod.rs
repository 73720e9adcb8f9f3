//! One file a method: its sentences, its views, what is watched.

mod asked;
mod back_face;
mod box_cull;
mod bresenham;
mod cohen_sutherland_3d;
mod cut_triangle;
mod funnel;
mod line;
mod point_planes;
mod sphere_cull;
mod viewing_pipeline;
mod why;

pub use cut_triangle::{EvenOnScreen, WithTexture};
