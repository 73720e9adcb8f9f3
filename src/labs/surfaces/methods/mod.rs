//! One file or folder a method: its sentences, its views, what is watched.

mod asks;
mod bars;
mod bsp;
mod crosses;
mod depth_buffer;
mod glass;
mod occlusion;
mod on_raster;
mod painter;
mod planes;
mod prelude;
mod ray_casting;
mod why;

pub use occlusion::with_occluders;
