//! The lab's controls: which methods, and what is in the scene.

use egui::{ComboBox, Rect, Shape, Stroke, Ui, style::WidgetVisuals, vec2};

use crate::{
    algo::line::BitOrder,
    labs::lines::{Method, Scene},
    widgets::Look,
};

use super::{Batch, LinesEdit};

/// The scene's method; the change that was asked for.
pub fn method_picker(ui: &mut Ui, look: Look<'_>, scene: &Scene) -> Option<LinesEdit> {
    let mut asked = None;
    let name = |method: Method| look.say(method.info().name_key);
    let combo = ComboBox::from_id_salt("method")
        .icon(chevron)
        .selected_text(name(scene.method))
        .show_ui(ui, |ui| {
            for method in Method::all() {
                if ui
                    .selectable_label(method == scene.method, name(method))
                    .clicked()
                {
                    asked = Some(LinesEdit::Method(method));
                }
            }
        });
    combo.response.on_hover_text(look.say("panel-algorithm"));
    asked
}

/// The method beside it; the change that was asked for.
pub fn compare_picker(ui: &mut Ui, look: Look<'_>, scene: &Scene) -> Option<LinesEdit> {
    let mut asked = None;
    let name = |method: Method| look.say(method.info().name_key);
    let shown = scene.compare.map_or_else(|| look.say("cost-compare"), name);
    let combo = ComboBox::from_id_salt("compare")
        .icon(chevron)
        .selected_text(shown)
        .show_ui(ui, |ui| {
            let none = look.say("cost-compare-none");
            if ui.selectable_label(scene.compare.is_none(), none).clicked() {
                asked = Some(LinesEdit::Compare(None));
            }
            for method in Method::all().filter(|&method| method != scene.method) {
                let chosen = scene.compare == Some(method);
                if ui.selectable_label(chosen, name(method)).clicked() {
                    asked = Some(LinesEdit::Compare(Some(method)));
                }
            }
        });
    combo.response.on_hover_text(look.say("cost-compare"));
    asked
}

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

/// A small angle that points down: quieter than egui's triangle.
fn chevron(ui: &Ui, rect: Rect, _visuals: &WidgetVisuals, _is_open: bool) {
    let centre = rect.center().round();
    let line = [vec2(-3.5, -1.75), vec2(0.0, 1.75), vec2(3.5, -1.75)];
    let points = line.map(|offset| centre + offset).to_vec();
    let stroke = Stroke::new(1.5, ui.visuals().weak_text_color());
    ui.painter().add(Shape::line(points, stroke));
}
