//! The lab's controls: what is in the scene.

use egui::Ui;

use crate::{
    algo::line::BitOrder,
    labs::{
        Edit,
        lines::{LinesChange, MAX_SEGMENTS, Scene},
    },
    panels::Seeded,
    widgets::{Look, form_button, menu_button},
};

/// Segments, the random batch and the order of the bits; the change that was asked for.
pub fn scene_menu(ui: &mut Ui, look: Look<'_>, scene: &Scene, batch: &mut Seeded) -> Option<Edit> {
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
