//! Something random that is asked for next: how much of it, and from which seed.

use std::ops::RangeInclusive;

use egui::{DragValue, Response, Ui};

use crate::widgets::Look;

/// Seeds of more digits are not for people.
const LAST_SEED: u64 = 999_999;

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
    /// Two fields, with the catalogue key of the first, and two buttons, with that of the first: this one, and one from
    /// the next seed. Was either asked for?
    pub fn show(
        &mut self,
        ui: &mut Ui,
        look: Look<'_>,
        keys: [&str; 2],
        range: RangeInclusive<usize>,
    ) -> bool {
        self.show_with(ui, look, keys, |ui, count| {
            ui.add(DragValue::new(count).range(range).speed(1.0))
        })
    }

    /// The same with another field for how many.
    pub fn show_with(
        &mut self,
        ui: &mut Ui,
        look: Look<'_>,
        [count_key, make_key]: [&str; 2],
        field: impl FnOnce(&mut Ui, &mut usize) -> Response,
    ) -> bool {
        ui.horizontal(|ui| {
            let label = ui.label(look.say(count_key));
            field(ui, &mut self.count).labelled_by(label.id);
        });
        ui.horizontal(|ui| {
            let label = ui.label(look.say("batch-seed"));
            let seed = DragValue::new(&mut self.seed)
                .range(0..=LAST_SEED)
                .speed(0.2);
            ui.add(seed).labelled_by(label.id);
        });
        ui.add_space(4.0);
        if ui.button(look.say(make_key)).clicked() {
            ui.close();
            return true;
        }
        // The menu stays open: who wants another may want one more.
        let again = ui.button(look.say("batch-again")).clicked();
        if again {
            self.seed = (self.seed + 1) % (LAST_SEED + 1);
        }
        again
    }
}
