//! What the frustum lab adds to the window: its scenes' menu, and what culling costs.

mod culling_costs;
mod culling_view;

use egui::Ui;

use crate::{
    geom::Mesh,
    labs::{Edit, Lab, Scene, frustum, space::Picture},
    panels::{Bench, LabPanel, PanelAsk},
    widgets::Look,
};

use super::space::{SpaceMenu, add_mesh};

use culling_costs::CullingCosts;
use culling_view::{CullingAsk, culling_window};

/// The lab's part of the window.
#[derive(Default)]
pub struct FrustumPanel {
    menu: SpaceMenu,
    costs: Option<CullingCosts>,
}

impl LabPanel for FrustumPanel {
    fn lab(&self) -> &'static dyn Lab {
        frustum::LAB
    }

    fn menu(&mut self, ui: &mut Ui, look: Look<'_>, scene: &Scene) -> Option<PanelAsk> {
        self.menu.show(ui, look, scene.get()?)
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

impl Bench for FrustumPanel {
    fn show(&mut self, ui: &mut Ui, look: Look<'_>, scene: &Scene) -> bool {
        let Some(scene) = scene.get() else {
            return false;
        };
        let fits = self.costs.take().filter(|costs| costs.are_of(scene));
        let costs = self
            .costs
            .insert(fits.unwrap_or_else(|| CullingCosts::new(scene)));
        let asked = culling_window(ui, look, costs);
        if !costs.is_done() {
            ui.ctx().request_repaint();
        }
        asked != Some(CullingAsk::Close)
    }

    fn work(&mut self, clock: &dyn Fn() -> f64) -> bool {
        let Some(costs) = self.costs.as_mut().filter(|costs| !costs.is_done()) else {
            return false;
        };
        costs.work(clock);
        true
    }
}
