//! Culling and clipping in space against exact arithmetic of another kind: whole numbers.

mod culling;
mod funnel;
mod homogeneous;
mod line_pixels;
mod lines;
mod pipeline;
mod pixels;
mod triangles;
mod verdicts;
mod whole;
