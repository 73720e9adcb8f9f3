//! What the open step asks, under the stage of those who see no lesson text, because it is presented or folded away; and its
//! answer, once it is shown.

use egui::{Frame, Panel, Vec2};

use crate::widgets::lesson_text;

use super::{App, Command, in_sight::scroll_to_new, prelude::*};

/// Of the window's height.
const MOST: f32 = 0.34;
/// Letters reach out of their line a little.
const LEADING: f32 = 4.0;
const MARGIN: Margin = Margin::symmetric(24, 12);

pub fn show(app: &App, ui: &mut Ui) {
    let (look, [lesson_idx, step_idx]) = (app.look(), app.bookmark.at);
    let lesson = app.bookmark.step().and(app.bookmark.lesson());
    let Some(step) = lesson.and_then(|it| it.step_text(step_idx, app.settings.lang)) else {
        return;
    };
    let Some(asked) = step.question().filter(|_| app.is_untouched()) else {
        return;
    };
    let frame = Frame::new().fill(look.theme.panel);
    let most = MOST * ui.max_rect().height();
    let id = Id::unique(("question", lesson_idx, step_idx));
    // A panel keeps the height that it had, and what scrolls in it would never have more.
    let height: f32 = ui.data(|data| data.get_temp(id)).unwrap_or_default();
    let said = Panel::bottom("question")
        .frame(frame.inner_margin(MARGIN))
        .exact_size((height + LEADING).min(most) + MARGIN.sum().y)
        .show(ui, |ui| {
            ScrollArea::vertical()
                .id_salt(id)
                .auto_shrink(false)
                .min_scrolled_height(0.0)
                .show(ui, |ui| {
                    let led_to = lesson_text(ui, look, id, asked, app.text_told());
                    app.push_all(led_to.map(Command::Control));
                    if !app.is_presenting() {
                        answer_button(app, ui);
                    }
                    shown_answer(app, ui);
                })
        });
    let needed = said.inner.content_size.y;
    if needed != height {
        ui.data_mut(|data| data.insert_temp(id, needed));
        ui.request_discard("the question is as high as what it says");
    }
}

/// Shows the question where the lesson's text is folded away.
pub fn question_button(app: &App, ui: &mut Ui) {
    if app.has_answer() {
        let name = app.look().say("lesson-question");
        if icon_button(ui, app.look(), Icon::Question, &name, true).clicked() {
            app.push(Command::Question);
        }
    }
}

pub fn answer_button(app: &App, ui: &mut Ui) {
    if app.has_answer() {
        let key = ["lesson-answer-show", "lesson-answer-hide"];
        let key = key[usize::from(app.shown.is_answered)];
        if ui.add(Button::new(accent(app.look(), key))).clicked() {
            app.push(Command::Answer(!app.shown.is_answered));
        }
    }
}

/// Scrolls to an answer that has just been shown, once what stands above this place has been drawn.
pub fn shown_answer(app: &App, ui: &Ui) {
    let end = Rect::from_min_size(ui.cursor().min, Vec2::ZERO);
    let count = usize::from(app.shown.is_answered);
    scroll_to_new(ui, "an answer in sight", count, end);
}
