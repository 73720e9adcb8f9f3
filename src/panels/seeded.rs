//! Something random that is asked for next: how much of it, and from which seed.

use std::ops::RangeInclusive;

use egui::{DragValue, Ui};

use crate::widgets::Look;

/// How many, and from which seed.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Seeded {
    /// Segments, or vertices.
    pub count: usize,
    /// The same seed gives the same.
    pub seed: u64,
}

impl Default for Seeded {
    fn default() -> Self {
        Self { count: 12, seed: 1 }
    }
}

impl Seeded {
    /// Two fields and a button, with the catalogue keys of the first and the last; was it asked for?
    pub fn show(
        &mut self,
        ui: &mut Ui,
        look: Look<'_>,
        [count_key, make_key]: [&str; 2],
        range: RangeInclusive<usize>,
    ) -> bool {
        ui.horizontal(|ui| {
            let label = ui.label(look.say(count_key));
            let count = DragValue::new(&mut self.count).range(range).speed(1.0);
            ui.add(count).labelled_by(label.id);
        });
        ui.horizontal(|ui| {
            let label = ui.label(look.say("batch-seed"));
            let seed = DragValue::new(&mut self.seed)
                .range(0..=999_999_u64)
                .speed(0.2);
            ui.add(seed).labelled_by(label.id);
        });
        ui.button(look.say(make_key)).clicked()
    }
}
