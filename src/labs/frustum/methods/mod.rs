//! One file a method: its sentences, its views, what is watched.

mod back_face;
mod box_cull;
mod funnel;
mod planes;
mod point_planes;
mod sphere_cull;
