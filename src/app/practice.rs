//! Practice: before every decision the run stops and asks what comes. What might come, what does, and why are the step's own.

use std::{collections::BTreeSet, ops::ControlFlow};

use egui::{Frame, Panel, Role, WidgetInfo, accesskit::Live};

use crate::figure::Choice;

use super::{App, Command, prelude::*};

/// What has a digit of its own; more options than these are a list.
const DIGITS: [Key; 9] = [
    Key::Num1,
    Key::Num2,
    Key::Num3,
    Key::Num4,
    Key::Num5,
    Key::Num6,
    Key::Num7,
    Key::Num8,
    Key::Num9,
];
/// Of the window's height.
const MOST: f32 = 0.4;

#[derive(Default)]
pub struct Practice {
    pub is_on: bool,
    asked: Option<Asked>,
    /// Steps of this recording that have been answered, or shown: they are not asked again.
    done: BTreeSet<usize>,
    recording: u64,
    /// Answered right before anything was shown, and all that were answered.
    pub(super) told: [usize; 2],
}

struct Asked {
    /// The decision's: until it is answered the stage shows the step before.
    step: usize,
    choice: Choice,
    /// What was answered; the right one where the answer was asked for.
    chosen: Option<usize>,
    is_shown: bool,
}

impl Practice {
    /// Is a question open, so that nothing may tell what comes?
    pub fn is_asking(&self) -> bool {
        self.open().is_some()
    }

    /// The question that has not been answered.
    fn open(&self) -> Option<&Asked> {
        self.asked.as_ref().filter(|asked| asked.chosen.is_none())
    }

    const fn is_answered(&self) -> bool {
        matches!(&self.asked, Some(it) if it.chosen.is_some())
    }
}

impl App {
    /// Begins to ask, from here on, or from the first step where the run is at its end; or asks no more.
    pub(super) fn practise(&mut self) {
        let is_on = !self.practice.is_on;
        self.practice = Practice {
            is_on,
            recording: self.playback.recording,
            ..Practice::default()
        };
        if is_on {
            self.playback.transport.pause();
            if self.position() == self.playback.transport.n_steps() {
                self.seek(0);
            }
            self.walk_to(self.playback.transport.n_steps());
        }
    }

    /// What is left to be done of a command: on the way forward the run stops at the next question.
    pub(super) fn practised(&mut self, command: Command) -> Option<Command> {
        if !self.practice.is_on {
            return Some(command);
        }
        let (now, last) = (self.position(), self.playback.transport.n_steps());
        let is_answered = self.practice.is_answered();
        let to = match command {
            Command::Step(by) => now.saturating_add_signed(by),
            Command::Seek(step) => step,
            Command::Phase(by) => self.playback.phase(by),
            Command::Play => last,
            Command::Lesson { forward: true } | Command::CloseOutline if is_answered => last,
            Command::Choose(nth) => {
                self.choose(Some(nth));
                return None;
            }
            Command::ShowMe => {
                self.choose(None);
                return None;
            }
            Command::Cancel if self.practice.asked.is_some() => {
                self.practice.is_on = false;
                self.practice.asked = None;
                return None;
            }
            command => return Some(command),
        };
        if to > now {
            if !self.practice.is_asking() {
                self.walk_to(to.min(last));
            }
            return None;
        }
        self.practice.asked = None;
        Some(command)
    }

    /// To this step, or as far as the first decision on the way that has not been answered.
    fn walk_to(&mut self, to: usize) {
        self.practice.asked = None;
        let now = self.position();
        let done = &self.practice.done;
        let mut asked = None;
        if to > now {
            self.playback
                .main()
                .visit([now + 1, to], &mut |step, shown| {
                    if done.contains(&step) {
                        return ControlFlow::Continue(());
                    }
                    let Some(choice) = shown.options() else {
                        return ControlFlow::Continue(());
                    };
                    asked = Some(Asked {
                        step,
                        choice,
                        chosen: None,
                        is_shown: false,
                    });
                    ControlFlow::Break(())
                });
        }
        self.seek(asked.as_ref().map_or(to, |asked| asked.step - 1));
        self.practice.asked = asked;
    }

