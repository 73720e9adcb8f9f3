//! The surfaces lab: of all that a camera sees, which surface is in front.

mod methods;
mod registry;

pub use registry::{LAB, METHODS, SURFACES, first_scene};
