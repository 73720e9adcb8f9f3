//! Rings of vertices against limits, one after the other, each vertex by vertex: every form of Sutherland–Hodgman, in the plane
//! and in space. Nothing here knows how many dimensions there are: an edge of a window, a plane or a side of clip space is known
//! by what it says of a vertex, and of an edge of the ring (`Limit`).

mod clipper;
mod event;
mod rules;
mod step;

pub use clipper::{Lists, Ring};
pub use event::RingEvent;
pub use rules::{Right, Rules};
pub use step::{Crossing, Happening, Rule};
pub(super) use {
    clipper::{RingClipper, clip_ring, put_in},
    event::ring_events,
    step::{Clip, Limit},
};
