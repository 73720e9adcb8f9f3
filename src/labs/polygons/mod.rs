//! The polygons lab: a polygon against a window, or against another polygon.

mod backdrop;
mod demo;
mod document;
mod methods;
mod presets;
mod random;
mod refusal;
mod registry;
mod scene;

pub use demo::PolygonDemo;
pub use presets::{PRESETS, Preset, REGIONS};
pub use random::random_polygon;
pub use refusal::{Part, Refusal};
pub use registry::{METHODS, Method, MethodInfo};
pub use scene::{MAX_VERTICES, Scene, SceneError, Texture};
