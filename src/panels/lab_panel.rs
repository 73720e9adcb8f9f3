//! What a lab adds to the window, whichever lab it is.

use egui::{Context, Ui};

use crate::{
    geom::Mesh,
    labs::{Edit, Lab, OutlineKind, Scene, space::Picture},
    text::Message,
    widgets::Look,
};

use super::{bench::Bench, form::Form};

#[derive(Clone, Debug)]
pub enum PanelAsk {
    Edit(Edit),
    /// One of many while a number is dragged, of which this is the place in the menu: they are undone together.
    Tune(Edit, usize),
    Draw(&'static OutlineKind),
}

/// A lab's part of the window, with what it remembers that is no part of the scene.
pub trait LabPanel {
    fn lab(&self) -> &'static Lab;

    fn menu(&mut self, ui: &mut Ui, look: Look<'_>, scene: &Scene) -> Option<PanelAsk>;

    /// The sections of what can be set of a scene in the inspector: their ids and titles.
    fn sections(&self, _: &Scene) -> Vec<(&'static str, Message)> {
        Vec::new()
    }

    /// The rows of the section of this id.
    fn section(&self, _: &mut Ui, _: &Form<'_>, _id: &str, _: &Scene) -> Option<PanelAsk> {
        None
    }

    /// What puts a mesh of this name into its scenes, if the lab shows meshes. It lies around the origin, between −1 and 1.
    fn add_mesh(&self, _name: &str, _mesh: &Mesh, _picture: Option<&Picture>) -> Option<Edit> {
        None
    }

    /// Can the costs of the methods on this scene's stage be measured?
    fn measures(&self, _: &Scene) -> bool {
        false
    }

    fn bench(&mut self) -> Option<&mut dyn Bench> {
        None
    }
}

pub fn panel_of<'a>(
    panels: &'a mut [Box<dyn LabPanel>],
    scene: &Scene,
) -> Option<&'a mut Box<dyn LabPanel>> {
    let lab = scene.document().lab();
    panels.iter_mut().find(|panel| panel.lab() == lab)
}

pub fn work(panels: &mut [Box<dyn LabPanel>], ctx: &Context, clock: &dyn Fn() -> f64) {
    for bench in panels.iter_mut().filter_map(|panel| panel.bench()) {
        if bench.work(clock) {
            ctx.request_repaint();
        }
    }
}
