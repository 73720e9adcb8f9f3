//! Costs that are measured on this machine, in a window of their own: a slice of the work in each frame, so that the main
//! window stays alive.

use egui::{ProgressBar, RichText, Ui};

use crate::{labs::Scene, widgets::Look};

/// Work in one frame, in seconds.
const SLICE_SECS: f64 = 0.008;

pub trait Bench {
    /// Draws the window's content; false where it is to be closed.
    fn show(&mut self, ui: &mut Ui, look: Look<'_>, scene: &Scene) -> bool;

    /// Works for a part of a frame, by a clock that runs in seconds; is there more to do?
    fn work(&mut self, clock: &dyn Fn() -> f64) -> bool;
}

pub trait Measuring {
    fn is_done(&self) -> bool;

    /// The part of the work that is done, from 0 to 1.
    fn progress(&self) -> f32;

    /// Does the smallest piece of work, by a clock that runs in seconds.
    fn one(&mut self, clock: &dyn Fn() -> f64);
}

pub fn work_on<C: Measuring>(costs: Option<&mut C>, clock: &dyn Fn() -> f64) -> bool {
    let Some(costs) = costs.filter(|costs| !costs.is_done()) else {
        return false;
    };
    let start = clock();
    while !costs.is_done() && clock() - start < SLICE_SECS {
        costs.one(clock);
    }
    true
}

pub fn head<C: Measuring>(
    ui: &mut Ui,
    look: Look<'_>,
    title_key: &str,
    about: String,
    costs: Option<&C>,
) {
    ui.label(RichText::new(look.say(title_key)).heading());
    ui.label(RichText::new(about).color(look.theme.soft));
    if let Some(costs) = costs.filter(|costs| !costs.is_done()) {
        ui.add(ProgressBar::new(costs.progress()).desired_height(6.0));
        ui.ctx().request_repaint();
    }
}

pub fn note(ui: &mut Ui, look: Look<'_>, text: String) {
    ui.label(RichText::new(text).small().color(look.theme.soft));
}

#[cfg(test)]
pub fn ticking(secs: f64) -> impl Fn() -> f64 {
    let now = std::cell::Cell::new(0.0);
    move || {
        now.set(now.get() + secs);
        now.get()
    }
}
