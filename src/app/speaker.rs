//! What whoever presents reads and nobody else: a second window with the notes of the open step, its question and answer, what
//! comes next, and for how long it has been going.

use egui::{CentralPanel, Frame, ViewportBuilder, ViewportClass, ViewportId};

use crate::widgets::{TextTold, lesson_text, rule, step_title};

use super::{
    App, Command,
    keys::{self, Focus},
    prelude::*,
};

const SIZE: [f32; 2] = [520.0, 600.0];

pub fn show(app: &App, ctx: &Context) {
    let minutes = app.shown.presenting.map(|before| {
        let secs = (ctx.input(|input| input.time) - before.since).max(0.0);
        // Drawn again when the next minute begins, and not before.
        ctx.request_repaint_after_secs((60.0 - secs % 60.0) as f32 + 0.01);
        (secs / 60.0) as u64
    });
    let window = ViewportBuilder::default()
        .with_title(app.look().say("action-notes"))
        .with_inner_size(SIZE);
    let id = ViewportId::from_hash_of("speaker");
    ctx.show_viewport_immediate(id, window, |ui, class| {
        if class != ViewportClass::EmbeddedWindow {
            // Where it has the focus, a clicker's keys go to it.
            let pressed = keys::commands(ui.ctx(), Focus::Free, Command::is_of_a_presentation);
            app.push_all(pressed);
        }
        if ui.input(|input| input.viewport().close_requested()) {
            app.push(Command::Notes);
        }
        let frame = Frame::new().fill(app.look().theme.background);
        CentralPanel::no_frame()
            .frame(frame.inner_margin(24))
            .show(ui, |ui| {
                ScrollArea::vertical()
                    .auto_shrink(false)
                    .show(ui, |ui| notes(app, ui, minutes));
            });
    });
}

fn notes(app: &App, ui: &mut Ui, minutes: Option<u64>) {
    let look = app.look();
    if let Some(minutes) = minutes {
        let clock = format!("{}:{:02}", minutes / 60, minutes % 60);
        let said = Message::new("speaker-clock").with("clock", clock);
        ui.label(RichText::new(look.catalog.message(&said)).color(look.theme.soft));
        ui.add_space(8.0);
    }
    let lang = app.settings.lang;
    let [lesson_idx, step_idx] = app.bookmark.at;
    let lesson = app.bookmark.step().and(app.bookmark.lesson());
    let Some(text) = lesson.and_then(|lesson| lesson.step_text(step_idx, lang)) else {
        ui.label(RichText::new(app.scene_name().unwrap_or_default()).heading());
        return;
    };
    let number = format!(
        "{}.{} ",
        app.bookmark.course.number(lesson_idx),
        step_idx + 1
    );
    step_title(ui, look, &(number + &text.title));
    let id = Id::unique(("notes", lesson_idx, step_idx));
    if text.note.is_empty() {
        ui.label(soft(look, "speaker-no-note"));
    }
    lesson_text(ui, look, id, &text.note, TextTold::answered());
    if let Some(asked) = text.question() {
        rule(ui, look);
        lesson_text(ui, look, id.with("asked"), asked, TextTold::answered());
    }
    rule(ui, look);
    let next = app.bookmark.next_title(lang);
    let said = match next {
        Some(title) => Message::new("speaker-next").with("title", title.to_owned()),
        None => Message::new("speaker-last"),
    };
    ui.label(RichText::new(look.catalog.message(&said)).color(look.theme.soft));
}
