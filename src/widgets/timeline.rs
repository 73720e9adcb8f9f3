//! The timeline: every event a tick, its shape its kind, which is seen without colour; dragging scrubs.

use std::cmp::Ordering;

use egui::Key;

use crate::figure::Tick;

use super::{fingers::target, headings::focus_ring, prelude::*};

const CROWD_PTS: f32 = 5.0;
const ROOM_PTS: f32 = 24.0;
const BAR_PTS: f32 = 4.0;
const MARGIN: f32 = 14.0;
const UNTOLD: f32 = 2.5;
const QUESTION: f32 = 9.0;

pub struct Timeline<'a> {
    pub n_steps: usize,
    /// Where the cursor stands; 0 is before the first event.
    pub position: usize,
    /// The last step of which it is shown what it is: those after it are all alike.
    pub told: usize,
    pub tick: &'a dyn Fn(usize) -> Tick,
    /// Steps ≥ 1 at which a phase begins: marked where there is no room for every tick.
    pub phases: &'a [usize],
    pub difference: Option<usize>,
    /// Steps of a lesson that stop here: each one's number, and where.
    pub steps: &'a [(usize, usize)],
    /// The step that is asked about: the only one in the signal's colour, while there is one.
    pub asked: Option<usize>,
    /// A step's sentence, asked for only when the pointer rests on it.
    pub tip: &'a dyn Fn(&mut Ui, usize),
    pub name: String,
    pub look: Look<'a>,
}

impl Timeline<'_> {
    pub fn show(self, ui: &mut Ui) -> Option<usize> {
        let size = vec2(ui.available_width().max(48.0), target(ui, 40.0));
        let (rect, response) = ui.allocate_exact_size(size, Sense::click_and_drag());
        response.widget_info(|| WidgetInfo::slider(true, self.position as f64, &self.name));
        let track = Track {
            rect,
            n_steps: self.n_steps,
        };
        let painter = ui.painter_at(rect.expand(2.0));
        self.draw(&painter, &track);
        focus_ring(&painter, self.look, &response, rect, 4.0);
        let pressed = self.keys(ui, &response);
        let response = response.on_hover_cursor(CursorIcon::PointingHand);
        let pointed = response.hover_pos().map(|at| track.step_at(at));
        let asked = if response.dragged() || response.clicked() {
            response.interact_pointer_pos().map(|at| track.step_at(at))
        } else {
            pressed
        };
        if let Some(step) = pointed.filter(|_| self.n_steps > 0) {
            response.on_hover_ui_at_pointer(|ui| {
                ui.set_max_width(360.0);
                (self.tip)(ui, step);
            });
        }
        asked.filter(|&step| step != self.position)
    }

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

    fn draw(&self, painter: &Painter, track: &Track) {
        let theme = self.look.theme;
        let y = track.rect.center().y.round();
        let here = pos2(track.x(self.position), y);
        for &(number, step) in self.steps {
            let at = pos2(track.x(step), y - 16.0);
            let colour = if step == self.position {
                theme.accent
            } else {
                theme.soft
            };
            let font = FontId::proportional(12.0 * theme.text_scale);
            painter.text(at, Align2::CENTER_CENTER, number, font, colour);
        }
        let lines = [
            (self.n_steps, theme.hairline),
            (self.position, theme.accent),
        ];
        for (end, colour) in lines {
            let stroke = Stroke::new(2.0, colour);
            painter.hline(track.x(0)..=track.x(end), y, stroke);
        }
        if let Some(step) = self.difference.filter(|&step| step <= self.told) {
            self.flag(painter, pos2(track.x(step.min(self.n_steps)), y));
        }
        if track.gap() < CROWD_PTS {
            self.bars(painter, track, y);
            let here = Stroke::new(2.0, theme.panel);
            painter.circle(pos2(track.x(self.position), y), 6.0, self.now(), here);
            self.question(painter, track, y);
            return;
        }
        let start = Rect::from_center_size(pos2(track.x(0), y), vec2(2.0, 10.0));
        painter.rect_filled(start, 0.0, theme.accent);
        if self.position == 0 {
            painter.rect_filled(start, 0.0, self.now());
            painter.circle_stroke(here, 8.0, Stroke::new(1.5, self.now()));
        }
        let size = (track.gap() / ROOM_PTS).clamp(0.45, 1.0);
        let each = |step: usize, when: When| {
            let tick = match when {
                When::Untold => Tick::Test,
                When::Past | When::Now | When::Future => (self.tick)(step),
            };
            let at = pos2(track.x(step), y);
            draw_tick(painter, at, tick, when, size, theme);
        };
        for step in 1..=self.n_steps {
            match self.when(step) {
                // Last, so that its ring lies over its neighbours.
                When::Now => {}
                when @ (When::Past | When::Future | When::Untold) => each(step, when),
            }
        }
        if (1..=self.n_steps).contains(&self.position) {
            each(self.position, self.when(self.position));
        }
        self.question(painter, track, y);
    }

    const fn now(&self) -> Color32 {
        match self.asked {
            Some(_) => self.look.theme.accent,
            None => self.look.theme.signal,
        }
    }

    fn question(&self, painter: &Painter, track: &Track, y: f32) {
        let Some(step) = self.asked else { return };
        let (theme, at) = (self.look.theme, pos2(track.x(step), y));
        let rim = Stroke::new(1.5, theme.signal);
        painter.circle(at, QUESTION, theme.panel, rim);
        let font = FontId::proportional(1.5 * QUESTION);
        painter.text(at, Align2::CENTER_CENTER, "?", font, theme.signal_text);
    }

    fn when(&self, step: usize) -> When {
        match step.cmp(&self.position) {
            Ordering::Less => When::Past,
            Ordering::Equal if self.asked.is_some() => When::Past,
            Ordering::Equal => When::Now,
            Ordering::Greater if step > self.told => When::Untold,
            Ordering::Greater => When::Future,
        }
    }

    fn bars(&self, painter: &Painter, track: &Track, y: f32) {
        let theme = self.look.theme;
        let mut last = f32::NEG_INFINITY;
        for &step in self.phases.iter().filter(|&&step| step <= self.told) {
            let x = track.x(step);
            if x - last >= BAR_PTS {
                let is_past = step <= self.position;
                let colour = if is_past { theme.accent } else { theme.faint };
                let bar = Rect::from_center_size(pos2(x, y), vec2(2.0, 9.0));
                painter.rect_filled(bar, 0.5, colour);
                last = x;
            }
        }
    }

    fn flag(&self, painter: &Painter, at: Pos2) {
        let theme = self.look.theme;
        let top = at - vec2(0.0, 18.0);
        let pole = Stroke::new(1.5, theme.signal);
        painter.line_segment([top, at - vec2(0.0, 8.0)], pole);
        let cloth = vec![top, top + vec2(8.0, 3.5), top + vec2(0.0, 7.0)];
        painter.add(Shape::convex_polygon(cloth, theme.signal, Stroke::NONE));
    }
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum When {
    Past,
    Now,
    Future,
    /// It has yet to happen, and what it is must not be given away.
    Untold,
}

