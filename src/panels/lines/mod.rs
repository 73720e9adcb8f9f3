//! What the lines lab adds to the window: its segments, and the measured costs of its methods.

mod measure;
mod measure_view;
mod menu;

use egui::Ui;

use crate::{
    labs::{Lab, Scene, lines},
    panels::{Bench, LabPanel, PanelAsk, Seeded},
    widgets::Look,
};

use measure::Measure;
use measure_view::{MeasureAsk, measure_window};

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
        match measure_window(ui, look, self.measure.as_ref()) {
            Some(MeasureAsk::Start) => {
                self.measure = scene
                    .get()
                    .map(|scene| Measure::new(scene, self.batch.seed));
                ui.ctx().request_repaint();
                true
            }
            Some(MeasureAsk::Close) => false,
            None => true,
        }
    }

    fn work(&mut self, clock: &dyn Fn() -> f64) -> bool {
        let Some(measure) = self.measure.as_mut().filter(|measure| !measure.is_done()) else {
            return false;
        };
        measure.work(clock);
        true
    }
}
