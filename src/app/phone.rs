//! The window in one hand: the stage over its whole width, the lesson as a sheet that peeks in, one large button that goes a step on.
//! Course and inspector take the stage's place: a tap or a swipe away.

use egui::{CornerRadius, Frame, Panel, Response, Sense, TextStyle, Vec2, WidgetInfo};

use crate::widgets::{TARGET, large_button, lesson_text, step_title};

use super::{
    App, Command,
    bars::{step_told, timeline},
    menus,
    prelude::*,
    room::Room,
};

/// What goes a step on.
const LARGE: f32 = 56.0;
/// Heights of the bars over and under the stage.
pub const BARS: [f32; 2] = [56.0, 92.0];
/// A finger that has gone less far has not swiped.
const SWIPE: f32 = 36.0;
/// Rows of the lesson's text that peek in.
const PEEK: f32 = 2.6;
const GRIP: Vec2 = vec2(40.0, 4.0);

/// The lesson's name over a dash for each of its steps, between the ways to course, inspector and menus. Swiped, the next step of the
/// lesson, or the one before.
pub fn top(app: &App, ui: &mut Ui, panels: &mut [Box<dyn LabPanel>]) {
    let look = app.look();
    ui.spacing_mut().item_spacing.x = 0.0;
    // Methods are picked in the inspector, which is not open at first.
    menus::compare_is_in_the_bar(ui.ctx(), false);
    ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
        way_to(app, ui, Room::Course);
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            menus::behind_one_button(app, ui, panels);
            way_to(app, ui, Room::Inspector);
            let (rect, response) = ui.allocate_exact_size(ui.available_size(), Sense::drag());
            let title = title(app);
            response.widget_info(|| WidgetInfo::labeled(egui::Role::Heading, true, &title));
            let by = swiped(ui, &response);
            if by.x.abs() > by.y.abs() {
                let forward = by.x < 0.0;
                app.push(Command::Lesson { forward });
            }
            let font = theme::strong().resolve(ui.style());
            let mut job = egui::text::LayoutJob::simple_singleline(title, font, look.theme.ink);
            job.wrap = egui::text::TextWrapping::truncate_at_width(rect.width() - 8.0);
            let words = ui.fonts_mut(|fonts| fonts.layout_job(job));
            let has_dashes = app.bookmark.step().is_some();
            let up = if has_dashes { 6.0 } else { 0.0 };
            let at = rect.center() - 0.5 * words.size() - vec2(0.0, up);
            ui.painter().galley(at, words, look.theme.ink);
            if has_dashes {
                dashes(app, ui, rect);
            }
        });
    });
}

fn title(app: &App) -> String {
    let (look, lang) = (app.look(), app.settings.lang);
    match (&app.bookmark.free, app.bookmark.lesson()) {
        (None, Some(lesson)) => lesson.title(lang).to_owned(),
        (Some(free), _) => free.name.clone().unwrap_or_else(|| look.say("action-free")),
        (None, None) => look.say("app-title"),
    }
}

fn dashes(app: &App, ui: &Ui, rect: Rect) {
    const GAP: f32 = 4.0;
    const MOST: f32 = 20.0;
    let (theme, [_, open]) = (app.look().theme, app.bookmark.at);
    let n_steps = app.bookmark.lesson().map_or(0, |lesson| lesson.steps.len());
    let each = ((rect.width() - 8.0) / n_steps.max(1) as f32).min(MOST + GAP);
    let left = rect.center().x - 0.5 * each * n_steps as f32;
    for i in 0..n_steps {
        let at = pos2(left + each * i as f32 + 0.5 * GAP, rect.center().y + 12.0);
        let dash = Rect::from_min_size(at.round(), vec2(each - GAP, 4.0));
        let colour = if i <= open {
            theme.accent
        } else {
            theme.hairline
        };
        ui.painter().rect_filled(dash, 2.0, colour);
    }
}

/// Into a room, and out of it again.
fn way_to(app: &App, ui: &mut Ui, room: Room) {
    let (icon, key, command) = match room {
        Room::Inspector => (Icon::RightPanel, "panel-inspector", Command::Inspector),
        Room::Course | Room::Stage => (Icon::LeftPanel, "panel-course", Command::Course),
    };
    let is_open = app.room() == room;
    let icon = if is_open { Icon::Close } else { icon };
    if icon_button(ui, app.look(), icon, &app.look().say(key), true).clicked() {
        app.push(command);
    }
}

pub fn transport(app: &App, ui: &mut Ui) {
    let (look, transport) = (app.look(), &app.playback.transport);
    let [step, n_steps] = [transport.position(), transport.n_steps()];
    ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
        let back = look.say("transport-back");
        if icon_button(ui, look, Icon::Back, &back, step > 0).clicked() {
            app.push(Command::Step(-1));
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            forward(app, ui);
            ui.add_space(4.0);
            let (rect, _) = ui.allocate_exact_size(ui.available_size(), Sense::hover());
            let row = TextStyle::Body.resolve(ui.style()).size * 1.4;
            let inner = rect.shrink2(vec2(0.0, 0.5 * (rect.height() - TARGET - row).max(0.0)));
            let line = UiBuilder::new().max_rect(inner);
            ui.scope_builder(line.layout(Layout::top_down(Align::Center)), |ui| {
                ui.spacing_mut().item_spacing.y = 0.0;
                timeline(app, ui);
                let told = RichText::new(step_told(app, [step, n_steps]));
                ui.label(told.color(look.theme.soft));
            });
        });
    });
}

