//! Scenes as lesson and scene files spell them, each lab in a file of its own; [`SceneFormats::standard`] is the table
//! that a lab joins.

mod format;
mod lines;
mod polygons;
mod prelude;
mod space;

pub(crate) use format::SceneFormat;
pub use format::{SceneFile, SceneFormats};
pub use prelude::{exact, quoted};
pub use space::spot;

use crate::labs::{frustum::FRUSTUM, surfaces::SURFACES};

impl SceneFormats {
    pub const fn standard() -> Self {
        static FORMATS: [&SceneFormat; 4] = [
            &lines::FORMAT,
            &polygons::FORMAT,
            &space::format(&FRUSTUM, |fields, room| {
                space::scene(&FRUSTUM, fields, room)
            }),
            &space::format(&SURFACES, |fields, room| {
                space::scene(&SURFACES, fields, room)
            }),
        ];
        Self(&FORMATS)
    }
}
