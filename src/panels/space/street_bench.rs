//! Costs on streets of more and more boxes, in a window of their own: the same frame around it whatever it costs.

use egui::{ProgressBar, RichText, Ui};

use crate::{
    labs::{self, space::Scene},
    panels::Bench,
    text::Message,
    widgets::Look,
};

/// Work in one frame, in seconds.
const SLICE_SECS: f64 = 0.008;

/// Costs that are found a slice at a time.
pub trait StreetCosts: Sized {
    /// Catalogue key of the window's title.
    const TITLE_KEY: &'static str;
    /// Catalogue key of what is to be kept in mind.
    const NOTE_KEY: &'static str;
    /// Streets in all.
    const N_STREETS: usize;

    /// Nothing is known yet.
    fn new(scene: &Scene) -> Self;

    /// Are they those of this scene?
    fn are_of(&self, scene: &Scene) -> bool;

    /// Streets of which the costs are known.
    fn n_known(&self) -> usize;

    /// Is there nothing left to do?
    fn is_done(&self) -> bool {
        self.n_known() == Self::N_STREETS
    }

    /// The smallest piece of work, by a clock that runs in seconds.
    fn one(&mut self, clock: &dyn Fn() -> f64);

    /// Works for a slice of a frame.
    fn work(&mut self, clock: &dyn Fn() -> f64) {
        let start = clock();
        while !self.is_done() && clock() - start < SLICE_SECS {
            self.one(clock);
        }
    }

    /// What is found out.
    fn about(&self) -> Message;
}

/// What is known so far; plots share the height.
type View<C> = fn(&mut Ui, Look<'_>, &mut C, f32);

/// The costs of the scene that was last shown, if they were asked for, and how they are shown.
pub struct StreetBench<C> {
    costs: Option<C>,
    view: View<C>,
}

impl<C> StreetBench<C> {
    /// Nothing was asked for yet.
    pub fn new(view: View<C>) -> Self {
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
        ui.label(RichText::new(look.say(C::TITLE_KEY)).heading());
        let about = RichText::new(look.catalog.message(&costs.about()));
        ui.label(about.color(look.theme.soft));
        if !costs.is_done() {
            let progress = costs.n_known() as f32 / C::N_STREETS as f32;
            ui.add(ProgressBar::new(progress).desired_height(6.0));
            ui.ctx().request_repaint();
        }
        let height = (ui.ctx().content_rect().height() - 330.0).clamp(120.0, 380.0);
        (self.view)(ui, look, costs, height);
        let note = RichText::new(look.say(C::NOTE_KEY)).small();
        ui.label(note.color(look.theme.soft));
        !ui.button(look.say("action-close")).clicked()
    }

    fn work(&mut self, clock: &dyn Fn() -> f64) -> bool {
        let Some(costs) = self.costs.as_mut().filter(|costs| !costs.is_done()) else {
            return false;
        };
        costs.work(clock);
        true
    }
}
