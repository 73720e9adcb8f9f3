//! The random batch that is asked for next.

use egui::{DragValue, Ui};

use crate::{labs::lines::MAX_SEGMENTS, widgets::Look};

use super::LinesEdit;

/// How many, and from which seed.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Batch {
    /// Segments.
    pub count: usize,
    /// The same seed gives the same segments.
    pub seed: u64,
}

impl Default for Batch {
    fn default() -> Self {
        Self { count: 12, seed: 1 }
    }
}

impl Batch {
    /// Two fields and a button; what was asked for.
    pub fn show(&mut self, ui: &mut Ui, look: Look<'_>) -> Option<LinesEdit> {
        ui.horizontal(|ui| {
            let label = ui.label(look.say("batch-count"));
            let count = DragValue::new(&mut self.count)
                .range(1..=MAX_SEGMENTS)
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
        let asked = ui.button(look.say("batch-make")).clicked();
        asked.then_some(LinesEdit::Random {
            count: self.count,
            seed: self.seed,
        })
    }
}
