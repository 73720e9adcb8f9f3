//! Which labs a window has.

use crate::{
    labs::Lab,
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

impl Kit {
    /// The lab with this id.
    pub(super) fn lab(&self, id: &str) -> Option<&'static dyn Lab> {
        let mut labs = self.panels.iter().map(|panel| panel.lab());
        labs.find(|lab| lab.id() == id)
    }
}
