//! The course: lessons, the steps of the open one, its text, its source.

use egui::{
    Frame, Panel, Response, Role, Sense, StrokeKind, TextFormat, TextStyle, Vec2, WidgetInfo,
    style::ScrollAnimation,
    text::{LayoutJob, TextWrapping},
};

use crate::widgets::{card, claimed, lesson_text, step_title};

use super::{
    App, Command,
    prelude::*,
    question::{answer_button, question_button, shown_answer},
};

const GAP: f32 = 4.0;
const CHANGED: f32 = 3.0;
/// How strongly a text is seen that speaks of another scene than the stage's.
const ASIDE: f32 = 0.6;

pub fn show(app: &App, ui: &mut Ui) {
    let look = app.look();
    let Some(lesson) = app.bookmark.lesson() else {
        ui.label(soft(look, "lesson-empty"));
        return;
    };
    ui.spacing_mut().item_spacing.y = 0.0;
    if heading(app, ui, lesson).clicked() {
        app.push(Command::Contents(!app.shown.lists_lessons));
    }
    if app.shown.lists_lessons {
        ScrollArea::vertical()
            .id_salt("lessons")
            .auto_shrink(false)
            .show(ui, |ui| lessons(app, ui));
        return;
    }
    foot(app, ui, lesson);
    padded(ui, |ui| steps(app, ui, lesson));
    let [lesson_idx, step_idx] = app.bookmark.at;
    let Some(step) = lesson.step_text(step_idx, app.settings.lang) else {
        return;
    };
    let id = Id::unique(("lesson text", lesson_idx, step_idx));
    ScrollArea::vertical()
        .id_salt(id)
        .auto_shrink(false)
        .show(ui, |ui| {
            padded(ui, |ui| {
                ui.spacing_mut().item_spacing.y = 8.0;
                step_title(ui, look, &step.title);
                if let Some(claim) = step.claim.as_ref().filter(|_| app.is_open()) {
                    claimed(ui, look, claim);
                }
                if !app.is_untouched() {
                    changed(app, ui);
                    ui.set_opacity(ASIDE);
                }
                let asked = lesson_text(ui, look, id, &step.body, app.shown.is_answered);
                app.push_all(asked.map(Command::Control));
                shown_answer(app, ui);
                let is_last = step_idx + 1 == lesson.steps.len();
                if let Some(it) = lesson.card(app.settings.lang).filter(|_| is_last) {
                    card(ui, look, it);
                }
                if !lesson.speaks(app.settings.lang) {
                    ui.label(soft(look, "lesson-not-translated").small());
                }
            });
        });
}

/// Where there is no room for it beside the stage: the numbers of the open lesson's steps, and a button that opens the rest.
pub fn strip(app: &App, ui: &mut Ui) {
    let look = app.look();
    ui.with_layout(Layout::top_down(Align::Center), |ui| {
        let open = look.say("panel-course");
        if icon_button(ui, look, Icon::LeftPanel, &open, true).clicked() {
            app.push(Command::Course);
        }
        let Some(lesson) = app.bookmark.lesson() else {
            return;
        };
        question_button(app, ui);
        ui.add_space(12.0);
        ScrollArea::vertical().show(ui, |ui| {
            ui.spacing_mut().item_spacing.y = 8.0;
            discs(app, ui, lesson, f32::INFINITY);
        });
    });
}

fn heading(app: &App, ui: &mut Ui, lesson: &Lesson) -> Response {
    let look = app.look();
    let [lesson_idx, _] = app.bookmark.at;
    let heading = Row {
        number: "",
        title: &format!(
            "{} · {}",
            app.bookmark.course.number(lesson_idx),
            lesson.title(app.settings.lang)
        ),
        is_open: true,
        is_changed: has_changes(app, lesson_idx, lesson),
    };
    let response = row(ui, look, heading).on_hover_text(look.say("lesson-contents"));
    let middle = pos2(response.rect.left() + 16.0, response.rect.center().y);
    let down = if app.shown.lists_lessons { -1.0 } else { 1.0 };
    let corners = [[-4.0, -2.0], [4.0, -2.0], [0.0, 3.0]].map(|[x, y]| middle + vec2(x, down * y));
    let triangle = egui::Shape::convex_polygon(corners.into(), look.theme.accent, Stroke::NONE);
    ui.painter().add(triangle);
    ui.add_space(12.0);
    response
}

