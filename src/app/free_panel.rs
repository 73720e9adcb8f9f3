//! Beside the course: a lab's free scene, with all that can be put into it at hand.

use egui::Frame;

use crate::{
    panels::list,
    widgets::{quiet_button, rule},
};

use super::{App, Command, free_scenes, menus::panel_rows, pages::MOST_STORED, prelude::*};

pub fn show(app: &App, ui: &mut Ui, panels: &mut [Box<dyn LabPanel>]) {
    let look = app.look();
    let margin = Margin::symmetric(8, 0);
    Frame::new().inner_margin(margin).show(ui, |ui| {
        let name = app.scene_name().unwrap_or_default();
        let scenes = list(ui, "free scenes", name).truncate();
        let scenes = scenes.width(ui.available_width());
        scenes.show_ui(ui, |ui| free_scenes::menu(app, ui));
        ui.add_space(4.0);
        let is_kept = app.scene().document().size() <= MOST_STORED;
        let about = if is_kept {
            "free-about"
        } else {
            "free-about-large"
        };
        ui.label(soft(look, about));
        ui.add_space(8.0);
        if let Some(lesson) = app.bookmark.lesson() {
            let title = lesson.title(app.settings.lang).to_owned();
            let back = Message::new("free-back").with("lesson", title);
            let back = look.catalog.message(&back);
            let back = Button::new(RichText::new(back).color(look.theme.accent));
            if quiet_button(ui, look, back.truncate()).clicked() {
                app.push(Command::Free);
            }
        }
        rule(ui, look);
        if let Some(panel) = panel_of(panels, app.scene()) {
            panel_rows(app, ui, panel);
        }
        rule(ui, look);
        ui.label(soft(look, "free-from-course"));
    });
    ScrollArea::vertical()
        .id_salt("scenes of the course")
        .auto_shrink(false)
        .show(ui, |ui| {
            Frame::new().inner_margin(margin).show(ui, |ui| {
                let lab = app.scene().document().lab().id;
                let lessons = app.bookmark.course.lessons.iter().enumerate();
                for (i, lesson) in lessons.filter(|(_, lesson)| lesson.lab == lab) {
                    of_lesson(app, ui, (i, lesson));
                }
            });
        });
}

/// The scenes of a lesson, each once, under the title of the step that shows it first.
fn of_lesson(app: &App, ui: &mut Ui, (i, lesson): (usize, &Lesson)) {
    let lang = app.settings.lang;
    let title = format!("{} · {}", app.bookmark.course.number(i), lesson.title(lang));
    menu_button(ui, title, |ui| {
        let mut shown = Vec::new();
        for (i, step) in lesson.steps.iter().enumerate() {
            if shown.contains(&&step.scene) {
                continue;
            }
            shown.push(&step.scene);
            if ui
                .button(lesson.step_title(i, lang).unwrap_or_default())
                .clicked()
            {
                app.push(Command::Edit(Edit::Replace((*step.scene).clone()), None));
                app.push(Command::FIRST);
                ui.close();
            }
        }
    });
}
