//! What each lab adds to the window; [`all`] is the table that a lab joins.

mod frustum;
mod lab_panel;
mod lines;
mod moved;
mod number_field;
mod pickers;
mod polygons;
mod power_plot;
mod seeded;
mod space;
mod spots;
mod still_plot;
mod surfaces;

pub use lab_panel::{Bench, LabPanel, PanelAsk, panel_of, work};
pub use moved::moved_to;
pub use number_field::number_field;
pub use pickers::{compare_choices, compare_picker, method_picker};
pub use power_plot::{PowerLine, power_plot};
pub use seeded::Seeded;
pub use spots::{Reach, spots};
pub use still_plot::still_plot;

/// The panels of all labs, in the order of their tabs.
#[must_use]
pub fn all() -> Vec<Box<dyn LabPanel>> {
    vec![
        Box::<lines::LinesPanel>::default(),
        Box::<polygons::PolygonsPanel>::default(),
        Box::<frustum::FrustumPanel>::default(),
        Box::<surfaces::SurfacesPanel>::default(),
    ]
}
