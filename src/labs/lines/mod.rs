//! The lines lab: segments against a window, five methods.

mod backdrop;
mod crowd;
mod demo;
mod document;
mod methods;
mod random;
mod registry;
mod scene;

pub use demo::LineDemo;
pub use random::random_segments;
pub use registry::{METHODS, Method, MethodInfo, Pass};
pub use scene::{MAX_SEGMENTS, Scene, SceneError};
