//! The frustum lab: what a camera sees of a scene, and what can be left out before it is drawn.

mod change;
mod culling;
mod demo;
mod document;
mod handles;
mod lab;
mod method_info;
mod methods;
mod object;
mod on_scene;
mod registry;
mod scene;
mod screen;
mod stage;
mod street;
mod subject;
mod taught_camera;
mod verdict;

pub use change::{CameraNumber, FrustumChange};
pub use culling::{Culling, CullingTask};
pub use lab::LAB;
pub use method_info::{FaceFate, FaceTest, MethodInfo};
pub use object::{Model, NamedMesh, Object};
pub use on_scene::{OnScene, OnSceneInput};
pub use registry::METHODS;
pub use scene::{MAX_OBJECTS, Method, Scene, SceneError};
pub use street::street;
pub use subject::{Places, Subject};
pub use taught_camera::{Opening, TaughtCamera};
