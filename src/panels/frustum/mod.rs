//! What the frustum lab adds to the window: its camera, its objects, a street of many.

mod camera;
mod objects;

use std::sync::Arc;

use egui::Ui;

use crate::{
    geom::Mesh,
    labs::{
        Edit, Lab, Scene,
        frustum::{self, FrustumChange, Model, NamedMesh},
    },
    panels::{LabPanel, PanelAsk, Seeded},
    widgets::Look,
};

/// The lab's part of the window.
pub struct FrustumPanel {
    street: Seeded,
}

impl Default for FrustumPanel {
    fn default() -> Self {
        let street = Seeded {
            count: 100,
            seed: 1,
        };
        Self { street }
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

    fn add_mesh(&self, name: &str, mesh: &Mesh) -> Option<Edit> {
        let (name, mesh) = (name.to_owned(), mesh.clone());
        let model = Model::Mesh(Arc::new(NamedMesh { name, mesh }));
        Some(Edit::own(FrustumChange::Add(model)))
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
