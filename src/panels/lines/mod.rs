//! What the lines lab adds to the window: its segments, and the measured costs of its methods.

mod measure;
mod measure_view;

use egui::{Button, Ui};

use crate::{
    algo::line::BitOrder,
    labs::{
        self, Edit, Lab,
        lines::{self, LinesChange, MAX_SEGMENTS, Scene},
    },
    panels::{
        bench::{self, Bench, Measuring},
        fields::Seeded,
        lab_panel::{LabPanel, PanelAsk},
    },
    widgets::{Look, form_button, menu_button},
};

use measure::Measure;
use measure_view::measured;

/// The lab's part of the window.
#[derive(Default)]
pub struct LinesPanel {
    batch: Seeded,
    measure: Option<Measure>,
}

impl LabPanel for LinesPanel {
    fn lab(&self) -> &'static dyn Lab {
        lines::LAB
    }

    fn menu(&mut self, ui: &mut Ui, look: Look<'_>, scene: &labs::Scene) -> Option<PanelAsk> {
        let change = scene_menu(ui, look, scene.get()?, &mut self.batch)?;
        Some(PanelAsk::Edit(change))
    }

    fn measures(&self) -> bool {
        true
    }

    fn bench(&mut self) -> Option<&mut dyn Bench> {
        Some(self)
    }
}

impl Bench for LinesPanel {
    fn show(&mut self, ui: &mut Ui, look: Look<'_>, scene: &labs::Scene) -> bool {
        ui.set_max_width(560.0_f32.min(ui.ctx().content_rect().width() - 48.0));
        let known = self.measure.as_ref();
        let about = look.say("measure-about");
        bench::head(ui, look, "measure-title", about, known);
        if let Some(known) = known {
            measured(ui, look, known);
        }
        let is_busy = known.is_some_and(|measure| !measure.is_done());
        let start = look.say(match known {
            Some(_) => "measure-again",
            None => "measure-start",
        });
        ui.horizontal(|ui| {
            if ui.add_enabled(!is_busy, Button::new(start)).clicked() {
                let scene = scene.get();
                self.measure = scene.map(|scene| Measure::new(scene, self.batch.seed));
                ui.ctx().request_repaint();
            }
            !ui.button(look.say("action-close")).clicked()
        })
        .inner
    }

    fn work(&mut self, clock: &dyn Fn() -> f64) -> bool {
        bench::work_on(self.measure.as_mut(), clock)
    }
}

/// Segments, the random batch and the order of the bits; the change that was asked for.
fn scene_menu(ui: &mut Ui, look: Look<'_>, scene: &Scene, batch: &mut Seeded) -> Option<Edit> {
    let mut asked = None;
    if ui.button(look.say("action-add-segment")).clicked() {
        asked = Some(Edit::Add(None));
    }
    let can_remove = scene.segments().len() > 1;
    let remove = egui::Button::new(look.say("action-remove-segment"));
    if ui.add_enabled(can_remove, remove).clicked() {
        asked = Some(Edit::Remove(None));
    }
    form_button(ui, look.say("batch-title"), |ui| {
        if batch.show(ui, look, ["batch-count", "batch-make"], 1..=MAX_SEGMENTS) {
            let Seeded { count, seed } = *batch;
            asked = Some(Edit::own(LinesChange::Random { count, seed }));
        }
    });
    menu_button(ui, look.say("settings-bit-order"), |ui| {
        for (order, key) in [
            (BitOrder::Tbrl, "bit-order-tbrl"),
            (BitOrder::Lrbt, "bit-order-lrbt"),
        ] {
            if ui.radio(scene.bit_order == order, look.say(key)).clicked() {
                asked = Some(Edit::own(LinesChange::BitOrder(order)));
                ui.close();
            }
        }
    });
    asked
}
