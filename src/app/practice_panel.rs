//! What is asked, under the stage: the question with what might come; then what was said, and what comes.

use egui::{Frame, Panel, Role, WidgetInfo, accesskit::Live};

use super::{
    App, Command,
    practice::{Asked, DIGITS},
    prelude::*,
};

/// Of the window's height.
const MOST: f32 = 0.4;

/// What the pointer is on, of what might come.
pub fn show(app: &App, ui: &mut Ui, lit: Option<Link>) -> Option<Link> {
    if !app.practice.is_on && app.practice.asked.is_none() {
        return None;
    }
    let look = app.look();
    let most = MOST * ui.max_rect().height();
    let frame = Frame::new().fill(look.theme.panel);
    Panel::bottom("practice")
        .frame(frame.inner_margin(Margin::symmetric(24, 10)))
        .show(ui, |ui| {
            ScrollArea::vertical()
                .id_salt("practice")
                .max_height(most)
                .min_scrolled_height(most)
                .auto_shrink([false, true])
                .show(ui, |ui| in_kept_room(app, ui, lit))
                .inner
        })
        .inner
}

/// Question, answer and what follows are as high as the highest of this recording was, so that the stage stays where it is.
fn in_kept_room(app: &App, ui: &mut Ui, lit: Option<Link>) -> Option<Link> {
    let id = Id::unique(("practice", app.playback.recording));
    let known: f32 = ui.data(|data| data.get_temp(id)).unwrap_or_default();
    let shown = ui.scope(|ui| match &app.practice.asked {
        Some(asked) if asked.chosen.is_none() => question(app, ui, asked, lit),
        Some(asked) => {
            answer(app, ui, asked);
            None
        }
        None => {
            at_the_end(app, ui);
            None
        }
    });
    let height = shown.response.rect.height();
    ui.add_space((known - height).max(0.0));
    ui.data_mut(|data| data.insert_temp(id, known.max(height)));
    shown.inner
}

fn said_live(ui: &mut Ui, look: Look<'_>, text: &str) {
    let text = RichText::new(text).font(theme::strong().resolve(ui.style()));
    let label = ui.add(Label::new(text.color(look.theme.ink)).wrap());
    let live = |node: &mut egui::accesskit::Node| node.set_live(Live::Polite);
    ui.ctx().accesskit_node_builder(label.id, live);
}

fn question(app: &App, ui: &mut Ui, asked: &Asked, lit: Option<Link>) -> Option<Link> {
    let look = app.look();
    ui.horizontal(|ui| {
        let (rect, _) = ui.allocate_exact_size(vec2(22.0, 22.0), egui::Sense::hover());
        Icon::Question.draw(ui.painter(), rect, look.theme.signal_text);
        let stroke = look.theme.stroke(1.5, look.theme.signal);
        ui.painter().circle_stroke(rect.center(), 10.0, stroke);
        said_live(ui, look, &look.say("practice-question"));
        ui.label(soft(look, "practice-how"));
        if ui.add(Button::new(accent(look, "practice-show"))).clicked() {
            app.push(Command::ShowMe);
        }
    });
    ui.add_space(4.0);
    let said = asked.choice.said(look.catalog);
    let is_list = said.len() > DIGITS.len() || said.iter().any(|it| it.chars().count() > 48);
    let links = &asked.choice.links;
    let mut pointed = None;
    let options = |ui: &mut Ui| {
        for (nth, option) in said.iter().enumerate() {
            let digit = (nth < DIGITS.len()).then(|| format!("{}\u{2002}", nth + 1));
            let text = digit.unwrap_or_default() + option;
            let is_lit = lit.is_some() && links[nth] == lit;
            let stroke = if is_lit {
                look.theme.stroke(2.0, look.theme.accent)
            } else {
                look.theme.stroke(1.0, look.theme.hairline)
            };
            let chip = Button::new(&text).wrap().stroke(stroke).corner_radius(4.0);
            let button = ui.add(chip.fill(look.theme.background));
            button.widget_info(|| WidgetInfo::selected(Role::RadioButton, true, false, &text));
            if button.clicked() {
                app.push(Command::Choose(nth));
            }
            if button.hovered() || button.has_focus() {
                pointed = links[nth];
            }
        }
    };
    if is_list {
        ui.vertical(options);
    } else {
        ui.horizontal_wrapped(options);
    }
    pointed
}

fn answer(app: &App, ui: &mut Ui, asked: &Asked) {
    let look = app.look();
    let said = asked.choice.said(look.catalog);
    let chosen = asked.chosen.unwrap_or(asked.choice.right);
    let key = if asked.is_shown {
        "practice-shown"
    } else if chosen == asked.choice.right {
        "practice-right"
    } else {
        "practice-wrong"
    };
    let message = Message::new(key)
        .with("right", said[asked.choice.right].clone())
        .with("chosen", said[chosen].clone());
    ui.horizontal_wrapped(|ui| {
        said_live(ui, look, &look.catalog.message(&message));
        told(app, ui);
    });
    // Why is the step's own sentence, over this.
    let go_on = RichText::new(look.say("practice-go-on")).color(look.theme.background);
    if ui.add(Button::new(go_on).fill(look.theme.accent)).clicked() {
        app.push(Command::Play);
    }
}

fn at_the_end(app: &App, ui: &mut Ui) {
    ui.horizontal_wrapped(|ui| {
        let transport = &app.playback.transport;
        let is_at_end = transport.position() == transport.n_steps();
        let key = if is_at_end {
            "practice-done"
        } else {
            "practice-on"
        };
        ui.label(soft(app.look(), key));
        told(app, ui);
        if ui
            .add(Button::new(accent(app.look(), "practice-leave")))
            .clicked()
        {
            app.push(Command::Practise);
        }
    });
}

fn told(app: &App, ui: &mut Ui) {
    let [right, all] = app.practice.told;
    if all > 0 {
        let message = Message::new("practice-told")
            .with("right", Value::Count(right))
            .with("count", Value::Count(all));
        let text = RichText::new(app.look().catalog.message(&message));
        ui.label(text.color(app.look().theme.soft));
    }
}