/// A step on; at the end of the run, to the lesson's next step. Held, it plays.
fn forward(app: &App, ui: &mut Ui) {
    let (look, transport) = (app.look(), &app.playback.transport);
    let is_at_end = transport.position() >= transport.n_steps();
    let (icon, key, command) = if transport.is_playing() {
        (Icon::Pause, "transport-pause", Command::Play)
    } else if is_at_end {
        let next = Command::Lesson { forward: true };
        (Icon::Last, "transport-next-page", next)
    } else {
        (Icon::Play, "transport-forward", Command::Step(1))
    };
    let can_go = !app.practice.is_asking();
    let button = large_button(ui, look, (icon, LARGE), &look.say(key), can_go);
    if button.long_touched() {
        app.push(Command::Play);
    } else if button.clicked() {
        app.push(command);
    }
}

/// What the finger that has just been lifted from there has swiped.
fn swiped(ui: &Ui, response: &Response) -> Vec2 {
    let id = response.id.with("swiped");
    let so_far: Vec2 = ui.data(|data| data.get_temp(id)).unwrap_or_default();
    let now = so_far + response.drag_delta();
    let is_over = !response.dragged();
    let kept = if is_over { Vec2::ZERO } else { now };
    ui.data_mut(|data| data.insert_temp(id, kept));
    let is_far = response.drag_stopped() && now.length() > SWIPE;
    if is_far { now } else { Vec2::ZERO }
}

fn grip(ui: &Ui, look: Look<'_>, rect: Rect) {
    let at = pos2(rect.center().x, rect.top() + 8.0);
    let grip = Rect::from_center_size(at, GRIP);
    ui.painter().rect_filled(grip, 2.0, look.theme.faint);
}

/// The title of the open step, and how its text begins: tapped or swiped up, all of it; swiped to the left, the inspector.
pub fn sheet(app: &App, ui: &mut Ui) {
    let practice = &app.practice;
    let is_asked = practice.is_on || practice.asked.is_some() || !practice.kept.is_empty();
    let [lesson_idx, step_idx] = app.bookmark.at;
    let lesson = app.bookmark.step().and(app.bookmark.lesson());
    let step = lesson.and_then(|it| it.step_text(step_idx, app.settings.lang));
    let Some(step) = step.filter(|_| !is_asked) else {
        return;
    };
    let look = app.look();
    let row = TextStyle::Body.resolve(ui.style()).size * 1.4;
    let height =
        (20.0 + TextStyle::Heading.resolve(ui.style()).size * 1.4 + 8.0 + PEEK * row).round();
    let frame = Frame::new().fill(look.theme.panel);
    let frame = frame.corner_radius(CornerRadius {
        nw: 12,
        ne: 12,
        ..CornerRadius::ZERO
    });
    let panel = Panel::bottom("sheet").exact_size(height).resizable(false);
    panel.frame(frame).show(ui, |ui| {
        let rect = ui.max_rect();
        let mut inner = rect.shrink2(vec2(16.0, 0.0));
        inner.min.y += 18.0;
        // Taller than its place: it is cut there.
        let mut text = ui.new_child(UiBuilder::new().max_rect(inner));
        text.shrink_clip_rect(inner.expand2(vec2(4.0, 0.0)));
        step_title(&mut text, look, &step.title);
        let id = Id::unique(("sheet", lesson_idx, step_idx));
        lesson_text(&mut text, look, id, &step.body, app.text_told());
        ui.advance_cursor_after_rect(rect);
        grip(ui, look, rect);
        let id = Id::unique("sheet of the lesson");
        let response = ui.interact(rect, id, Sense::click_and_drag());
        let name = look.say("panel-course");
        response.widget_info(|| WidgetInfo::labeled(egui::Role::Button, true, &name));
        let by = swiped(ui, &response);
        if response.clicked() || -by.y > by.x.abs() {
            app.push(Command::Course);
        } else if -by.x > by.y.abs() {
            app.push(Command::Inspector);
        }
    });
}

/// Over a room that has taken the stage's place: tapped, swiped down or to the right, the stage again.
pub fn way_back(app: &App, ui: &mut Ui) {
    let look = app.look();
    let size = vec2(ui.available_width(), TARGET);
    let (rect, response) = ui.allocate_exact_size(size, Sense::click_and_drag());
    grip(ui, look, rect);
    let name = look.say("panel-stage");
    response.widget_info(|| WidgetInfo::labeled(egui::Role::Button, true, &name));
    let by = swiped(ui, &response);
    if response.clicked() || by.y > by.x.abs() || by.x > by.y.abs() {
        app.push(match app.room() {
            Room::Inspector => Command::Inspector,
            Room::Course | Room::Stage => Command::Course,
        });
    }
}
