//! Headings and hairlines of a side panel.

use egui::{Response, RichText, Ui};

use crate::paint::theme;

use super::Look;

/// A small semibold heading.
pub fn section(ui: &mut Ui, look: Look<'_>, title: &str) -> Response {
    ui.label(
        RichText::new(title)
            .text_style(theme::strong())
            .color(look.theme.soft),
    )
}

/// White space above and below a hairline.
const AIR: f32 = 12.0;

/// A hairline between two sections, with white space on both sides.
pub fn rule(ui: &mut Ui, look: Look<'_>) {
    let spacing = ui.spacing().item_spacing.y;
    ui.add_space(AIR - spacing);
    let (rect, _) =
        ui.allocate_exact_size(egui::vec2(ui.available_width(), 1.0), egui::Sense::hover());
    ui.painter().rect_filled(rect, 0.0, look.theme.hairline);
    ui.add_space(AIR - spacing);
}
