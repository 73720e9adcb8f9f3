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

/// A hairline between two sections, with white space on both sides.
pub fn rule(ui: &mut Ui, look: Look<'_>) {
    ui.add_space(8.0);
    let (rect, _) =
        ui.allocate_exact_size(egui::vec2(ui.available_width(), 1.0), egui::Sense::hover());
    ui.painter().rect_filled(rect, 0.0, look.theme.hairline);
    ui.add_space(8.0);
}
