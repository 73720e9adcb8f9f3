//! What is asked, under the stage: the question with what might come; then what was said, and what comes. As high as the highest of
//! what is asked here from the start on, so that the stage stays where it is; one row, once the
//! scene is the reader’s or where there is little room.

mod cards;

use std::sync::Arc;

use egui::{Frame, Galley, Panel, Role, StrokeKind, TextStyle, Vec2, WidgetInfo};

use crate::{
    figure::{Body, Chip, ChipFate, Choice, View},
    widgets::{target, view},
};

use super::{
    App, Command, answers, marks,
    practice::{Asked, DIGITS},
    prelude::*,
    said::{said_live, words},
};

use cards::{Table, cards, pixels};

/// Of the height that the stage would have.
const MOST: f32 = 0.45;
/// The last option's rim is seen whole.
const BELOW: f32 = 4.0;
const MARGIN: Margin = Margin::symmetric(24, 10);
/// What is longer stands in a line of its own, among so few.
const LONG: usize = 48;
const FEW: usize = 4;
const AROUND: Vec2 = vec2(8.0, 4.0);
const GAP: f32 = 6.0;

/// What the pointer is on, of what might come.
pub fn show(app: &App, ui: &mut Ui, lit: Option<Link>) -> Option<Link> {
    let practice = &app.practice;
    let is_idle = !practice.is_on && practice.asked.is_none();
    if is_idle && (practice.kept.is_empty() || app.is_presenting()) {
        return None;
    }
    let frame = Frame::new().fill(app.look().theme.panel);
    let around = MARGIN.sum();
    // What the panels before this one have left.
    let room = ui.available_size_before_wrap();
    let most = MOST * room.y;
    let width = room.x - around.x;
    // A question that is put aside leaves its room to the stage.
    let height = if is_idle {
        row_height(ui) + BELOW
    } else {
        kept_height(app, ui, width).min(most)
    };
    Panel::bottom("practice")
        .frame(frame.inner_margin(MARGIN))
        .exact_size(height + around.y)
        .show(ui, |ui| {
            ScrollArea::vertical()
                .id_salt("practice")
                .auto_shrink(false)
                .min_scrolled_height(0.0)
                .show(ui, |ui| match &practice.asked {
                    Some(asked) if asked.chosen.is_none() => question(app, ui, asked, lit),
                    Some(asked) => {
                        answer(app, ui, asked);
                        None
                    }
                    None => {
                        at_the_end(app, ui);
                        None
                    }
                })
                .inner
        })
        .inner
}

/// Of whatever is asked here, and was: with any answer.
fn kept_height(app: &App, ui: &Ui, width: f32) -> f32 {
    let practice = &app.practice;
    let asked = practice.asked.iter().map(|asked| &asked.choice);
    let height = |choice: &Choice| {
        let said = choice.said(app.look().catalog);
        let options = Options::of(app, ui, choice, width).height;
        let mut longest: Vec<&String> = said.iter().collect();
        longest.sort_by_key(|text| std::cmp::Reverse(text.chars().count()));
        let both = [0, 1].map(|nth| longest.get(nth).map_or("", |text| text));
        let answer = Answer::of(app, ui, ("practice-wrong", both), width).height();
        (row_height(ui) + GAP + options + BELOW).max(answer)
    };
    let heights = practice.kept.iter().chain(asked).map(height);
    heights.fold(row_height(ui), f32::max)
}

fn row_height(ui: &Ui) -> f32 {
    ui.spacing().interact_size.y + 2.0
}

/// Of the options each box, from the upper left corner on, and its words.
struct Options {
    boxes: Vec<(Rect, Arc<Galley>)>,
    height: f32,
}

impl Options {
    /// Beside each other, as many as have room; each by itself where few are long, or where they are too many for digits.
    fn of(app: &App, ui: &Ui, choice: &Choice, width: f32) -> Self {
        let theme = app.look().theme;
        let said = &choice.said(app.look().catalog);
        let table = Table {
            width,
            gap: GAP,
            around: AROUND,
            chip: chip(None, 0).size(theme),
        };
        let is_tight = theme.has_large_text() || app.is_low() || app.is_narrow();
        if let Some(boxes) = cards(ui, app.look(), choice, &table).filter(|_| !is_tight) {
            let height = boxes[0].0.height() + GAP;
            return Self { boxes, height };
        }
        let is_long = |text: &String| text.chars().count() > LONG;
        let are_few = said.len() <= FEW;
        let is_list = said.len() > DIGITS.len() || are_few && said.iter().any(is_long);
        let chip = chip(None, 0).size(theme);
        let around = 2.0 * AROUND + vec2(chip.x + GAP, 0.0);
        let (mut boxes, mut at, mut height) = (Vec::new(), Pos2::ZERO, 0.0_f32);
        for text in said {
            let most = width - around.x;
            let text = words(ui, app.look(), (text, TextStyle::Body), most);
            let size = text.size().max(vec2(0.0, chip.y)) + around;
            let size = size.max(Vec2::splat(target(ui, 0.0)));
            if at.x > 0.0 && (is_list || at.x + size.x > width) {
                at = pos2(0.0, height + GAP);
            }
            boxes.push((Rect::from_min_size(at, size), text));
            height = height.max(at.y + size.y);
            at.x += size.x + GAP;
        }
        Self { boxes, height }
    }
}

