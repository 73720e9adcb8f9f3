//! Every form of Sutherland–Hodgman: rings of vertices against one limit after the other, in any number of dimensions. An edge of a window,
//! a plane or a side of clip space is known by what it says of a vertex and of an edge (`Limit`).

mod clipper;
mod pass;
mod step;

pub use clipper::{Lists, Ring, RingEvent};
pub use step::{Crossing, EdgeTest, Happening, Known, Right, Rule, Rules};
pub(super) use {
    clipper::{RingClipper, clip_ring, ring_events},
    pass::pass,
    step::{Clip, Limit},
};
