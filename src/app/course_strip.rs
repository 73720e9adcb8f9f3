//! The course where there is no room for it beside the stage: the numbers of the open lesson's steps, and a button that
//! opens the rest.

use egui::{Align, Layout, ScrollArea, Ui};

use crate::widgets::{Icon, icon_button};

use super::{App, Command, course_panel::discs};

/// Draws the strip.
pub fn show(app: &App, ui: &mut Ui, commands: &mut Vec<Command>) {
    let look = app.look();
    ui.with_layout(Layout::top_down(Align::Center), |ui| {
        let open = look.say("panel-course");
        if icon_button(ui, look, Icon::LeftPanel, &open, true).clicked() {
            commands.push(Command::Course);
        }
        let Some(lesson) = app.bookmark.lesson() else {
            return;
        };
        ui.add_space(12.0);
        ScrollArea::vertical().show(ui, |ui| {
            ui.spacing_mut().item_spacing.y = 8.0;
            discs(app, ui, lesson, f32::INFINITY, commands);
        });
    });
}
