//! One ring of vertices against one border, vertex by vertex: the step that every form of Sutherland–Hodgman is made of,
//! in the plane and in space. Nothing here knows how many dimensions there are: a border is known by what it says of a
//! vertex, and of an edge (`Limit`).

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
