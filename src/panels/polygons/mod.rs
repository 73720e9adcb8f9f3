//! What the polygons lab adds to the window.

mod edit;
mod menu;
mod outline;

pub use edit::PolygonsEdit;
pub use menu::{PolygonsAsk, scene_menu};
pub use outline::{Outline, Sketch};