/// One line, with what is at its right end.
fn line(ui: &mut Ui, left: impl FnOnce(&mut Ui), right: impl FnOnce(&mut Ui)) {
    let size = vec2(ui.available_width(), row_height(ui));
    ui.allocate_ui_with_layout(size, Layout::right_to_left(Align::Center), |ui| {
        right(ui);
        ui.with_layout(Layout::left_to_right(Align::Center), left);
    });
}

/// That something is asked, and how to answer.
fn sign(ui: &mut Ui, look: Look<'_>) {
    let (rect, _) = ui.allocate_exact_size(vec2(22.0, 22.0), egui::Sense::hover());
    Icon::Question.draw(ui.painter(), rect, look.theme.asks());
    let stroke = look.theme.stroke(1.5, look.theme.asks());
    ui.painter().circle_stroke(rect.center(), 10.0, stroke);
    let asked = look.say("practice-question");
    let asked = words(ui, look, (&asked, theme::strong()), f32::INFINITY);
    said_live(ui, asked);
    // Where it is cut, a finger chooses.
    let how = look.say("practice-how");
    let whole = words(ui, look, (&how, TextStyle::Body), f32::INFINITY);
    if whole.size().x <= ui.available_width() {
        ui.label(soft(look, "practice-how"));
    }
}

fn question(app: &App, ui: &mut Ui, asked: &Asked, lit: Option<Link>) -> Option<Link> {
    let look = app.look();
    ui.spacing_mut().item_spacing.y = GAP;
    line(
        ui,
        |ui| sign(ui, look),
        |ui| {
            if ui.add(Button::new(accent(look, "practice-show"))).clicked() {
                app.push(Command::ShowMe);
            }
            take_back(app, ui);
        },
    );
    let said = asked.choice.said(look.catalog);
    let width = ui.available_width();
    let options = Options::of(app, ui, &asked.choice, width);
    let (room, _) = ui.allocate_exact_size(vec2(width, options.height), egui::Sense::hover());
    let mut pointed = None;
    for (nth, (rect, text)) in options.boxes.into_iter().enumerate() {
        let rect = rect.translate(room.min.to_vec2());
        let link = asked.choice.links.get(nth).copied().flatten();
        let response = ui.interact(
            rect,
            ui.scope_id().with(("option", nth)),
            egui::Sense::click(),
        );
        let name = format!("{} {}", nth + 1, said[nth]);
        response.widget_info(|| WidgetInfo::selected(Role::RadioButton, true, false, &name));
        let is_held = response.hovered() || response.has_focus();
        let is_lit = is_held || (lit.is_some() && link == lit);
        option(
            app,
            ui,
            (rect, text),
            (nth < DIGITS.len()).then_some(nth + 1),
            is_lit,
        );
        if let Some((raster, size)) =
            pixels(&asked.choice, nth).filter(|(_, size)| rect.height() > size.y)
        {
            let at = rect.right_top() + vec2(-AROUND.x - size.x, AROUND.y);
            let shown = View::new("glimpse", Body::Raster(raster.clone()));
            view(
                ui,
                app.look_on_stage(),
                Rect::from_min_size(at, size),
                &shown,
                None,
            );
        }
        if response.clicked() {
            app.push(Command::Choose(nth));
        }
        if is_held {
            pointed = link;
        }
    }
    pointed
}

fn take_back(app: &App, ui: &mut Ui) {
    let is_there = app.practice.has_answered();
    let button = Button::new(accent(app.look(), "practice-take-back"));
    if is_there && ui.add(button).clicked() {
        app.push(Command::TakeBack);
    }
}

const fn chip(link: Option<Link>, digit: usize) -> Chip {
    let fate = ChipFate::Open;
    Chip { link, digit, fate }
}

