//! What the labs in three dimensions add to the window: a camera, objects, a street of many.

mod camera;
mod objects;
mod street_bench;

use std::sync::Arc;

use egui::Ui;

use crate::{
    geom::Mesh,
    labs::{
        Edit,
        space::{Model, NamedMesh, Picture, Scene, SpaceChange},
    },
    panels::{PanelAsk, Seeded},
    widgets::Look,
};

pub use street_bench::{StreetBench, StreetCosts};

/// What the menu of such a lab remembers that is no part of the scene.
pub struct SpaceMenu {
    street: Seeded,
}

impl Default for SpaceMenu {
    fn default() -> Self {
        let street = Seeded {
            count: 100,
            seed: 1,
        };
        Self { street }
    }
}

impl SpaceMenu {
    /// The camera's form, the objects' and the street's; what was asked for.
    pub fn show(&mut self, ui: &mut Ui, look: Look<'_>, scene: &Scene) -> Option<PanelAsk> {
        let camera = camera::form(ui, look, scene);
        let objects = objects::rows(ui, look, scene);
        let street = objects::street(ui, look, &mut self.street);
        camera.or(objects).or(street)
    }
}

/// What puts a mesh of this name into a scene.
pub fn add_mesh(name: &str, mesh: &Mesh, picture: Option<&Picture>) -> Edit {
    let model = Model::Mesh(Arc::new(NamedMesh {
        name: name.to_owned(),
        mesh: mesh.clone(),
        picture: picture.cloned(),
    }));
    Edit::own(SpaceChange::Add(model))
}

/// What the menu asks for once.
fn own(change: SpaceChange) -> PanelAsk {
    PanelAsk::Edit(Edit::own(change))
}

/// What it asks for while a number is dragged: the number has this place in the menu.
fn tuned(change: SpaceChange, number: usize) -> PanelAsk {
    PanelAsk::Tune(Edit::own(change), number)
}