/// What happens at a step, beside words that tell of it.
pub fn tick_sign(painter: &Painter, at: Pos2, tick: Tick, theme: &Theme) {
    draw_tick(painter, at, tick, When::Past, 1.0, theme);
}

fn draw_tick(painter: &Painter, at: Pos2, tick: Tick, when: When, size: f32, theme: &Theme) {
    let surface = theme.panel;
    let colour = match (when, tick) {
        (When::Now, _) => theme.signal,
        (When::Past, _) => theme.accent,
        (When::Future | When::Untold, _) => theme.faint,
    };
    if when == When::Untold {
        painter.circle_filled(at, UNTOLD * size, colour);
        return;
    }
    let is_hollow = when == When::Future;
    let fill = if is_hollow { surface } else { colour };
    let stroke = Stroke::new(1.5, colour);
    let r = 4.5 * size;
    match tick {
        Tick::Test => {
            // One shape each: a stroke over a fill of its own colour shows as a rim.
            if is_hollow {
                painter.circle(at, r, fill, stroke);
            } else {
                painter.circle_filled(at, r + 0.75, fill);
            }
        }
        Tick::Cut => {
            let r = r * if is_hollow { 1.4 } else { 1.6 };
            let points = [vec2(0.0, -r), vec2(r, 0.0), vec2(0.0, r), vec2(-r, 0.0)];
            let points = points.map(|v| at + v).to_vec();
            let rim = if is_hollow { stroke } else { Stroke::NONE };
            painter.add(Shape::convex_polygon(points, fill, rim));
        }
        Tick::Accept => {
            let rim = is_hollow.then_some(stroke);
            accept(painter, at, r * 1.15, rim, theme);
        }
        Tick::Reject => {
            // The line of the track must not cross the cross out.
            painter.circle_filled(at, r * 1.5, surface);
            let stroke = Stroke::new(2.0, colour);
            for y in [-r, r] {
                painter.line_segment([at + vec2(-r, -y), at + vec2(r, y)], stroke);
            }
        }
        Tick::Phase => {
            let bar = Rect::from_center_size(at, vec2(4.0 * size, 13.0 * size));
            let rim = if is_hollow { stroke } else { Stroke::NONE };
            painter.rect(bar, 1.0, fill, rim, StrokeKind::Middle);
        }
    }
    if when == When::Now {
        let ring = Stroke::new(1.5, theme.signal);
        painter.circle_stroke(at, (7.5 * size).max(5.0) + 4.0, ring);
    }
}

fn accept(painter: &Painter, at: Pos2, r: f32, rim: Option<Stroke>, theme: &Theme) {
    let surface = theme.panel;
    let square = Rect::from_center_size(at, Vec2::splat(2.0 * r));
    let (area, fill, stroke) = match rim {
        Some(rim) => (square, surface, rim),
        None => (square.expand(1.0), theme.accepted, Stroke::NONE),
    };
    painter.rect(area, 2.5, fill, stroke, StrokeKind::Middle);
    if rim.is_some() {
        return;
    }
    let check = [vec2(-0.5, 0.0), vec2(-0.12, 0.4), vec2(0.55, -0.4)];
    let check = check.map(|v| at + v * r).to_vec();
    painter.add(Shape::line(check, Stroke::new(1.75, surface)));
}

struct Track {
    rect: Rect,
    n_steps: usize,
}

impl Track {
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
            steps: &[],
            phases: &[],
            difference: None,
            asked: None,
            tip: &|_, _| {},
            name: String::new(),
            look: Look::new(theme, catalog),
        };
        let when = [1, 2, 4, 5].map(|step| timeline.when(step));
        assert_eq!(when, [When::Past, When::Now, When::Future, When::Untold]);
    }

    #[test]
    fn places_are_steps_and_back() {
        for n_steps in [1, 9, 100_000] {
            let rect = Rect::from_min_size(pos2(100.0, 0.0), vec2(800.0, 40.0));
            let track = Track { rect, n_steps };
            for step in [0, 1, n_steps / 2, n_steps] {
                let found = track.step_at(pos2(track.x(step), 20.0));
                let off = found.abs_diff(step);
                assert!(off <= n_steps / 10_000, "{step} of {n_steps}: {found}");
            }
        }
    }
}