fn option(
    app: &App,
    ui: &Ui,
    (rect, text): (Rect, Arc<Galley>),
    digit: Option<usize>,
    is_lit: bool,
) {
    let theme = app.look().theme;
    let stroke = if is_lit {
        theme.stroke(2.0, theme.accent)
    } else {
        theme.stroke(1.0, theme.hairline)
    };
    let painter = ui.painter();
    painter.rect(rect, 4.0, theme.background, stroke, StrokeKind::Inside);
    let size = chip(None, 0).size(theme);
    let at = pos2(rect.left() + AROUND.x + 0.5 * size.x, rect.center().y);
    if let Some(digit) = digit {
        chip(None, digit).draw(painter, theme, at, is_lit);
    }
    let at = pos2(
        at.x + 0.5 * size.x + GAP,
        rect.center().y - 0.5 * text.size().y,
    );
    painter.galley(at, text, theme.ink);
}

/// What was said, beside the buttons that go on and back; under it how many have been told.
struct Answer {
    said: Arc<Galley>,
    width: f32,
    told: f32,
}

impl Answer {
    fn of(
        app: &App,
        ui: &Ui,
        (key, [right, chosen]): (&'static str, [&str; 2]),
        width: f32,
    ) -> Self {
        let look = app.look();
        let message = Message::new(key)
            .with("right", right.to_owned())
            .with("chosen", chosen.to_owned());
        let said = look.catalog.message(&message);
        let buttons = ["practice-go-on", "practice-take-back"].map(|key| look.say(key));
        let size = |text: &str, style| words(ui, look, (text, style), f32::INFINITY).size();
        let buttons = buttons.map(|it| size(&it, TextStyle::Button).x);
        let around = buttons.len() as f32 * (2.0 * AROUND.x + 2.0 * GAP) + 2.0 * GAP;
        let width = (width - buttons.iter().sum::<f32>() - around).max(0.0);
        Self {
            said: words(ui, look, (&said, theme::strong()), width),
            told: size("0", TextStyle::Body).y,
            width,
        }
    }

    fn height(&self) -> f32 {
        self.said.size().y + self.told + GAP
    }
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
    let both = [asked.choice.right, chosen].map(|nth| &*said[nth]);
    let answer = Answer::of(app, ui, (key, both), ui.available_width());
    ui.with_layout(Layout::right_to_left(Align::Min), |ui| {
        // Why is the step's own sentence, over this.
        let go_on = RichText::new(look.say("practice-go-on")).color(look.theme.background);
        if ui.add(Button::new(go_on).fill(look.theme.accent)).clicked() {
            app.push(Command::Play);
        }
        take_back(app, ui);
        ui.with_layout(Layout::top_down(Align::Min), |ui| {
            ui.set_max_width(answer.width);
            ui.spacing_mut().item_spacing.y = GAP;
            said_live(ui, answer.said.clone());
            told(app, ui);
        });
    });
}

fn at_the_end(app: &App, ui: &mut Ui) {
    let look = app.look();
    if !app.practice.is_on {
        let stands = look.say(marks::key(app.told_of_step()));
        let stands = Message::new("practice-stands").with("told", stands);
        let stands = look.catalog.message(&stands);
        let again = |ui: &mut Ui| {
            let again = Button::new(accent(look, "lesson-ask-again"));
            if ui.add(again).clicked() {
                app.push(Command::AskAgain);
            }
        };
        let words = |ui: &mut Ui| {
            ui.add(Label::new(RichText::new(&stands).color(look.theme.soft)).truncate());
            told(app, ui);
        };
        line(ui, words, again);
        return;
    }
    let transport = &app.playback.transport;
    let is_at_end = transport.position() == transport.n_steps();
    let key = if is_at_end {
        "practice-done"
    } else {
        "practice-on"
    };
    let words = |ui: &mut Ui| {
        ui.label(soft(look, key));
        told(app, ui);
    };
    let is_marked_now = is_at_end && app.settings.marks_at_end;
    line(ui, words, |ui| {
        let leave = Button::new(accent(look, "practice-leave"));
        if ui.add(leave).clicked() {
            app.push(Command::Practise);
        }
    });
    if is_marked_now {
        answers::table(app, ui);
    }
}

fn told(app: &App, ui: &mut Ui) {
    let [right, all] = app.practice.told;
    if all > 0 {
        let message = Message::new("practice-told")
            .with("right", Value::Count(right))
            .with("count", Value::Count(all));
        let text = app.look().catalog.message(&message);
        let whole = words(ui, app.look(), (&text, TextStyle::Body), f32::INFINITY);
        // Beside a sentence and a button there may be no room.
        if whole.size().x <= ui.available_width() {
            ui.label(RichText::new(text).color(app.look().theme.soft));
        }
    }
}
