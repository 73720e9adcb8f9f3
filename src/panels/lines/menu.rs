//! The lab's controls: what is in the scene.

use egui::Ui;

use crate::{algo::line::BitOrder, labs::lines::Scene, widgets::Look};

use super::{Batch, LinesEdit};

/// Segments, the random batch and the order of the bits; the change that was asked for.
pub fn scene_menu(
    ui: &mut Ui,
    look: Look<'_>,
    scene: &Scene,
    batch: &mut Batch,
) -> Option<LinesEdit> {
    let mut asked = None;
    if ui.button(look.say("action-add-segment")).clicked() {
        asked = Some(LinesEdit::Add);
    }
    let can_remove = scene.segments().len() > 1;
    let remove = egui::Button::new(look.say("action-remove-segment"));
    if ui.add_enabled(can_remove, remove).clicked() {
        asked = Some(LinesEdit::Remove);
    }
    ui.menu_button(look.say("batch-title"), |ui| {
        if let Some(edit) = batch.show(ui, look) {
            asked = Some(edit);
            ui.close();
        }
    });
    ui.menu_button(look.say("settings-bit-order"), |ui| {
        for (order, key) in [
            (BitOrder::Tbrl, "bit-order-tbrl"),
            (BitOrder::Lrbt, "bit-order-lrbt"),
        ] {
            if ui.radio(scene.bit_order == order, look.say(key)).clicked() {
                asked = Some(LinesEdit::BitOrder(order));
                ui.close();
            }
        }
    });
    asked
}
