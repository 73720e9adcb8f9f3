//! What the lines lab adds to the window: its methods, its scene, its crowd of segments, its costs.

mod batch;
mod edit;
mod measure;
mod measure_view;
mod menu;
mod spots;

pub use batch::Batch;
pub use edit::{EditError, LinesEdit};
pub use measure::Measure;
pub use measure_view::{MeasureAsk, measure_window};
pub use menu::{compare_picker, method_picker, scene_menu};
pub use spots::spots;
