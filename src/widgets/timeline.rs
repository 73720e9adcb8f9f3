//! The timeline: every event a tick, its shape its kind; dragging scrubs.

use std::cmp::Ordering;

use egui::{
    CursorIcon, Key, Painter, Pos2, Rect, Response, Sense, Shape, Stroke, StrokeKind, Ui,
    WidgetInfo, pos2, vec2,
};

use crate::figure::Tick;

use super::{
    look::Look,
    tick::{self, When},
};

/// Closer than this, in points, ticks are drawn as a plain bar.
const CROWD_PTS: f32 = 5.0;
/// From this distance on, in points, ticks have their full size.
const ROOM_PTS: f32 = 24.0;
/// Closer than this, in points, bars of phases are left out.
const BAR_PTS: f32 = 4.0;
/// Room at both ends for the ring of the current tick.
const MARGIN: f32 = 14.0;

/// A recording's steps in a row.
pub struct Timeline<'a> {
    /// Events in the recording.
    pub n_steps: usize,
    /// Where the cursor stands; 0 is before the first event.
    pub position: usize,
    /// The last step of which it is shown what it is: those after it are all alike.
    pub told: usize,
    /// The kind of the event that leads to a step ≥ 1.
    pub tick: &'a dyn Fn(usize) -> Tick,
    /// Steps ≥ 1 at which a phase begins: marked where there is no room for every tick.
    pub phases: &'a [usize],
    /// The first step at which two runs differ.
    pub difference: Option<usize>,
    /// A step's sentence, asked for only when the pointer rests on it.
    pub tip: &'a dyn Fn(usize) -> String,
    /// Its name to a screen reader.
    pub name: String,
    /// How it looks.
    pub look: Look<'a>,
}

impl Timeline<'_> {
    /// Draws the timeline into the room that is left; the step that was asked for, if any.
    pub fn show(self, ui: &mut Ui) -> Option<usize> {
        let size = vec2(ui.available_width().max(48.0), 40.0);
        let (rect, response) = ui.allocate_exact_size(size, Sense::click_and_drag());
        response.widget_info(|| WidgetInfo::slider(true, self.position as f64, &self.name));
        let track = Track::new(rect, self.n_steps);
        let painter = ui.painter_at(rect.expand(2.0));
        self.draw(&painter, &track);
        if response.has_focus() {
            let ring = self.look.theme.stroke(2.0, self.look.theme.accent);
            painter.rect_stroke(rect, 4.0, ring, StrokeKind::Inside);
        }
        let pressed = self.keys(ui, &response);
        let response = response.on_hover_cursor(CursorIcon::PointingHand);
        let pointed = response.hover_pos().map(|at| track.step_at(at));
        let asked = if response.dragged() || response.clicked() {
            response.interact_pointer_pos().map(|at| track.step_at(at))
        } else {
            pressed
        };
        if let Some(step) = pointed.filter(|_| self.n_steps > 0) {
            self.tooltip(&response, step);
        }
        asked.filter(|&step| step != self.position)
    }

    /// Arrows while the timeline has the focus.
    fn keys(&self, ui: &Ui, response: &Response) -> Option<usize> {
        if !response.has_focus() {
            return None;
        }
        let by = ui.input_mut(|i| {
            let mut count = |key| i.count_and_consume_key(egui::Modifiers::NONE, key) as isize;
            count(Key::ArrowRight) - count(Key::ArrowLeft)
        });
        (by != 0).then(|| self.position.saturating_add_signed(by).min(self.n_steps))
    }

    fn tooltip(&self, response: &Response, step: usize) {
        let tip = self.tip;
        response.clone().on_hover_ui_at_pointer(|ui| {
            ui.set_max_width(360.0);
            ui.label(tip(step));
        });
    }

    fn draw(&self, painter: &Painter, track: &Track) {
        let theme = self.look.theme;
        let y = track.rect.center().y.round();
        let here = pos2(track.x(self.position), y);
        let line = |from: f32, to: f32, stroke: Stroke| painter.hline(from..=to, y, stroke);
        line(
            track.x(0),
            track.x(self.n_steps),
            Stroke::new(2.0, theme.hairline),
        );
        line(track.x(0), here.x, Stroke::new(2.0, theme.accent));
        if let Some(step) = self.difference.filter(|&step| step <= self.told) {
            self.flag(painter, pos2(track.x(step.min(self.n_steps)), y));
        }
        if track.gap() < CROWD_PTS {
            self.bars(painter, track, y);
            painter.circle(here, 6.0, theme.signal, Stroke::new(2.0, theme.panel));
            return;
        }
        let start = Rect::from_center_size(pos2(track.x(0), y), vec2(2.0, 10.0));
        painter.rect_filled(start, 0.0, theme.accent);
        if self.position == 0 {
            painter.rect_filled(start, 0.0, theme.signal);
            painter.circle_stroke(here, 8.0, Stroke::new(1.5, theme.signal));
        }
        let size = (track.gap() / ROOM_PTS).clamp(0.45, 1.0);
        let each = |step: usize, when: When| {
            let at = Pos2::new(track.x(step), y);
            tick::draw(
                painter,
                at,
                (self.tick)(step),
                when,
                size,
                theme,
                theme.panel,
            );
        };
        for step in 1..=self.n_steps {
            match self.when(step) {
                // Last, so that its ring lies over its neighbours.
                When::Now => {}
                when @ (When::Past | When::Future | When::Untold) => each(step, when),
            }
        }
        if (1..=self.n_steps).contains(&self.position) {
            each(self.position, When::Now);
        }
    }

    fn when(&self, step: usize) -> When {
        match step.cmp(&self.position) {
            Ordering::Less => When::Past,
            Ordering::Equal => When::Now,
            Ordering::Greater if step > self.told => When::Untold,
            Ordering::Greater => When::Future,
        }
    }

    /// A short bar for each phase of a run that has too many steps to show them all.
    fn bars(&self, painter: &Painter, track: &Track, y: f32) {
        let theme = self.look.theme;
        let mut last = f32::NEG_INFINITY;
        for &step in self.phases.iter().filter(|&&step| step <= self.told) {
            let x = track.x(step);
            if x - last >= BAR_PTS {
                let colour = if step <= self.position {
                    theme.accent
                } else {
                    theme.faint
                };
                let bar = Rect::from_center_size(pos2(x, y), vec2(2.0, 9.0));
                painter.rect_filled(bar, 0.5, colour);
                last = x;
            }
        }
    }

    /// A pennant above the track: a shape that no tick has.
    fn flag(&self, painter: &Painter, at: Pos2) {
        let theme = self.look.theme;
        let top = at - vec2(0.0, 18.0);
        let pole = Stroke::new(1.5, theme.signal);
        painter.line_segment([top, at - vec2(0.0, 8.0)], pole);
        let cloth = vec![top, top + vec2(8.0, 3.5), top + vec2(0.0, 7.0)];
        painter.add(Shape::convex_polygon(cloth, theme.signal, Stroke::NONE));
    }
}

