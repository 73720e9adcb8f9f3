//! The random polygon that is asked for next.

use egui::{DragValue, Ui};

use crate::widgets::Look;

use super::PolygonsEdit;

/// What a frame can draw in time, with its run and everything else beside it.
const MAX_COUNT: usize = 10_000;

/// How many vertices, and from which seed.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Random {
    /// Vertices.
    pub count: usize,
    /// The same seed gives the same polygon.
    pub seed: u64,
}

impl Default for Random {
    fn default() -> Self {
        Self { count: 12, seed: 1 }
    }
}

impl Random {
    /// Two fields and a button; what was asked for.
    pub fn show(&mut self, ui: &mut Ui, look: Look<'_>) -> Option<PolygonsEdit> {
        ui.horizontal(|ui| {
            let label = ui.label(look.say("random-count"));
            let count = DragValue::new(&mut self.count)
                .range(3..=MAX_COUNT)
                .speed(1.0);
            ui.add(count).labelled_by(label.id);
        });
        ui.horizontal(|ui| {
            let label = ui.label(look.say("batch-seed"));
            let seed = DragValue::new(&mut self.seed)
                .range(0..=999_999_u64)
                .speed(0.2);
            ui.add(seed).labelled_by(label.id);
        });
        let asked = ui.button(look.say("random-make")).clicked();
        asked.then_some(PolygonsEdit::Random {
            count: self.count,
            seed: self.seed,
        })
    }
}
