//! What the surfaces lab adds to the window: its scenes' menu, and how they are drawn pixel by pixel.

mod raster;

use egui::Ui;

use crate::{
    geom::Mesh,
    labs::{Edit, Lab, Scene, space::Picture, surfaces},
    panels::{LabPanel, PanelAsk},
    widgets::Look,
};

use super::space::{SpaceMenu, add_mesh};

/// The lab's part of the window.
#[derive(Default)]
pub struct SurfacesPanel {
    menu: SpaceMenu,
}

impl LabPanel for SurfacesPanel {
    fn lab(&self) -> &'static dyn Lab {
        surfaces::LAB
    }

    fn menu(&mut self, ui: &mut Ui, look: Look<'_>, scene: &Scene) -> Option<PanelAsk> {
        let scene = scene.get()?;
        let raster = raster::form(ui, look, scene);
        raster.or(self.menu.show(ui, look, scene))
    }

    fn add_mesh(&self, name: &str, mesh: &Mesh, picture: Option<&Picture>) -> Option<Edit> {
        Some(add_mesh(name, mesh, picture))
    }
}
