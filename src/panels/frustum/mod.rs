//! What the frustum lab adds to the window: its camera, its objects, a street of many.

mod camera;
mod culling_costs;
mod culling_view;
mod objects;

use std::sync::Arc;

use egui::Ui;

use crate::{
    geom::{Mesh, Texture},
    labs::{
        Edit, Lab, Scene,
        frustum::{self, FrustumChange, Model, NamedMesh},
    },
    panels::{Bench, LabPanel, PanelAsk, Seeded},
    widgets::Look,
};

use culling_costs::CullingCosts;
use culling_view::{CullingAsk, culling_window};

/// The lab's part of the window.
pub struct FrustumPanel {
    street: Seeded,
    costs: Option<CullingCosts>,
}

impl Default for FrustumPanel {
    fn default() -> Self {
        let street = Seeded {
            count: 100,
            seed: 1,
        };
        let costs = None;
        Self { street, costs }
    }
}

impl LabPanel for FrustumPanel {
    fn lab(&self) -> &'static dyn Lab {
        frustum::LAB
    }

    fn menu(&mut self, ui: &mut Ui, look: Look<'_>, scene: &Scene) -> Option<PanelAsk> {
        let scene = scene.get()?;
        let camera = camera::form(ui, look, scene);
        let objects = objects::rows(ui, look, scene);
        let street = objects::street(ui, look, &mut self.street);
        camera.or(objects).or(street)
    }

    fn add_mesh(&self, name: &str, mesh: &Mesh, texture: Option<&Texture>) -> Option<Edit> {
        let model = Model::Mesh(Arc::new(NamedMesh {
            name: name.to_owned(),
            mesh: mesh.clone(),
            texture: texture.cloned(),
        }));
        Some(Edit::own(FrustumChange::Add(model)))
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

/// What the menu asks for once.
fn own(change: FrustumChange) -> PanelAsk {
    PanelAsk::Edit(Edit::own(change))
}

/// What it asks for while a number is dragged: the number has this place in the menu.
fn tuned(change: FrustumChange, number: usize) -> PanelAsk {
    PanelAsk::Tune(Edit::own(change), number)
}
