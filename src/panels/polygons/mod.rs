//! What the polygons lab adds to the window.

mod edit;
mod menu;

pub use edit::PolygonsEdit;
pub use menu::scene_menu;
