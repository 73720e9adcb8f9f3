//! The lines lab: segments against a window, five methods and a mistake.

mod backdrop;
mod document;
mod handles;
mod methods;
mod random;
mod registry;
mod scene;
mod verdict;

pub use document::LinesChange;
pub use handles::end as end_handle;
pub use random::random_segments;
pub use registry::{LAB, METHODS};
pub use scene::LineTelling;
pub use scene::{MAX_SEGMENTS, Method, MethodInfo, Pass, Scene, SceneError};
