//! What the labs in three dimensions add to the window: camera, objects, raster and places in the inspector, a street of many
//! in the menu; and what something costs on streets of more and more boxes, in a window of its own.

mod controls;
mod objects;
mod raster;

use std::sync::Arc;

use crate::{
    geom::Mesh,
    labs::space::{Model, NamedMesh, Picture, Scene, SpaceChange, Subject, controls::sections},
};

use super::{form::Form, prelude::*};

/// Costs that are found on one street after the other.
pub trait StreetCosts: Measuring {
    const TITLE_KEY: &'static str;
    const NOTE_KEY: &'static str;

    /// Nothing is known yet.
    fn new(scene: &Scene) -> Self;

    fn are_of(&self, scene: &Scene) -> bool;

    fn about(&self) -> Message;
}

/// The part of the window of a lab in three dimensions.
pub struct SpacePanel<C> {
    lab: &'static Lab,
    street: Seeded,
    /// Those of the scene that was last shown, if they were asked for.
    costs: Option<C>,
    /// Shows the costs; its plots share the height.
    view: fn(&mut Ui, Look<'_>, &mut C, f32),
}

impl<C> SpacePanel<C> {
    pub fn new(lab: &'static Lab, view: fn(&mut Ui, Look<'_>, &mut C, f32)) -> Self {
        Self {
            lab,
            street: Seeded {
                count: 100,
                seed: 1,
            },
            costs: None,
            view,
        }
    }
}

impl<C: StreetCosts> LabPanel for SpacePanel<C> {
    fn lab(&self) -> &'static Lab {
        self.lab
    }

    fn menu(&mut self, ui: &mut Ui, look: Look<'_>, scene: &labs::Scene) -> Option<PanelAsk> {
        let scene = scene.get()?;
        let objects = objects::rows(ui, look, scene);
        let street = objects::street(ui, look, &mut self.street);
        objects.or(street)
    }

    fn sections(&self, scene: &labs::Scene) -> Vec<(&'static str, Message)> {
        let Some(scene) = scene.get() else {
            return Vec::new();
        };
        sections(scene)
            .map(|section| (section.id, (section.title)(scene)))
            .collect()
    }

    fn section(
        &self,
        ui: &mut Ui,
        form: &Form<'_>,
        id: &str,
        scene: &labs::Scene,
    ) -> Option<PanelAsk> {
        let scene = scene.get()?;
        let section = sections(scene).find(|section| section.id == id)?;
        controls::show(ui, form, section, scene)
    }

    fn add_mesh(&self, name: &str, mesh: &Mesh, picture: Option<&Picture>) -> Option<Edit> {
        let model = Model::Mesh(Arc::new(NamedMesh {
            name: name.to_owned(),
            mesh: mesh.clone(),
            picture: picture.cloned(),
        }));
        Some(Edit::own(SpaceChange::Add(model)))
    }

    /// Whole objects and their faces are measured: no method that asks about a point, a segment or a triangle of its own.
    fn measures(&self, scene: &labs::Scene) -> bool {
        let measured = [
            Subject::Objects,
            Subject::Object,
            Subject::Face,
            Subject::Surfaces,
        ];
        let is_measured = |scene: &Scene| measured.into_iter().any(|subject| scene.asks(subject));
        scene.get().is_some_and(is_measured)
    }

    fn bench(&mut self) -> Option<&mut dyn Bench> {
        Some(self)
    }
}

impl<C: StreetCosts> Bench for SpacePanel<C> {
    fn show(&mut self, ui: &mut Ui, look: Look<'_>, scene: &labs::Scene) -> bool {
        let Some(scene) = scene.get() else {
            return false;
        };
        let fits = self.costs.take().filter(|costs| costs.are_of(scene));
        let costs = self.costs.insert(fits.unwrap_or_else(|| C::new(scene)));
        ui.set_max_width(600.0_f32.min(ui.ctx().content_rect().width() - 48.0));
        let about = look.catalog.message(&costs.about());
        bench::head(ui, look, C::TITLE_KEY, about, Some(&*costs));
        let height = (ui.ctx().content_rect().height() - 330.0).clamp(120.0, 380.0);
        (self.view)(ui, look, costs, height);
        bench::note(ui, look, look.say(C::NOTE_KEY));
        !quiet_button(ui, look, Button::new(look.say("action-close"))).clicked()
    }

    fn work(&mut self, clock: &dyn Fn() -> f64) -> bool {
        bench::work_on(self.costs.as_mut(), clock)
    }
}

/// What the menu asks for once.
fn own(change: SpaceChange) -> PanelAsk {
    PanelAsk::Edit(Edit::own(change))
}
