//! What was asked of this run, what was answered, and what is right: a wrong answer stays beside the right one, struck out.

use egui::{Color32, Role, Sense, TextStyle, WidgetInfo};

use crate::{
    figure::Choice,
    paint::{Span, Typeset},
};

use super::{App, in_sight::scroll_to_new, prelude::*};

const SIGN: f32 = 6.0;
/// While something is asked no more of the last answers are shown.
const MOST_WHILE_ASKED: usize = 3;

pub struct Answer {
    pub step: usize,
    pub choice: Choice,
    pub chosen: usize,
    pub is_shown: bool,
}

impl Answer {
    const fn is_right(&self) -> bool {
        self.chosen == self.choice.right
    }
}

/// One row a question, the last ones while another is asked; nothing where marks come at the end, and it is not there yet. A new
/// row is scrolled into sight.
pub fn table(app: &App, ui: &mut Ui) {
    // What is asked once more, and what comes after that, is not told here.
    let asked = app.practice.step_asked();
    let answers = app.answers_told().iter();
    let told = answers.filter(|answer| asked.is_none_or(|open| answer.step < open));
    let told: Vec<&Answer> = told.collect();
    let top = ui.cursor().min;
    let n_rows = told.len();
    // What the next answer needs has room: code and watched values.
    let n_folded = match asked {
        Some(_) if n_rows > MOST_WHILE_ASKED => n_rows - MOST_WHILE_ASKED,
        _ => 0,
    };
    if n_folded > 0 {
        let earlier = Message::new("answers-earlier").with("count", Value::Count(n_folded));
        let earlier = RichText::new(app.look().catalog.message(&earlier));
        ui.label(earlier.color(app.look().theme.soft));
    }
    for answer in &told[n_folded..] {
        row(app, ui, answer);
    }
    let end = ui.min_rect().max;
    let last = Rect::from_min_max(pos2(top.x, end.y - 1.0), end);
    scroll_to_new(ui, "answers", n_rows, last);
}

impl App {
    /// The answers of which it may be told whether they are right.
    pub(super) fn answers_told(&self) -> &[Answer] {
        let practice = &self.practice;
        let waits = self.settings.marks_at_end && practice.asked.is_some() && practice.is_on;
        if waits { &[] } else { &practice.answers }
    }
}

fn row(app: &App, ui: &mut Ui, answer: &Answer) {
    let look = app.look();
    let theme = look.theme;
    let said = answer.choice.said(look.catalog);
    let [right, chosen] = [answer.choice.right, answer.chosen].map(|nth| &*said[nth]);
    let (body, strong) = (TextStyle::Body.resolve(ui.style()), theme::strong());
    let plain = |text: &str| Span::text(text, body.clone(), theme.soft);
    let mut spans = vec![plain(&format!("{}\u{2002}", answer.step))];
    let first = spans[0].n_chars();
    let mut struck = first..first;
    if !answer.is_right() {
        spans.push(plain(chosen));
        struck.end += spans[1].n_chars();
        spans.push(plain("\u{2002}"));
    }
    spans.push(Span::text(right, strong.resolve(ui.style()), theme.ink));
    let key = match (answer.is_shown, answer.is_right()) {
        (true, _) => "answer-shown",
        (false, true) => "answer-right",
        (false, false) => "answer-wrong",
    };
    let name = Message::new(key)
        .with("step", Value::Count(answer.step))
        .with("right", right.to_owned())
        .with("chosen", chosen.to_owned());
    let name = look.catalog.message(&name);
    ui.horizontal_top(|ui| {
        let size = vec2(2.0 * SIGN + 4.0, body.size * 1.3);
        let (place, _) = ui.allocate_exact_size(size, Sense::hover());
        sign(ui, theme, place.center(), answer);
        let set = Typeset::running(ui.painter(), &spans, ui.available_width(), 0.0);
        let label = ui.add(Label::new(set.galley()));
        for part in set.boxes(struck) {
            let part = part.translate(label.rect.min.to_vec2());
            let line = Stroke::new(1.0, theme.soft);
            ui.painter().hline(part.x_range(), part.center().y, line);
        }
        label.widget_info(|| WidgetInfo::labeled(Role::Label, true, &name));
    });
}

/// Right is filled, with a tick; wrong is hollow, with a cross; what was shown is a ring.
fn sign(ui: &Ui, theme: &Theme, at: Pos2, answer: &Answer) {
    let painter = ui.painter();
    let line = |ends: [[f32; 2]; 2], colour: Color32| {
        let ends = ends.map(|[x, y]| at + 0.5 * SIGN * vec2(x, y));
        painter.line_segment(ends, Stroke::new(1.5, colour));
    };
    if answer.is_shown {
        painter.circle_stroke(at, SIGN - 1.0, Stroke::new(1.5, theme.soft));
    } else if answer.is_right() {
        painter.circle_filled(at, SIGN, theme.accent);
        line([[-1.0, 0.0], [-0.25, 0.8]], theme.background);
        line([[-0.25, 0.8], [1.0, -0.8]], theme.background);
    } else {
        painter.circle_stroke(at, SIGN - 0.5, Stroke::new(1.5, theme.ink));
        line([[-0.8, -0.8], [0.8, 0.8]], theme.ink);
        line([[-0.8, 0.8], [0.8, -0.8]], theme.ink);
    }
}
