//! The steps of a lesson that is made: each with its title and where its run stands, and between two of them a place for another.

use egui::{Painter, Response, Role, Sense, StrokeKind, TextEdit, TextStyle, WidgetInfo};

use crate::widgets::{rule, tick_sign};

use super::{
    super::{Command, prelude::*},
    Act, App, Compose,
};

const ROW: f32 = 44.0;
const GAP: f32 = 10.0;

/// A row of the list, by its number from 0.
pub fn row_id(nth: usize) -> Id {
    Id::unique(("step that is made", nth))
}

pub fn show(app: &App, ui: &mut Ui) {
    let (Some(compose), Some(lesson)) = (app.composed(), app.bookmark.lesson()) else {
        return;
    };
    let look = app.look();
    ui.spacing_mut().item_spacing.y = 4.0;
    head(app, ui, compose);
    ScrollArea::vertical()
        .id_salt("steps that are made")
        .auto_shrink(false)
        .show(ui, |ui| {
            ui.spacing_mut().item_spacing.y = 0.0;
            let (mut middles, mut dragged) = (Vec::new(), None);
            for (nth, step) in lesson.steps.iter().enumerate() {
                let is_open = nth == app.bookmark.at[1];
                let row = Row::of(compose, (nth, lesson.steps.len()), step);
                let response = row.show(ui, look, is_open);
                if response.clicked() {
                    app.push(Command::Open([app.bookmark.at[0], nth]));
                }
                middles.push(response.rect.center().y);
                if response.dragged() || response.drag_stopped() {
                    dragged = Some((nth, response));
                }
                if between(app, ui, nth).clicked() {
                    app.push(Command::Compose(Act::Add(Some(nth))));
                }
            }
            if let Some((nth, response)) = dragged {
                drag(app, ui, (nth, &response), &middles);
            }
            ui.spacing_mut().item_spacing.y = 6.0;
            ui.add_space(4.0);
            let own = Button::new(accent(look, "compose-own-scene"));
            if ui
                .add(own)
                .on_hover_text(look.say("compose-own-scene-about"))
                .clicked()
            {
                app.push(Command::Compose(Act::OwnScene));
            }
            ui.add(Label::new(soft(look, "compose-how").small()).wrap());
        });
}

/// Where a row that is dragged would stand, as a line; there it is put when the button goes up, unless Escape was pressed.
fn drag(app: &App, ui: &Ui, (nth, response): (usize, &Response), middles: &[f32]) {
    let Some(pointer) = ui.input(|input| input.pointer.latest_pos()) else {
        return;
    };
    if ui.input(|input| input.key_down(egui::Key::Escape)) {
        ui.ctx().stop_dragging();
        return;
    }
    let others = middles
        .iter()
        .enumerate()
        .filter(|(other, _)| *other != nth);
    let to = others.filter(|(_, middle)| **middle < pointer.y).count();
    if response.drag_stopped() {
        let by = to as isize - nth as isize;
        app.push_all((by != 0).then_some(Command::Compose(Act::Move(nth, by))));
        return;
    }
    let (rect, theme) = (response.rect, app.look().theme);
    let y = match middles.get(to) {
        Some(middle) if to < nth => middle - 0.5 * rect.height(),
        Some(middle) => middle + 0.5 * rect.height(),
        None => rect.bottom(),
    };
    let line = theme.stroke(2.0, theme.accent);
    ui.painter().hline(rect.x_range().shrink(8.0), y, line);
    ui.ctx().set_cursor_icon(CursorIcon::Grabbing);
}

fn head(app: &App, ui: &mut Ui, compose: &Compose) {
    let look = app.look();
    let [title, _] = compose.draft().passage("", compose.lang);
    let mut written = [title, compose.draft().source()];
    let keys = ["compose-lesson", "compose-source"];
    let acts = [Act::Lesson as fn(String) -> Act, Act::Source];
    for ((text, key), act) in written.iter_mut().zip(keys).zip(acts) {
        let name = ui.label(soft(look, key).small());
        let field = TextEdit::singleline(text).desired_width(f32::INFINITY);
        if ui.add(field).labelled_by(name.id).changed() {
            app.push(Command::Compose(act(text.clone())));
        }
    }
    let path = compose.files.shown(&compose.lesson);
    let path = RichText::new(path).small().color(look.theme.soft);
    ui.add(Label::new(path).truncate());
    rule(ui, look);
}

/// Leads back from a lesson that is tried.
pub fn tried(app: &App, ui: &mut Ui) {
    if app.tries_lesson() {
        let look = app.look();
        let back = Button::new(accent(look, "compose-back"));
        let keys = RichText::new("F9").color(look.theme.soft);
        if ui.add(back.right_text(keys)).clicked() {
            app.push(Command::Compose(Act::Try));
        }
        ui.add_space(8.0);
    }
}

/// Puts a step where the run stands.
pub fn add_here(app: &App, ui: &mut Ui) {
    let look = app.look();
    let text = RichText::new(format!("+ {}", look.say("compose-add")));
    let text = text
        .text_style(theme::strong())
        .color(look.theme.background);
    let add = Button::new(text).fill(look.theme.accent);
    if ui.add(add).on_hover_text("Ctrl+Enter").clicked() {
        app.push(Command::Compose(Act::Add(None)));
    }
}

