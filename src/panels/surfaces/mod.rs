//! What the surfaces lab adds to the window: its scenes' menu, how they are drawn pixel by pixel, and what that costs.

mod costs_view;
mod raster;
mod surface_costs;

use egui::Ui;

use crate::{
    geom::Mesh,
    labs::{Edit, Lab, Scene, space::Picture, surfaces},
    panels::{Bench, LabPanel, PanelAsk},
    widgets::Look,
};

use super::space::{SpaceMenu, StreetBench, add_mesh};

use costs_view::costs_view;
use surface_costs::SurfaceCosts;

/// The lab's part of the window.
pub struct SurfacesPanel {
    menu: SpaceMenu,
    costs: StreetBench<SurfaceCosts>,
}

impl Default for SurfacesPanel {
    fn default() -> Self {
        Self {
            menu: SpaceMenu::default(),
            costs: StreetBench::new(costs_view),
        }
    }
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

    fn measures(&self) -> bool {
        true
    }

    fn bench(&mut self) -> Option<&mut dyn Bench> {
        Some(&mut self.costs)
    }
}
