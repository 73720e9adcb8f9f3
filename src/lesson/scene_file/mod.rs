//! Scenes as lesson and scene files spell them, each lab in a file of its own; [`SceneFormats::standard`] is the table
//! that a lab joins.

mod format;
mod lines;
mod parts;
mod polygons;
mod space;

pub(crate) use format::SceneFormat;
#[cfg(all(test, feature = "gui"))]
pub(crate) use format::Spelling;
pub use format::{SceneFile, SceneFormats};
pub use space::spot;

use crate::labs::{frustum::FRUSTUM, surfaces::SURFACES};

impl SceneFormats {
    pub const fn standard() -> Self {
        static FORMATS: [&dyn SceneFormat; 4] = [
            &lines::Format,
            &polygons::Format,
            &space::Format(&FRUSTUM),
            &space::Format(&SURFACES),
        ];
        Self::new(&FORMATS)
    }
}
