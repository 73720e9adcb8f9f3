//! What the lines lab adds to the window: its methods, its scene, its crowd of segments, its costs.

mod edit;
mod measure;
mod measure_view;
mod menu;

pub use edit::LinesEdit;
pub use measure::Measure;
pub use measure_view::{MeasureAsk, measure_window};
pub use menu::scene_menu;
