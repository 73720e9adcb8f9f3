//! What has been seen of the course and told, on a page of its own: each step leads to itself.

use egui::{Role, Sense, WidgetInfo};

use crate::{lesson::Tally, text::Message};

use super::{App, Command, Dialog, marks, prelude::*};

/// As wide as the head of a dialog.
const WIDTH: f32 = 528.0;
/// What a step takes, to be pressed.
const STEP: f32 = 20.0;

pub fn show(app: &App, ui: &mut Ui, is_sure: bool) {
    let look = app.look();
    let screen = ui.ctx().content_rect().size();
    ui.set_width((screen.x - 96.0).min(WIDTH * look.theme.text_scale));
    let all = app.settings.progress.of_course(&app.bookmark.course);
    ui.add(Label::new(look.catalog.message(&counted(all))).wrap());
    legend(app, ui);
    ui.separator();
    ScrollArea::vertical()
        .max_height((screen.y - 280.0).max(80.0))
        .show(ui, |ui| {
            for (i, lesson) in app.bookmark.course.lessons.iter().enumerate() {
                lesson_row(app, ui, i, lesson);
            }
        });
    ui.separator();
    ui.horizontal_wrapped(|ui| {
        for (key, dialog) in [
            ("progress-hand-in", app.handed_in()),
            ("progress-take-up", app.taken_up()),
        ] {
            if ui.button(look.say(key)).clicked() {
                app.push(Command::Show(Some(dialog)));
                app.push(Command::Browse);
            }
        }
        if is_sure {
            ui.label(look.say("progress-sure"));
            if ui.button(accent(look, "progress-afresh")).clicked() {
                app.push(Command::Afresh);
                app.push(Command::Show(Some(Dialog::Progress(false))));
            }
        } else if ui.button(look.say("progress-afresh")).clicked() {
            app.push(Command::Show(Some(Dialog::Progress(true))));
        }
    });
}

/// How many steps were seen, and how many questions told, in words.
fn counted(tally: Tally) -> Message {
    Message::new("progress-counts")
        .with("seen", Value::Count(tally.seen))
        .with("beforehand", Value::Count(tally.beforehand))
        .with("after", Value::Count(tally.after))
        .with("open", Value::Count(tally.open()))
        .with("reached", Value::Count(tally.reached))
        .with("goals", Value::Count(tally.goals))
}

fn legend(app: &App, ui: &mut Ui) {
    let look = app.look();
    ui.horizontal_wrapped(|ui| {
        for told in [Told::Beforehand, Told::AfterTheNumbers, Told::Open] {
            let (rect, _) = ui.allocate_exact_size(vec2(12.0, 18.0), Sense::hover());
            marks::draw(ui.painter(), look.theme, rect.center(), told);
            ui.label(soft(look, marks::key(told)));
        }
        let (rect, _) = ui.allocate_exact_size(vec2(12.0, 18.0), Sense::hover());
        marks::draw_goal(ui.painter(), look.theme, rect.center(), true);
        ui.label(soft(look, marks::goal_key(true)));
    });
}

fn lesson_row(app: &App, ui: &mut Ui, lesson_idx: usize, lesson: &Lesson) {
    let look = app.look();
    let tally = app.settings.progress.of_lesson(lesson);
    let number = app.bookmark.course.number(lesson_idx);
    let title = format!("{number}\u{2002}{}", lesson.title(app.settings.lang));
    let row = ui.horizontal(|ui| {
        let half = 0.5 * ui.available_width();
        ui.allocate_ui(vec2(half, STEP), |ui| {
            ui.set_min_width(half);
            ui.add(Label::new(title).truncate());
        });
        ui.spacing_mut().item_spacing.x = 0.0;
        for step_idx in 0..lesson.steps.len() {
            step(app, ui, [lesson_idx, step_idx], lesson);
        }
    });
    row.response
        .on_hover_text(look.catalog.message(&counted(tally)));
}

/// A step that was seen has a line, one that asks a mark over it.
fn step(app: &App, ui: &mut Ui, [lesson_idx, step_idx]: [usize; 2], lesson: &Lesson) {
    let look = app.look();
    let theme = look.theme;
    let (rect, response) = ui.allocate_exact_size(vec2(STEP, STEP), Sense::click());
    let of = &lesson.steps[step_idx];
    let is_seen = app.settings.progress.mark(&lesson.id, &of.id).is_some();
    let told = app.told_of(lesson, of);
    let reached = app.reached_of(lesson, of);
    let said = match (told, reached, is_seen) {
        (Some(told), ..) => look.say(marks::key(told)),
        (None, Some(is_reached), _) => look.say(marks::goal_key(is_reached)),
        (None, None, true) => look.say("told-seen"),
        (None, None, false) => look.say("told-unseen"),
    };
    let mark = app.settings.progress.mark(&lesson.id, &of.id);
    let said = match mark.filter(|mark| mark.hints > 0) {
        Some(mark) => {
            let hints = Message::new("mark-hints").with("count", Value::Count(mark.hints));
            format!("{said}, {}", look.catalog.message(&hints))
        }
        None => said,
    };
    let title = lesson.step_title(step_idx, app.settings.lang);
    let name = format!("{}: {said}", title.unwrap_or_default());
    response.widget_info(|| WidgetInfo::selected(Role::Link, true, false, &name));
    if response.hovered() || response.has_focus() {
        ui.painter().rect_filled(rect, 4.0, theme.hover);
    }
    let line = rect.shrink2(vec2(3.0, 0.0));
    let colour = if is_seen {
        theme.accent
    } else {
        theme.hairline
    };
    let stroke = theme.stroke(if is_seen { 2.0 } else { 1.0 }, colour);
    ui.painter()
        .hline(line.x_range(), rect.bottom() - 4.0, stroke);
    let at = rect.center() - vec2(0.0, 2.0);
    if let Some(told) = told {
        marks::draw(ui.painter(), theme, at, told);
    } else if let Some(is_reached) = reached {
        marks::draw_goal(ui.painter(), theme, at, is_reached);
    }
    if response.on_hover_text(name).clicked() {
        app.push(Command::Show(None));
        app.push(Command::Open([lesson_idx, step_idx]));
    }
}