fn foot(app: &App, ui: &mut Ui, lesson: &Lesson) {
    let look = app.look();
    let has_source = !lesson.source.is_empty() && !app.is_low();
    if !has_source && !app.has_answer() {
        return;
    }
    Panel::bottom("under the lesson")
        .frame(Frame::NONE)
        .show_separator_line(false)
        .show(ui, |ui| {
            padded(ui, |ui| {
                ui.spacing_mut().item_spacing.y = 8.0;
                ui.add_space(4.0);
                answer_button(app, ui);
                if has_source {
                    let text = RichText::new(&lesson.source).small();
                    ui.add(Label::new(text.color(look.theme.soft)).truncate());
                }
            });
        });
}

fn padded<R>(ui: &mut Ui, content: impl FnOnce(&mut Ui) -> R) -> R {
    Frame::new()
        .inner_margin(egui::Margin::symmetric(8, 0))
        .show(ui, content)
        .inner
}

fn lessons(app: &App, ui: &mut Ui) {
    ui.spacing_mut().item_spacing.y = 0.0;
    let [open, _] = app.bookmark.at;
    for page in app.free_scenes() {
        let unnamed = || app.look().say("action-free");
        let free = Row {
            number: "+",
            title: &page.name().map_or_else(unnamed, str::to_owned),
            ..Row::default()
        };
        if row(ui, app.look(), free).clicked() {
            app.push(Command::OpenPage(page));
        }
    }
    for (i, lesson) in app.bookmark.course.lessons.iter().enumerate() {
        let row_of = Row {
            number: &app.bookmark.course.number(i).to_string(),
            title: lesson.title(app.settings.lang),
            is_open: i == open,
            is_changed: has_changes(app, i, lesson),
        };
        let response = row(ui, app.look(), row_of);
        if i == open {
            bring_into_view(ui, open, response.rect);
        }
        if response.clicked() {
            app.push(Command::Open([i, 0]));
        }
    }
    courses(app, ui);
}

/// Other courses, under the lessons of this one.
fn courses(app: &App, ui: &mut Ui) {
    let others = app.other_courses();
    if others.is_empty() {
        return;
    }
    let look = app.look();
    ui.add_space(8.0);
    padded(ui, |ui| ui.label(soft(look, "courses").small()));
    for folder in others {
        let title = match folder {
            Some(path) => path.to_owned(),
            None => look.say("course-built-in"),
        };
        let other = Row {
            title: &title,
            ..Row::default()
        };
        if row(ui, look, other).clicked() {
            app.push(Command::OpenCourse(folder.map(str::to_owned)));
        }
    }
}

/// Scrolls to the open lesson when it has become another one, and leaves the list alone after that.
fn bring_into_view(ui: &Ui, open: usize, rect: Rect) {
    let id = Id::unique("lesson in view");
    if ui.data(|data| data.get_temp(id)) == Some(open) {
        return;
    }
    ui.data_mut(|data| data.insert_temp(id, open));
    ui.scroll_to_rect_animation(rect, Some(Align::Center), ScrollAnimation::none());
    ui.ctx().request_repaint();
}

fn has_changes(app: &App, idx: usize, lesson: &Lesson) -> bool {
    (0..lesson.steps.len()).any(|step| is_changed(app, idx, step))
}

fn is_changed(app: &App, lesson: usize, step: usize) -> bool {
    if [lesson, step] == app.bookmark.at {
        return !app.is_untouched();
    }
    let page = app.bookmark.page_of([lesson, step]);
    page.is_some_and(|page| app.desk.is_changed(&page))
}

/// A lesson in the list, or a step among the numbers.
#[derive(Clone, Copy, Default)]
struct Row<'a> {
    number: &'a str,
    title: &'a str,
    is_open: bool,
    is_changed: bool,
}

fn named(look: Look<'_>, title: &str, is_changed: bool) -> String {
    if is_changed {
        format!("{title}: {}", look.say("lesson-has-changes"))
    } else {
        title.to_owned()
    }
}

