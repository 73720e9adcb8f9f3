//! The steps of the open lesson: a disc for each, with its number and its marks.

use egui::{Response, Role, Sense, TextStyle, Vec2, WidgetInfo};

use crate::widgets::target;

use super::{App, Command, marks, prelude::*};

const GAP: f32 = 4.0;
/// A number of two digits has room in it.
const LEAST: f32 = 14.0;
/// Between two rows, for the marks.
const UNDER: f32 = 12.0;
pub const CHANGED: f32 = 3.0;

pub fn steps(app: &App, ui: &mut Ui, lesson: &Lesson) {
    let n_steps = lesson.steps.len().max(1) as f32;
    let room = (ui.available_width() + GAP) / n_steps - GAP;
    let least = target(ui, LEAST * app.look().theme.text_scale.sqrt());
    let is_crowded = room < least;
    let room = room.max(least);
    let row = |ui: &mut Ui| {
        ui.spacing_mut().item_spacing = vec2(GAP, UNDER);
        discs(app, ui, lesson, room);
    };
    // In as many rows as numbers, or fingers, want.
    if is_crowded {
        ui.horizontal_wrapped(row);
    } else {
        ui.horizontal(row);
    }
    ui.add_space(12.0);
}

/// A step among the numbers.
struct Disc<'a> {
    number: &'a str,
    title: &'a str,
    is_open: bool,
    is_changed: bool,
    /// How its question was answered, where it asks one.
    told: Option<Told>,
    /// Has its goal been reached, where it has one?
    reached: Option<bool>,
}

impl Disc<'_> {
    fn show(&self, ui: &mut Ui, look: Look<'_>, room: f32) -> bool {
        let theme = look.theme;
        let size = (22.0 * theme.text_scale.sqrt()).min(room).floor();
        let place = Vec2::splat(target(ui, size));
        let (place, response) = ui.allocate_exact_size(place, Sense::click());
        let rect = Rect::from_center_size(place.center(), Vec2::splat(size));
        let mut title = named(look, self.title, self.is_changed);
        if let Some(told) = self.told {
            title = format!("{title}: {}", look.say(marks::key(told)));
        }
        if let Some(is_reached) = self.reached {
            title = format!("{title}: {}", look.say(marks::goal_key(is_reached)));
        }
        let name = format!("{}: {title}", self.number);
        response.widget_info(|| WidgetInfo::selected(Role::Tab, true, self.is_open, &name));
        self.draw_disc(ui, theme, rect, &response);
        response
            .on_hover_cursor(CursorIcon::PointingHand)
            .on_hover_text(title)
            .clicked()
    }

    fn draw_disc(&self, ui: &Ui, theme: &Theme, rect: Rect, response: &Response) {
        let (fill, text, rim) = match (self.is_open, response.hovered()) {
            (true, _) => (theme.accent, theme.background, theme.accent),
            (false, true) => (theme.hover, theme.ink, theme.hairline),
            (false, false) => (theme.panel, theme.soft, theme.hairline),
        };
        let (painter, centre) = (ui.painter(), rect.center());
        let radius = 0.5 * rect.width() - 0.5;
        painter.circle(centre, radius, fill, Stroke::new(1.0, rim));
        if response.has_focus() {
            painter.circle_stroke(centre, radius + 2.0, theme.stroke(2.0, theme.accent));
        }
        let font = TextStyle::Small.resolve(ui.style());
        painter.text(centre, Align2::CENTER_CENTER, self.number, font, text);
        if let Some(told) = self.told {
            let at = centre + vec2(0.0, radius + 4.5);
            marks::draw(painter, theme, at, told);
        } else if let Some(is_reached) = self.reached {
            let at = centre + vec2(0.0, radius + 4.5);
            marks::draw_goal(painter, theme, at, is_reached);
        }
        if self.is_changed {
            // At its upper right, ringed: seen on the open one too.
            let at = centre + 0.8 * radius * vec2(1.0, -1.0);
            let ring = Stroke::new(1.5, theme.panel);
            painter.circle(at, CHANGED + 0.5, theme.accent, ring);
        }
    }
}

pub fn discs(app: &App, ui: &mut Ui, lesson: &Lesson, room: f32) {
    let [lesson_idx, open] = app.bookmark.at;
    for i in 0..lesson.steps.len() {
        let step = Disc {
            number: &(i + 1).to_string(),
            title: lesson.step_title(i, app.settings.lang).unwrap_or_default(),
            is_open: i == open,
            is_changed: is_changed(app, lesson_idx, i),
            told: app.told_of(lesson, &lesson.steps[i]),
            reached: app.reached_of(lesson, &lesson.steps[i]),
        };
        if step.show(ui, app.look(), room) {
            app.push(Command::Open([lesson_idx, i]));
        }
    }
}

pub fn is_changed(app: &App, lesson: usize, step: usize) -> bool {
    if [lesson, step] == app.bookmark.at {
        return !app.is_untouched();
    }
    let page = app.bookmark.page_of([lesson, step]);
    page.is_some_and(|page| app.desk.is_changed(&page))
}

pub fn named(look: Look<'_>, title: &str, is_changed: bool) -> String {
    if is_changed {
        format!("{title}: {}", look.say("lesson-has-changes"))
    } else {
        title.to_owned()
    }
}