/// A line with a plus on it, where the pointer or the focus is.
fn between(app: &App, ui: &mut Ui, nth: usize) -> Response {
    let look = app.look();
    let size = vec2(ui.available_width(), GAP);
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    let name = look
        .catalog
        .message(&Message::new("compose-insert").with("n", nth + 1));
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, &name));
    if response.hovered() || response.has_focus() {
        let (painter, theme) = (ui.painter(), look.theme);
        painter.hline(
            rect.x_range().shrink(8.0),
            rect.center().y,
            theme.stroke(2.0, theme.accent),
        );
        painter.circle_filled(rect.center(), 8.0, theme.accent);
        let plus = theme.stroke(1.5, theme.background);
        painter.hline(
            rect.center().x - 4.0..=rect.center().x + 4.0,
            rect.center().y,
            plus,
        );
        painter.vline(
            rect.center().x,
            rect.center().y - 4.0..=rect.center().y + 4.0,
            plus,
        );
    }
    response.on_hover_text(name)
}

/// A step in the list.
struct Row {
    nth: usize,
    of: usize,
    title: String,
    at: String,
    tick: Option<crate::figure::Tick>,
    /// What it asks, by its key.
    note: Option<&'static str>,
}

impl Row {
    fn of(compose: &Compose, (nth, of): (usize, usize), step: &LessonStep) -> Self {
        let [title, at] = compose.rows.1.get(&step.id).cloned().unwrap_or_default();
        Self {
            nth,
            of,
            title,
            at,
            tick: compose.stands.get(&step.id).and_then(|(_, tick)| *tick),
            note: match (&step.asks, &step.goal) {
                (_, Some(_)) => Some("compose-has-goal"),
                (Some(_), None) => Some("compose-asks-first"),
                (None, None) => None,
            },
        }
    }

    fn show(&self, ui: &mut Ui, look: Look<'_>, is_open: bool) -> Response {
        let theme = look.theme;
        let line = ROW * theme.text_scale.sqrt();
        let height = if self.note.is_some() {
            1.4 * line
        } else {
            line
        };
        let size = vec2(ui.available_width(), height.round());
        let (_, rect) = ui.allocate_space(size);
        let response = ui.interact(rect, row_id(self.nth), Sense::click_and_drag());
        let said = Message::new("compose-row")
            .with("n", self.nth + 1)
            .with("total", self.of)
            .with("title", self.title.clone())
            .with("at", self.at.clone());
        let said = look.catalog.message(&said);
        response.widget_info(|| WidgetInfo::selected(Role::ListItem, true, is_open, &said));
        let painter = ui.painter().with_clip_rect(rect.intersect(ui.clip_rect()));
        ground(&painter, theme, (rect, &response), is_open);
        self.write(ui, &painter, look, (rect, line), is_open);
        response
            .on_hover_cursor(CursorIcon::PointingHand)
            .on_hover_text(&self.title)
    }

    fn write(
        &self,
        ui: &Ui,
        painter: &Painter,
        look: Look<'_>,
        (rect, line): (Rect, f32),
        is_open: bool,
    ) {
        let theme = look.theme;
        let colour = if is_open { theme.accent } else { theme.ink };
        let font = |style: TextStyle| style.resolve(ui.style());
        let left = rect.left() + 32.0;
        let y = |nth: f32| rect.top() + (0.28 + 0.42 * nth) * line;
        let number = (self.nth + 1).to_string();
        painter.text(
            pos2(rect.left() + 16.0, y(0.0)),
            Align2::CENTER_CENTER,
            number,
            font(TextStyle::Small),
            colour,
        );
        painter.text(
            pos2(left, y(0.0)),
            Align2::LEFT_CENTER,
            &self.title,
            font(theme::strong()),
            colour,
        );
        if let Some(tick) = self.tick {
            tick_sign(painter, pos2(left + 6.0, y(1.0)), tick, theme);
        }
        let small = font(TextStyle::Small);
        let mono = egui::FontId::new(small.size, egui::FontFamily::Monospace);
        painter.text(
            pos2(left + 20.0, y(1.0)),
            Align2::LEFT_CENTER,
            &self.at,
            mono,
            theme.ink,
        );
        if let Some(note) = self.note {
            painter.text(
                pos2(left, y(1.9)),
                Align2::LEFT_CENTER,
                look.say(note),
                small,
                theme.soft,
            );
        }
    }
}

/// What a row stands on, and its rim while it has the focus.
fn ground(painter: &Painter, theme: &Theme, (rect, response): (Rect, &Response), is_open: bool) {
    if is_open || response.hovered() {
        let wash = if is_open {
            theme.accent_wash
        } else {
            theme.hover
        };
        painter.rect_filled(rect, 6.0, wash);
    }
    if response.has_focus() {
        painter.rect_stroke(
            rect,
            6.0,
            theme.stroke(2.0, theme.accent),
            StrokeKind::Inside,
        );
    }
}