    /// Answers the open question, or has its answer shown; then the run shows what comes.
    fn choose(&mut self, nth: Option<usize>) {
        let practice = &mut self.practice;
        let Some(asked) = practice.asked.as_mut().filter(|it| it.chosen.is_none()) else {
            return;
        };
        let right = asked.choice.right;
        let chosen = nth.unwrap_or(right);
        if chosen >= asked.choice.options.len() {
            return;
        }
        (asked.chosen, asked.is_shown) = (Some(chosen), nth.is_none());
        if nth.is_some() {
            practice.told[0] += usize::from(chosen == right);
            practice.told[1] += 1;
        }
        practice.done.insert(asked.step);
        let step = asked.step;
        self.seek(step);
    }

    /// Another recording has other decisions: it is asked where the run stands now.
    pub(super) fn ask_anew(&mut self) {
        let recording = self.playback.recording;
        if self.practice.recording == recording {
            return;
        }
        self.practice.recording = recording;
        self.practice.done.clear();
        let was_asking = self.practice.is_asking();
        self.practice.asked = None;
        if self.practice.is_on && was_asking {
            self.walk_to(self.playback.transport.n_steps());
        }
    }
}

/// While a question is open digits belong to it, and S shows what comes.
pub fn keys(app: &App, ctx: &Context) -> Vec<Command> {
    let Some(asked) = app.practice.open() else {
        return Vec::new();
    };
    if ctx.input(|input| input.modifiers.any()) {
        return Vec::new();
    }
    let n = asked.choice.options.len();
    let digits = DIGITS.iter().take(n).enumerate();
    let keys = digits.map(|(nth, key)| (*key, Command::Choose(nth)));
    let keys = keys.chain([(Key::S, Command::ShowMe)]);
    ctx.input_mut(|input| {
        let pressed = keys.filter(|(key, _)| input.consume_key(Modifiers::NONE, *key));
        pressed.map(|(_, command)| command).collect()
    })
}

/// The question under the stage, with what might come; then what was said, and what comes.
pub fn show(app: &App, ui: &mut Ui) {
    if !app.practice.is_on {
        return;
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
                .show(ui, |ui| in_kept_room(app, ui));
        });
}

/// Question, answer and what follows are as high as the highest of this recording was, so that the stage stays where it is.
fn in_kept_room(app: &App, ui: &mut Ui) {
    let id = Id::unique(("practice", app.playback.recording));
    let known: f32 = ui.data(|data| data.get_temp(id)).unwrap_or_default();
    let shown = ui.scope(|ui| match &app.practice.asked {
        Some(asked) if asked.chosen.is_none() => question(app, ui, asked),
        Some(asked) => answer(app, ui, asked),
        None => at_the_end(app, ui),
    });
    let height = shown.response.rect.height();
    ui.add_space((known - height).max(0.0));
    ui.data_mut(|data| data.insert_temp(id, known.max(height)));
}

fn said_live(ui: &mut Ui, look: Look<'_>, text: &str) {
    let text = RichText::new(text).font(theme::strong().resolve(ui.style()));
    let label = ui.add(Label::new(text.color(look.theme.ink)).wrap());
    let live = |node: &mut egui::accesskit::Node| node.set_live(Live::Polite);
    ui.ctx().accesskit_node_builder(label.id, live);
}

fn question(app: &App, ui: &mut Ui, asked: &Asked) {
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
    let options = |ui: &mut Ui| {
        for (nth, option) in said.iter().enumerate() {
            let digit = (nth < DIGITS.len()).then(|| format!("{}\u{2002}", nth + 1));
            let text = digit.unwrap_or_default() + option;
            let stroke = look.theme.stroke(1.0, look.theme.hairline);
            let chip = Button::new(&text).wrap().stroke(stroke).corner_radius(4.0);
            let button = ui.add(chip.fill(look.theme.background));
            button.widget_info(|| WidgetInfo::selected(Role::RadioButton, true, false, &text));
            if button.clicked() {
                app.push(Command::Choose(nth));
            }
        }
    };
    if is_list {
        ui.vertical(options);
    } else {
        ui.horizontal_wrapped(options);
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
