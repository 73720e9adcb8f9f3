//! What has been seen of the course, and told beforehand: marks that stay.

use egui::{Color32, Painter, Pos2, Shape};
use web_time::{SystemTime, UNIX_EPOCH};

use crate::lesson::Progress;

use super::{App, Dialog, desk::Page, dialog::Target, prelude::*};

const RADIUS: f32 = 2.5;

impl App {
    /// How a step's question was answered; none where it asks none.
    pub(super) fn told_of(&self, lesson: &Lesson, step: &LessonStep) -> Option<Told> {
        let mark = self.settings.progress.mark(&lesson.id, &step.id);
        step.asks.map(|_| mark.unwrap_or_default().told)
    }

    /// Has the goal of a step been reached? None where it has none.
    pub(super) fn reached_of(&self, lesson: &Lesson, step: &LessonStep) -> Option<bool> {
        let mark = self.settings.progress.mark(&lesson.id, &step.id);
        step.goal.as_ref()?;
        Some(mark.unwrap_or_default().reached)
    }

    pub(super) fn told_of_step(&self) -> Told {
        let opened = self.bookmark.lesson().zip(self.bookmark.step());
        let told = opened.and_then(|(lesson, step)| self.told_of(lesson, step));
        told.unwrap_or_default()
    }

    #[cfg(target_arch = "wasm32")]
    pub(super) fn reached_of_step(&self) -> Option<bool> {
        let opened = self.bookmark.lesson().zip(self.bookmark.step());
        opened.and_then(|(lesson, step)| self.reached_of(lesson, step))
    }

    /// `3 / 5`: of a lesson's questions and goals so many have been told and reached; nothing where none has.
    pub(super) fn tally_of(&self, lesson: &Lesson) -> String {
        let tally = self.settings.progress.of_lesson(lesson);
        let done = tally.beforehand + tally.after + tally.reached;
        if done == 0 {
            return String::new();
        }
        format!("{done} / {}", tally.asked + tally.goals)
    }

    pub(super) fn see_step(&mut self) {
        if let Some(Page::Step(lesson, step)) = self.bookmark.page() {
            self.settings.progress.see(&lesson, &step);
        }
    }

    /// Where a file of all marks would be put.
    pub(super) fn handed_in(&self) -> Dialog {
        Dialog::HandIn(Target::new(self.platform.suggest("progress.json")))
    }

    pub(super) fn taken_up(&self) -> Dialog {
        Dialog::TakeUp(Target::new(self.platform.suggest("progress.json")))
    }

    pub(super) fn hand_in(&mut self, target: Target, now: f64) {
        let path = target.path.clone();
        let written = self.settings.progress.written();
        let written = self.platform.write(&path, written.as_bytes());
        if written.is_err() {
            self.shown.dialog = Some(Dialog::HandIn(target));
        }
        self.report(&path, written, ["status-saved", "status-save-failed"], now);
    }

    /// Adds the marks of a file to those that are here.
    pub(super) fn take_up(&mut self, target: Target, now: f64) {
        let read = self.platform.read(&target.path);
        let read = read.and_then(|bytes| Progress::read(&bytes));
        match read {
            Ok(progress) => {
                self.settings.progress.merge(&progress);
                self.tell(&Message::new("progress-taken-up"), now);
            }
            Err(reason) => {
                self.report_unread(&target.path, reason);
                self.shown.dialog = Some(Dialog::TakeUp(target));
            }
        }
    }

    /// Adds marks that a learning platform has kept; what is none of ours is left there.
    #[cfg(target_arch = "wasm32")]
    pub(super) fn take_up_marks(&mut self, bytes: &[u8]) {
        if let Ok(progress) = Progress::read(bytes) {
            self.settings.progress.merge(&progress);
        }
    }

    pub(super) fn begin_afresh(&mut self) {
        let since = SystemTime::now().duration_since(UNIX_EPOCH);
        let now = since.map_or(0, |since| since.as_secs());
        self.settings.progress = Progress {
            begun: now.max(self.settings.progress.begun + 1),
            ..Progress::default()
        };
        self.see_step();
        self.ask_of_step(false);
    }
}

/// What is said of an answer.
pub const fn key(told: Told) -> &'static str {
    match told {
        Told::Open => "told-open",
        Told::Missed => "told-missed",
        Told::AfterTheNumbers => "told-after",
        Told::Beforehand => "told-beforehand",
    }
}

/// A disc for what was told beforehand, a ring with a dot for what was told after the numbers, and a ring for what is open.
pub fn draw(painter: &Painter, theme: &Theme, at: Pos2, told: Told) {
    let rim = theme.stroke(1.0, theme.accent);
    match told {
        Told::Open | Told::Missed => {
            painter.circle_stroke(at, RADIUS, theme.stroke(1.0, theme.faint));
        }
        Told::AfterTheNumbers => {
            painter.circle_stroke(at, RADIUS, rim);
            painter.circle_filled(at, 1.0, theme.accent);
        }
        Told::Beforehand => {
            painter.circle_filled(at, RADIUS, theme.accent);
        }
    }
}

pub const fn goal_key(is_reached: bool) -> &'static str {
    if is_reached {
        "mark-reached"
    } else {
        "mark-goal"
    }
}

/// A square on its corner: filled once the goal has been reached.
pub fn draw_goal(painter: &Painter, theme: &Theme, at: Pos2, is_reached: bool) {
    let corners = [[0.0, -1.0], [1.0, 0.0], [0.0, 1.0], [-1.0, 0.0]];
    let corners = corners.map(|[x, y]| at + (RADIUS + 1.0) * vec2(x, y));
    let (fill, rim) = if is_reached {
        (theme.accent, theme.accent)
    } else {
        (Color32::TRANSPARENT, theme.faint)
    };
    let shape = Shape::convex_polygon(corners.to_vec(), fill, theme.stroke(1.0, rim));
    painter.add(shape);
}
