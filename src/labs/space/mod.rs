//! What the labs in three dimensions share: a camera, objects, places that are asked about; how they are drawn, taken hold
//! of and changed. Such a lab is a [`SpaceLab`] with a list of methods, and any scene of one opens in the other.

mod change;
pub mod controls;
pub(in crate::labs) mod demo;
mod document;
mod handles;
mod object;
mod pixel;
pub(in crate::labs) mod prelude;
mod raster_plan;
mod scene;
pub(in crate::labs) mod screen;
pub(in crate::labs) mod soup;
pub(in crate::labs) mod stage;
mod street;
mod subject;
mod taught_camera;

pub use change::SpaceChange;
pub use object::{Model, NamedMesh, Object, Picture};
pub use raster_plan::{RasterPlan, Tones};
pub use scene::{MAX_OBJECTS, Method, MethodInfo, Part, Scene, SceneError, SpaceLab};
pub use street::street;
pub use subject::{Places, Subject};
pub use taught_camera::{CameraNumbers, Opening, TaughtCamera};

pub use demo::SpaceTelling;

pub(in crate::labs) use pixel::{pixel_verdict, raster_verdict};
