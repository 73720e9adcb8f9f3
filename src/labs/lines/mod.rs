//! The lines lab: segments against a window, five methods.

mod backdrop;
mod change;
mod crowd;
mod demo;
mod document;
mod handles;
mod lab;
mod method_info;
mod methods;
mod random;
mod registry;
mod scene;
mod verdict;

pub use change::LinesChange;
pub use demo::LineTelling;
pub use handles::end as end_handle;
pub use lab::LAB;
pub use method_info::{MethodInfo, Pass};
pub use random::random_segments;
pub use registry::METHODS;
pub use scene::{MAX_SEGMENTS, Method, Scene, SceneError};
