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

use super::space::{SpaceMenu, StreetBench, add_mesh};

use culling_costs::CullingCosts;
use culling_view::culling_view;

/// The lab's part of the window.
pub struct FrustumPanel {
    menu: SpaceMenu,
    costs: StreetBench<CullingCosts>,
}

impl Default for FrustumPanel {
    fn default() -> Self {
        Self {
            menu: SpaceMenu::default(),
            costs: StreetBench::new(culling_view),
        }
    }
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
        Some(&mut self.costs)
    }
}
