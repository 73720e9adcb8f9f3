//! The course: lessons, the steps of the open one, its text, its source.

use egui::{Frame, Panel, Response, Stroke, style::ScrollAnimation};

use crate::{
    lesson::{Block, StepText},
    widgets::{card, claimed, lesson_text, quiet_button, step_title},
};

use super::{
    App, Command,
    course_row::{Row, row},
    course_steps::{discs, is_changed, steps},
    goal_panel,
    prelude::*,
    question::{answer_button, question_button, shown_answer},
};

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
                text(app, ui, (lesson, step), id);
            });
        });
}

/// The text of the open step; while the step asks what comes, as far as that may be read.
fn text(app: &App, ui: &mut Ui, (lesson, step): (&Lesson, &StepText), id: Id) {
    let look = app.look();
    step_title(ui, look, &step.title);
    if let Some(claim) = step.claim.as_ref().filter(|_| app.is_open()) {
        claimed(ui, look, claim);
    }
    let has_goal = !app.met().is_empty();
    if !app.is_untouched() {
        changed(app, ui);
        // What is to be reached is read as long as it is not.
        if !has_goal {
            ui.set_opacity(ASIDE);
        }
    }
    let told = app.text_told();
    let waits = |block: &Block| *block == Block::Wait;
    let is_shown = !told.waits || step.body.iter().any(waits);
    let body = if is_shown { &step.body[..] } else { &[] };
    let asked = lesson_text(ui, look, id, body, told);
    app.push_all(asked.map(Command::Control));
    if told.waits {
        ui.add(Label::new(soft(look, "lesson-waits")).wrap());
        return;
    }
    if app.is_reached() {
        reached(app, ui);
    }
    if has_goal {
        goal_panel::show(app, ui);
    }
    shown_answer(app, ui);
    let is_last = app.bookmark.at[1] + 1 == lesson.steps.len();
    if let Some(it) = lesson
        .card(app.settings.lang)
        .filter(|_| is_last && !app.is_hunting())
    {
        card(ui, look, it);
    }
    if !lesson.speaks(app.settings.lang) {
        ui.label(soft(look, "lesson-not-translated").small());
    }
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
        ..Row::default()
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
    let waits = app.practice.asks_for_a_step();
    let asks = app.bookmark.step().is_some_and(|step| step.asks.is_some()) && !waits;
    let has_answer = app.has_answer() && !waits;
    let has_hint = goal_panel::has_hint(app) && !waits;
    if !has_source && !has_answer && !asks && !has_hint {
        return;
    }
    Panel::bottom("under the lesson")
        .frame(Frame::NONE)
        .show_separator_line(false)
        .show(ui, |ui| {
            padded(ui, |ui| {
                ui.spacing_mut().item_spacing.y = 8.0;
                ui.add_space(4.0);
                if has_hint {
                    goal_panel::hint_button(app, ui);
                }
                if has_answer {
                    answer_button(app, ui);
                }
                if asks
                    && ui
                        .add(Button::new(accent(look, "lesson-ask-again")))
                        .clicked()
                {
                    app.push(Command::AskAgain);
                }
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
            tally: &app.tally_of(lesson),
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
    for &folder in &others {
        let title = match folder {
            Some(path) => short_name(path, &others),
            None => look.say("course-built-in"),
        };
        let other = Row {
            title: &title,
            ..Row::default()
        };
        let shown = row(ui, look, other);
        let shown = match folder {
            Some(path) => shown.on_hover_text(path),
            None => shown,
        };
        if shown.clicked() {
            app.push(Command::OpenCourse(folder.map(str::to_owned)));
        }
    }
}

/// A folder's own name, with those before it as far as another has the same: what tells folders apart stands at their end.
fn short_name(path: &str, all: &[Option<&str>]) -> String {
    let own: Vec<&str> = from_its_end(path).collect();
    let is_of_another = |n: usize| {
        let mut others = all.iter().flatten().filter(|other| **other != path);
        others.any(|other| from_its_end(other).take(n).eq(own.iter().copied().take(n)))
    };
    let n = (1..own.len()).find(|&n| !is_of_another(n));
    let mut shown = own[..n.unwrap_or(own.len())].to_vec();
    shown.reverse();
    shown.join("/")
}

fn from_its_end(path: &str) -> impl Iterator<Item = &str> {
    path.rsplit(['/', '\\']).filter(|part| !part.is_empty())
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

/// All parts of the goal hold.
fn reached(app: &App, ui: &mut Ui) {
    let look = app.look();
    let label = ui.label(accent(look, "goal-reached"));
    let live = |node: &mut egui::accesskit::Node| node.set_live(egui::accesskit::Live::Polite);
    ui.ctx().accesskit_node_builder(label.id, live);
}

fn changed(app: &App, ui: &mut Ui) {
    let look = app.look();
    ui.with_layout(Layout::top_down(Align::Min), |ui| {
        ui.label(soft(look, "lesson-changed").small());
        let restore = Button::new(accent(look, "lesson-restore"));
        if quiet_button(ui, look, restore).clicked() {
            app.push(Command::Reset);
        }
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_folder_is_named_by_what_tells_it_apart() {
        let paths = [
            "/home/a/course",
            "/home/b/course",
            "/home/b/lines",
            "C:\\own\\cuts",
        ];
        let all = paths.map(Some);
        let names = paths.map(|path| short_name(path, &all));
        assert_eq!(names, ["a/course", "b/course", "lines", "cuts"]);
    }
}