fn row(ui: &mut Ui, look: Look<'_>, row: Row<'_>) -> Response {
    let theme = look.theme;
    let height = (28.0 * theme.text_scale.sqrt()).round();
    let (rect, response) =
        ui.allocate_exact_size(vec2(ui.available_width(), height), Sense::click());
    let name = named(look, row.title, row.is_changed);
    response.widget_info(|| WidgetInfo::selected(Role::Tab, true, row.is_open, &name));
    let plate = rect.shrink2(vec2(0.0, 1.0));
    if row.is_open {
        ui.painter().rect_filled(plate, 6.0, theme.accent_wash);
    } else if response.hovered() {
        ui.painter().rect_filled(plate, 6.0, theme.hover);
    }
    if response.has_focus() {
        let rim = theme.stroke(2.0, theme.accent);
        ui.painter()
            .rect_stroke(plate, 6.0, rim, StrokeKind::Inside);
    }
    let is_cut = words(ui, theme, rect, row);
    let response = response.on_hover_cursor(CursorIcon::PointingHand);
    if is_cut || row.is_changed {
        response.on_hover_text(name)
    } else {
        response
    }
}

fn words(ui: &Ui, theme: &Theme, rect: Rect, row: Row<'_>) -> bool {
    let y = rect.center().y;
    if row.is_changed {
        let at = pos2(rect.right() - 6.0, y);
        ui.painter().circle_filled(at, CHANGED, theme.accent);
    }
    let small = TextStyle::Small.resolve(ui.style());
    let (style, colour, of_number) = if row.is_open {
        (theme::strong(), theme.ink, theme.accent)
    } else {
        (TextStyle::Body, theme.soft, theme.faint)
    };
    let at = pos2(rect.left() + 16.0, y);
    ui.painter()
        .text(at, Align2::CENTER_CENTER, row.number, small, of_number);
    let left = rect.left() + 32.0;
    let format = TextFormat::simple(style.resolve(ui.style()), colour);
    let mut job = LayoutJob::single_section(row.title.to_owned(), format);
    job.wrap = TextWrapping::truncate_at_width(rect.right() - 12.0 - left);
    let galley = ui.fonts_mut(|fonts| fonts.layout_job(job));
    let is_cut = galley.elided;
    let at = pos2(left, y - 0.5 * galley.size().y);
    ui.painter().galley(at, galley, colour);
    is_cut
}

fn steps(app: &App, ui: &mut Ui, lesson: &Lesson) {
    let n_steps = lesson.steps.len().max(1) as f32;
    let room = (ui.available_width() + GAP) / n_steps - GAP;
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = GAP;
        discs(app, ui, lesson, room);
    });
    ui.add_space(12.0);
}

impl Row<'_> {
    fn disc(&self, ui: &mut Ui, look: Look<'_>, room: f32) -> bool {
        let theme = look.theme;
        let size = (22.0 * theme.text_scale.sqrt()).min(room).floor();
        let (rect, response) = ui.allocate_exact_size(Vec2::splat(size), Sense::click());
        let title = named(look, self.title, self.is_changed);
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
        if self.is_changed {
            // At its upper right, ringed: seen on the open one too.
            let at = centre + 0.8 * radius * vec2(1.0, -1.0);
            let ring = Stroke::new(1.5, theme.panel);
            painter.circle(at, CHANGED + 0.5, theme.accent, ring);
        }
    }
}

fn changed(app: &App, ui: &mut Ui) {
    let look = app.look();
    ui.with_layout(Layout::top_down(Align::Min), |ui| {
        ui.label(soft(look, "lesson-changed").small());
        let restore = Button::new(accent(look, "lesson-restore")).frame(false);
        if ui.add(restore).clicked() {
            app.push(Command::Reset);
        }
    });
}

fn discs(app: &App, ui: &mut Ui, lesson: &Lesson, room: f32) {
    let [lesson_idx, open] = app.bookmark.at;
    for i in 0..lesson.steps.len() {
        let step = Row {
            number: &(i + 1).to_string(),
            title: lesson.step_title(i, app.settings.lang).unwrap_or_default(),
            is_open: i == open,
            is_changed: is_changed(app, lesson_idx, i),
        };
        if step.disc(ui, app.look(), room) {
            app.push(Command::Open([lesson_idx, i]));
        }
    }
}
