//! The lines lab: segments against a window, five methods.

mod backdrop;
mod change;
mod crowd;
mod demo;
mod document;
mod handles;
mod lab;
mod methods;
mod random;
mod registry;
mod scene;

pub use change::LinesChange;
pub use demo::LineDemo;
pub use handles::end as end_handle;
pub use lab::LAB;
pub use random::random_segments;
pub use registry::{METHODS, Method, MethodInfo, Pass};
pub use scene::{MAX_SEGMENTS, Scene, SceneError};
