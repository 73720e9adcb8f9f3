//! What the polygons lab adds to the window.

mod menu;

use egui::Ui;

use crate::{
    labs::{Lab, Scene, polygons},
    panels::{LabPanel, PanelAsk, Seeded},
    widgets::Look,
};

/// The lab's part of the window.
#[derive(Default)]
pub struct PolygonsPanel {
    random: Seeded,
}

impl LabPanel for PolygonsPanel {
    fn lab(&self) -> &'static dyn Lab {
        polygons::LAB
    }

    fn menu(&mut self, ui: &mut Ui, look: Look<'_>, scene: &Scene) -> Option<PanelAsk> {
        menu::scene_menu(ui, look, scene, &mut self.random)
    }
}
