//! The lines lab: segments against a window, five methods.

mod backdrop;
mod crowd;
mod demo;
mod handle;
mod methods;
mod registry;
mod scene;

pub use backdrop::{backdrop, bounds};
pub use demo::{Demo, output_json};
pub use handle::{Corner, Handle, Lock};
pub use registry::{CodeLine, METHODS, Method, MethodInfo, Pass};
pub use scene::{MAX_SEGMENTS, Scene, SceneError};
