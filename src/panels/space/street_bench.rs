//! Costs on streets of more and more boxes, in a window of their own: the same frame around it whatever it costs.

use egui::Ui;

use crate::{
    labs::{self, space::Scene},
    panels::bench::{self, Bench, Measuring},
    text::Message,
    widgets::Look,
};

/// Costs that are found on one street after the other.
pub trait StreetCosts: Measuring {
    /// Catalogue key of the window's title.
    const TITLE_KEY: &'static str;
    /// Catalogue key of what is to be kept in mind.
    const NOTE_KEY: &'static str;

    /// Nothing is known yet.
    fn new(scene: &Scene) -> Self;

    /// Are they those of this scene?
    fn are_of(&self, scene: &Scene) -> bool;

    /// What is found out.
    fn about(&self) -> Message;
}

/// What is known so far; plots share the height.
pub type CostsView<C> = fn(&mut Ui, Look<'_>, &mut C, f32);

/// The costs of the scene that was last shown, if they were asked for, and how they are shown.
pub struct StreetBench<C> {
    costs: Option<C>,
    view: CostsView<C>,
}

impl<C> StreetBench<C> {
    /// Nothing was asked for yet.
    pub fn new(view: CostsView<C>) -> Self {
        Self { costs: None, view }
    }
}

impl<C: StreetCosts> Bench for StreetBench<C> {
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
        !ui.button(look.say("action-close")).clicked()
    }

    fn work(&mut self, clock: &dyn Fn() -> f64) -> bool {
        bench::work_on(self.costs.as_mut(), clock)
    }
}
