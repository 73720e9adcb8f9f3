//! The polygons lab: a polygon against a window, or against another polygon.

mod backdrop;
mod change;
mod demo;
mod document;
mod handles;
mod methods;
mod presets;
mod random;
mod registry;
mod scene;
mod unfit_scene;
mod verdict;

pub use change::{OUTLINES, PolygonsChange};
pub use demo::PolygonTelling;
pub use handles::SceneVertex;
pub use presets::{PRESETS, Preset, REGIONS};
pub use random::random_polygon;
pub use registry::{LAB, METHODS};
pub use scene::{
    GivenSubject, MAX_VERTICES, Method, MethodInfo, Panels, Scene, SceneError, Texture,
};
pub use unfit_scene::{ScenePart, UnfitScene};
