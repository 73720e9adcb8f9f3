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

use super::space::{SpaceMenu, add_mesh};

use costs_view::{CostsAsk, costs_window};
use surface_costs::SurfaceCosts;

/// The lab's part of the window.
#[derive(Default)]
pub struct SurfacesPanel {
    menu: SpaceMenu,
    costs: Option<SurfaceCosts>,
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
        Some(self)
    }
}

impl Bench for SurfacesPanel {
    fn show(&mut self, ui: &mut Ui, look: Look<'_>, scene: &Scene) -> bool {
        let Some(scene) = scene.get() else {
            return false;
        };
        let fits = self.costs.take().filter(|costs| costs.are_of(scene));
        let costs = self
            .costs
            .insert(fits.unwrap_or_else(|| SurfaceCosts::new(scene)));
        let asked = costs_window(ui, look, costs);
        if !costs.is_done() {
            ui.ctx().request_repaint();
        }
        asked != Some(CostsAsk::Close)
    }

    fn work(&mut self, clock: &dyn Fn() -> f64) -> bool {
        let Some(costs) = self.costs.as_mut().filter(|costs| !costs.is_done()) else {
            return false;
        };
        costs.work(clock);
        true
    }
}
