//! What the labs in three dimensions add to the window: a camera, objects, a street of many.

mod camera;
mod objects;
mod street_bench;

use std::sync::Arc;

use egui::Ui;

use crate::{
    geom::Mesh,
    labs::{
        self, Edit, Lab,
        space::{Model, NamedMesh, Picture, Scene, SpaceChange},
    },
    panels::{
        bench::Bench,
        fields::Seeded,
        lab_panel::{LabPanel, PanelAsk},
    },
    widgets::Look,
};

pub use street_bench::StreetCosts;

use street_bench::{CostsView, StreetBench};

/// The first part of a lab's menu, where it has one of its own; what was asked for.
type MenuPart = fn(&mut Ui, Look<'_>, &Scene) -> Option<PanelAsk>;

/// The part of the window of a lab in three dimensions, whose costs are `C`.
pub struct SpacePanel<C> {
    lab: &'static dyn Lab,
    form: MenuPart,
    /// The street that is asked for next.
    street: Seeded,
    costs: StreetBench<C>,
}

impl<C> SpacePanel<C> {
    /// Of a lab whose menu begins with this form, and whose costs are shown in this way.
    pub fn new(lab: &'static dyn Lab, form: MenuPart, view: CostsView<C>) -> Self {
        let street = Seeded {
            count: 100,
            seed: 1,
        };
        Self {
            lab,
            form,
            street,
            costs: StreetBench::new(view),
        }
    }
}

impl<C: StreetCosts> LabPanel for SpacePanel<C> {
    fn lab(&self) -> &'static dyn Lab {
        self.lab
    }

    fn menu(&mut self, ui: &mut Ui, look: Look<'_>, scene: &labs::Scene) -> Option<PanelAsk> {
        let scene = scene.get()?;
        let first = (self.form)(ui, look, scene);
        let camera = camera::form(ui, look, scene);
        let objects = objects::rows(ui, look, scene);
        let street = objects::street(ui, look, &mut self.street);
        first.or(camera).or(objects).or(street)
    }

    fn add_mesh(&self, name: &str, mesh: &Mesh, picture: Option<&Picture>) -> Option<Edit> {
        let model = Model::Mesh(Arc::new(NamedMesh {
            name: name.to_owned(),
            mesh: mesh.clone(),
            picture: picture.cloned(),
        }));
        Some(Edit::own(SpaceChange::Add(model)))
    }

    fn measures(&self) -> bool {
        true
    }

    fn bench(&mut self) -> Option<&mut dyn Bench> {
        Some(&mut self.costs)
    }
}

/// What the menu asks for once.
fn own(change: SpaceChange) -> PanelAsk {
    PanelAsk::Edit(Edit::own(change))
}

/// What it asks for while a number is dragged: the number has this place in the menu.
fn tuned(change: SpaceChange, number: usize) -> PanelAsk {
    PanelAsk::Tune(Edit::own(change), number)
}
