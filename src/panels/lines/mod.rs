//! What the lines lab adds to the window: its segments, and the measured costs of its methods.

mod measure;
mod measure_view;
mod menu;

use egui::{Button, Ui};

use crate::{
    labs::{Lab, Scene, lines},
    panels::{
        bench::{self, Bench, Costs},
        lab_panel::{LabPanel, PanelAsk},
        seeded::Seeded,
    },
    widgets::Look,
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

    fn menu(&mut self, ui: &mut Ui, look: Look<'_>, scene: &Scene) -> Option<PanelAsk> {
        let change = menu::scene_menu(ui, look, scene.get()?, &mut self.batch)?;
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
    fn show(&mut self, ui: &mut Ui, look: Look<'_>, scene: &Scene) -> bool {
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
