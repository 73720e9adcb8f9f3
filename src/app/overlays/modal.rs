//! The frame of all that lies over the window.

use egui::{Frame, Modal};

use crate::app::{App, Command, prelude::*};

pub(super) const WIDTH: f32 = 528.0;

pub(super) fn modal(id: &str, look: Look<'_>) -> Modal {
    let frame = Frame::new()
        .fill(look.theme.background)
        .stroke(Stroke::new(1.0, look.theme.hairline))
        .corner_radius(8)
        .inner_margin(24);
    Modal::new(Id::unique(id)).frame(frame)
}

pub(super) fn heading(app: &App, ui: &mut Ui, key: &str) {
    let look = app.look();
    let size = vec2(
        ui.available_width().min(WIDTH * look.theme.text_scale),
        32.0,
    );
    ui.allocate_ui_with_layout(size, Layout::right_to_left(Align::Center), |ui| {
        if icon_button(ui, look, Icon::Close, &look.say("action-close"), true).clicked() {
            app.push(Command::Show(None));
        }
        ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
            ui.label(RichText::new(look.say(key).trim_end_matches('…')).heading());
        });
    });
}
