//! What the window is made with.

use crate::{lesson::SceneFormats, panels};

use super::prelude::*;

/// The labs that the window has, with what each adds to it and how its scenes are spelt in files.
pub struct Kit {
    pub(super) panels: Vec<Box<dyn LabPanel>>,
    pub(super) formats: SceneFormats,
}

impl Default for Kit {
    fn default() -> Self {
        Self {
            panels: panels::all(),
            formats: SceneFormats::standard(),
        }
    }
}

impl Kit {
    pub(super) fn lab(&self, id: &str) -> Option<&'static Lab> {
        let mut labs = self.panels.iter().map(|panel| panel.lab());
        labs.find(|lab| lab.id == id)
    }
}
