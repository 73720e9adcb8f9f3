//! One ring of vertices against one border, vertex by vertex: the step that every form of Sutherland–Hodgman is made of,
//! in the plane and in space. Nothing here knows how many dimensions there are: a border is known by what it says of a
//! vertex, and of an edge (`Limit`).

mod rules;
mod step;

pub use rules::{Right, Rules};
pub use step::Rule;
pub(super) use step::{Clip, Crossing, Happening, Limit};
