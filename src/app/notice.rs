//! Messages above the stage, where they hide nothing: what went right for a moment, what went wrong until it is dismissed.

use egui::{Frame, Panel};

use super::{App, Command, prelude::*};

/// How long good news stays, in seconds.
const PASSING_SECS: f64 = 5.0;
/// More are dropped, the oldest first.
const MAX_NOTICES: usize = 4;

pub struct Notice {
    pub text: String,
    /// Does it tell of a problem, with lines of a file in it?
    pub is_problem: bool,
    /// When it goes away by itself, in seconds.
    pub until: Option<f64>,
}

impl Notice {
    /// What someone new is told stays until they do it.
    pub const fn is_greeting(&self) -> bool {
        !self.is_problem && self.until.is_none()
    }
}

/// Of the window's height they take this part at most.
const MOST: f32 = 0.25;

/// How high they are.
pub fn show(app: &App, ui: &mut Ui) -> f32 {
    // Who watches a presentation is not greeted.
    let is_seen = |it: &&Notice| !(it.is_greeting() && app.is_presenting());
    let notices: Vec<&Notice> = app.notices.iter().filter(is_seen).collect();
    if notices.is_empty() {
        return 0.0;
    }
    let look = app.look();
    let most = MOST * app.shown.size.y;
    let frame = Frame::new().fill(look.theme.panel);
    let shown = Panel::top("notices")
        .resizable(false)
        .frame(frame.inner_margin(Margin::symmetric(16, 6)))
        .show(ui, |ui| {
            ui.horizontal_top(|ui| {
                let width = ui.available_width() - 40.0;
                ScrollArea::vertical()
                    .max_width(width)
                    .max_height(most)
                    .min_scrolled_height(most)
                    .auto_shrink([false, true])
                    .show(ui, |ui| {
                        ui.vertical(|ui| {
                            ui.set_max_width(width);
                            for notice in notices {
                                text(ui, look, notice);
                            }
                        });
                    });
                if icon_button(ui, look, Icon::Close, &look.say("action-close"), true).clicked() {
                    app.push(Command::Dismiss);
                }
            });
        });
    shown.response.rect.height()
}

fn text(ui: &mut Ui, look: Look<'_>, notice: &Notice) {
    let colour = if notice.is_problem {
        look.theme.signal_text
    } else {
        look.theme.ink
    };
    if !notice.text.contains('\n') {
        ui.add_space(6.0);
        ui.add(Label::new(RichText::new(&notice.text).color(colour)).wrap());
        return;
    }
    ui.spacing_mut().item_spacing.y = 0.0;
    for line in notice.text.lines() {
        let words = RichText::new(line).monospace().color(look.theme.ink);
        // Lines of a file keep their columns, as the carets under them must.
        let (label, numbered) = (Label::new(words), line.trim_start());
        let is_of_a_file = numbered
            .trim_start_matches(|c: char| c.is_ascii_digit())
            .trim_start()
            .starts_with("| ");
        if is_of_a_file {
            ui.add(label.truncate());
        } else {
            ui.add(label.wrap());
        }
    }
}

impl App {
    pub(super) fn notify(&mut self, notice: Notice) {
        self.notices.retain(|old| old.text != notice.text);
        self.notices.push(notice);
        let surplus = self.notices.len().saturating_sub(MAX_NOTICES);
        self.notices.drain(..surplus);
    }

    /// For someone new the run of the first page begins at its beginning: what is pressed has to do something. Where a scene is to be
    /// changed its end stays in sight.
    pub(super) fn rewind_for_someone_new(&mut self) {
        let transport = &self.playback.transport;
        let has_goal = self.bookmark.step().is_some_and(|step| step.goal.is_some());
        if !self.settings.is_greeted && transport.position() == transport.n_steps() && !has_goal {
            self.seek(0);
        }
    }

    /// Says to someone new what to press first, and that things can be dragged, until they do.
    pub(super) fn greet(&mut self) {
        if !self.settings.is_greeted {
            self.notify(Notice {
                text: self.catalog().term("greeting"),
                is_problem: false,
                until: None,
            });
        }
    }

    /// Someone has done one of that.
    pub(super) fn greeted(&mut self) {
        if !std::mem::replace(&mut self.settings.is_greeted, true) {
            self.notices.retain(|notice| !notice.is_greeting());
        }
    }

    /// Says it until it is dismissed.
    pub(super) fn complain(&mut self, text: String) {
        self.notify(Notice {
            text,
            is_problem: true,
            until: None,
        });
    }

    /// Says it for a moment.
    pub(super) fn tell(&mut self, message: &Message, now: f64) {
        self.notify(Notice {
            text: self.catalog().message(message),
            is_problem: false,
            until: Some(now + PASSING_SECS),
        });
    }

    /// Takes away what has been seen; seconds until the next one goes.
    pub(super) fn expire_notices(&mut self, now: f64) -> Option<f32> {
        // Nothing moves under a pointer that drags.
        if self.history.is_in_gesture() {
            return None;
        }
        let is_shown = |notice: &Notice| notice.until.is_none_or(|until| until > now);
        self.notices.retain(is_shown);
        let ends = self.notices.iter().filter_map(|notice| notice.until);
        ends.reduce(f64::min).map(|until| (until - now) as f32)
    }
}
