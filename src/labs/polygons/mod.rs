//! The polygons lab: a polygon against a window, or against another polygon.

mod backdrop;
mod change;
mod demo;
mod document;
mod handles;
mod lab;
mod method_info;
mod methods;
mod presets;
mod random;
mod registry;
mod scene;
mod unfit_scene;
mod verdict;

pub use change::{OUTLINES, PolygonsChange};
pub use demo::{PolygonDemo, PolygonTelling};
pub use handles::SceneVertex;
pub use lab::LAB;
pub use method_info::{GivenSubject, MethodInfo};
pub use presets::{PRESETS, Preset, REGIONS};
pub use random::random_polygon;
pub use registry::METHODS;
pub use scene::{MAX_VERTICES, Method, Scene, SceneError, Texture};
pub use unfit_scene::{ScenePart, UnfitScene};
