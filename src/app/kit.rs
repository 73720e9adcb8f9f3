//! Which labs a window has.

use crate::{
    lesson::SceneFormats,
    panels::{self, LabPanel},
};

/// The labs that the window has, with what each adds to it and how its scenes are spelt in files.
pub struct Kit {
    pub(super) panels: Vec<Box<dyn LabPanel>>,
    pub(super) formats: SceneFormats,
}

impl Default for Kit {
    /// All labs.
    fn default() -> Self {
        Self {
            panels: panels::all(),
            formats: SceneFormats::standard(),
        }
    }
}
