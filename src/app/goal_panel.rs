//! Under the parts of a goal: a hint, as far as it was asked for, and where the runs have ended. The button that asks for the hint
//! is always in sight.

use egui::{Role, Sense, TextStyle, WidgetInfo};

use super::{
    App, Command,
    hint::PARTS,
    in_sight::scroll_to_new,
    prelude::*,
    said::{said_live, words},
};

const DOT: f32 = 2.5;
const STEP: f32 = 8.0;
/// More are a number.
const MOST_DOTS: usize = 12;

pub fn show(app: &App, ui: &mut Ui) {
    ui.spacing_mut().item_spacing.y = 6.0;
    if !app.is_reached() {
        hint(app, ui);
    }
    so_far(app, ui);
}

/// Is there more of the hint to be asked for?
pub fn has_hint(app: &App) -> bool {
    !app.met().is_empty() && !app.is_reached() && app.goals.help.n_shown < PARTS
}

pub fn hint_button(app: &App, ui: &mut Ui) {
    let look = app.look();
    ui.horizontal(|ui| {
        if ui.add(Button::new(accent(look, "goal-hint"))).clicked() {
            app.push(Command::Hint);
        }
        let part = Message::new("goal-hint-part")
            .with("part", Value::Count(app.goals.help.n_shown))
            .with("count", Value::Count(PARTS));
        let part = RichText::new(look.catalog.message(&part)).small();
        ui.label(part.color(look.theme.soft));
    });
}

fn hint(app: &App, ui: &mut Ui) {
    let (look, help) = (app.look_at_step(), &app.goals.help);
    // After a drag it can be longer.
    let scroll = |ui: &Ui, n_rows, to| scroll_to_new(ui, "rows of the hint", n_rows, to);
    if help.n_shown == 0 {
        scroll(ui, 0, Rect::NOTHING);
        return;
    }
    let top = ui.cursor().min;
    let mut said = help.hint.said(look.catalog);
    if said.is_empty() {
        said.push(look.say("goal-hint-none"));
    }
    let (width, mut n_rows) = (ui.available_width(), 0);
    let n_said = if help.n_shown == PARTS { said.len() } else { 1 };
    for text in &said[..n_said] {
        let text = words(ui, look, (text, TextStyle::Body), width);
        n_rows += text.rows.len();
        said_live(ui, text);
    }
    scroll(ui, n_rows, Rect::from_min_max(top, ui.min_rect().max));
}

/// A row for each way in which runs have ended, with a dot for each run; the last one's is blue.
fn so_far(app: &App, ui: &mut Ui) {
    let (look, ended) = (app.look_at_step(), &app.goals.help.ended);
    if ended.is_empty() {
        return;
    }
    ui.add_space(4.0);
    ui.label(soft(look, "goal-so-far").small());
    for end in ended {
        let so = end.so.iter().map(|it| look.catalog.formula(it));
        let said = std::iter::once(look.catalog.message(&end.said)).chain(so);
        let text = said.collect::<Vec<_>>().join(" ");
        let label = ui.add(Label::new(RichText::new(&text).color(look.theme.soft)).wrap());
        let name = Message::new("goal-ended").with("said", text);
        let name = look
            .catalog
            .message(&name.with("count", Value::Count(end.count)));
        label.widget_info(|| WidgetInfo::labeled(Role::Label, true, &name));
        dots(ui, look, (end.count, end.is_now));
    }
}

fn dots(ui: &mut Ui, look: Look<'_>, (count, is_now): (usize, bool)) {
    let size = vec2(ui.available_width(), 2.0 * STEP);
    let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
    let shown = count.min(MOST_DOTS);
    for nth in 0..shown {
        let at = rect.left_center() + vec2(DOT + STEP * nth as f32, 0.0);
        let is_last = is_now && nth + 1 == shown;
        let (radius, colour) = if is_last {
            (DOT + 1.0, look.theme.accent)
        } else {
            (DOT, look.theme.faint)
        };
        ui.painter().circle_filled(at, radius, colour);
    }
    if count > shown {
        let at = rect.left_center() + vec2(STEP * (shown as f32 + 1.0), 0.0);
        let font = egui::TextStyle::Small.resolve(ui.style());
        let text = count.to_string();
        ui.painter()
            .text(at, Align2::LEFT_CENTER, text, font, look.theme.soft);
    }
}
