//! What each lab adds to the window; [`all`] is the table that a lab joins.

mod bench;
mod fields;
mod form;
mod frustum;
mod lab_panel;
mod lines;
mod moved;
mod pickers;
mod plots;
mod polygons;
mod prelude;
mod space;
mod spots;
mod surfaces;

pub use bench::Bench;
pub use form::Form;
pub use lab_panel::{LabPanel, PanelAsk, panel_of, work};
pub use moved::moved_to;
pub use pickers::{compare_choices, compare_picker, list, method_choices, method_picker};
pub use spots::{Reach, spots};

pub fn all() -> Vec<Box<dyn LabPanel>> {
    vec![
        Box::<lines::LinesPanel>::default(),
        Box::<polygons::PolygonsPanel>::default(),
        Box::new(frustum::panel()),
        Box::new(surfaces::panel()),
    ]
}
