//! The frustum lab: what a camera sees of a scene, and what can be left out before it is drawn.

mod culling;
mod methods;
mod part;
pub mod prelude;
mod registry;
mod verdict;

pub use culling::{Culling, CullingTask};
pub use registry::{FRUSTUM, LAB, METHODS, first_scene};

use super::space::{Object, screen, stage};