/// Steps against places.
struct Track {
    rect: Rect,
    n_steps: usize,
}

impl Track {
    fn new(rect: Rect, n_steps: usize) -> Self {
        Self { rect, n_steps }
    }

    fn gap(&self) -> f32 {
        (self.rect.width() - 2.0 * MARGIN).max(1.0) / self.n_steps.max(1) as f32
    }

    fn x(&self, step: usize) -> f32 {
        let width = (self.rect.width() - 2.0 * MARGIN).max(1.0);
        let part = step as f32 / self.n_steps.max(1) as f32;
        self.rect.left() + MARGIN + part * width
    }

    fn step_at(&self, at: Pos2) -> usize {
        let along = (at.x - self.rect.left() - MARGIN) / self.gap();
        (along.round().max(0.0) as usize).min(self.n_steps)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_comes_after_what_was_told_is_all_alike() {
        let catalog = crate::text::Catalog::of(crate::text::Lang::En);
        let theme = crate::paint::Theme::of(crate::paint::ThemeKind::Light);
        let timeline = Timeline {
            n_steps: 6,
            position: 2,
            told: 4,
            tick: &|_| Tick::Cut,
            phases: &[],
            difference: None,
            tip: &|_| String::new(),
            name: String::new(),
            look: Look { theme, catalog },
        };
        let when = [1, 2, 4, 5].map(|step| timeline.when(step));
        assert_eq!(when, [When::Past, When::Now, When::Future, When::Untold]);
    }

    #[test]
    fn places_are_steps_and_back() {
        for n_steps in [1, 9, 100_000] {
            let rect = Rect::from_min_size(pos2(100.0, 0.0), vec2(800.0, 40.0));
            let track = Track::new(rect, n_steps);
            for step in [0, 1, n_steps / 2, n_steps] {
                let found = track.step_at(pos2(track.x(step), 20.0));
                assert!(
                    found.abs_diff(step) <= n_steps / 10_000,
                    "{step} of {n_steps}: {found}"
                );
            }
        }
    }
}
