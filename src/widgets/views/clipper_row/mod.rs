//! The second view of a pipeline: its clippers in a row, and what flows between them.
//!
//! ```text
//!          x = −4            x = 4             y = −3            y = 3
//!        ┌──────────┐  P   ┏━━━━━━━━━━┓ ✕   I ┌──────────┐      ┌──────────┐      V′
//!   V ──►│ F (−2, 1)│─────►┃ F (−2, 1)┃────●─►│ F (−2, 1)│─────►│ F (−2, 1)│─────► 1
//!        │ S (6, 1) │      ┃ S (−2, 1)┃       │ S (−2, 1)│      │ S (−2, 1)│
//!        └──────────┘      ┗━━━━━━━━━━┛       └──────────┘      └──────────┘
//! ```
//!
//! Where there is little room, a coordinate stands below the other. Of many clippers those about the one at work
//! are shown. A clipper that has closed its ring is grey, and a bar stands where vertices came in.

mod plan;

use std::sync::Arc;

use egui::{
    Align2, Color32, FontId, Galley, Painter, Pos2, Rect, Role, Sense, Shape, Stroke, StrokeKind,
    TextStyle, Ui, Vec2, WidgetInfo, pos2, text::LayoutJob, vec2,
};

use crate::{
    figure::{Clipper, ClipperRow, Fate, Link, Traveller},
    paint::fonts::semibold,
    text::Value,
};

use super::super::Look;

use plan::{PAD, Plan, end_widths, line_height};

pub use plan::clipper_row_height;

/// A coordinate is set this much smaller before it is cut short.
const LEAST_SHRINK: f32 = 0.7;

/// Draws the view in `rect`; the link of the clipper under the pointer.
pub fn clipper_row(
    ui: &Ui,
    look: Look<'_>,
    rect: Rect,
    row: &ClipperRow,
    lit: Option<Link>,
) -> Option<Link> {
    let painter = ui.painter_at(rect);
    painter.rect_filled(rect, 0.0, look.theme.background);
    let hairline = Stroke::new(1.0, look.theme.hairline);
    painter.hline(rect.x_range(), rect.top() + 0.5, hairline);
    // Two columns may stand side by side, each with a row of its own.
    let id = ui.scope_id().with(("clippers", rect.left() as i32));
    let response = ui.interact(rect, id, Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, spoken(look, row)));
    let painting = Painting {
        painter: &painter,
        look,
        row,
        plan: Plan::new(look.theme, rect, row),
    };
    painting.ends();
    painting.arrows();
    painting.travellers();
    let pointer = response.hover_pos();
    painting.boxes(ui, lit, pointer)
}

struct Painting<'a> {
    painter: &'a Painter,
    look: Look<'a>,
    row: &'a ClipperRow,
    plan: Plan,
}

impl Painting<'_> {
    fn small(&self) -> FontId {
        FontId::proportional(11.5 * self.look.theme.text_scale)
    }

    /// V on the left, or what is left out; on the right as many vertices as have come out.
    fn ends(&self) {
        let theme = self.look.theme;
        let [first, last] = [0, self.plan.shown.len()].map(|nth| self.plan.arrow(nth));
        let start = if self.plan.shown.start > 0 {
            "…"
        } else {
            "V"
        };
        let at = first[0] - vec2(4.0, 0.0);
        self.painter
            .text(at, Align2::RIGHT_CENTER, start, self.small(), theme.soft);
        let mut at = last[1] + vec2(5.0, 0.0);
        if self.plan.is_cut {
            let dots = Align2::LEFT_CENTER;
            self.painter.text(at, dots, "…", self.small(), theme.soft);
            at.x += end_widths(theme)[0];
        }
        let number = self.row.n_out.to_string();
        let strong = FontId::new(13.0 * theme.text_scale, semibold());
        let number = self
            .painter
            .text(at, Align2::LEFT_CENTER, number, strong, theme.accent);
        let symbol = self.look.catalog.value(&self.row.output);
        let above = number.left_top() - vec2(0.0, 1.0);
        self.painter
            .text(above, Align2::LEFT_BOTTOM, symbol, self.small(), theme.soft);
    }

    fn arrows(&self) {
        let theme = self.look.theme;
        let n = self.row.clippers.len();
        let is_used = |arrow| self.row.travellers.iter().any(|t| t.arrow == arrow);
        for nth in 0..=self.plan.shown.len() {
            let arrow = self.plan.shown.start + nth;
            let is_closed = match self.row.clippers.get(arrow) {
                Some(clipper) => clipper.is_closed,
                None => self.row.at_work.is_none() && self.row.clippers[n - 1].is_closed,
            };
            let [from, to] = self.plan.arrow(nth);
            let to = to - vec2(3.0, 0.0);
            let colour = match (is_used(arrow), is_closed) {
                (true, _) => theme.ink,
                (false, true) => theme.faint,
                (false, false) => theme.soft,
            };
            let stroke = theme.stroke(1.25, colour);
            let head = theme.stroke_scale.sqrt() * vec2(7.0, 3.5);
            if is_closed && !is_used(arrow) {
                self.painter
                    .hline(from.x + 3.0..=to.x - head.x, from.y, stroke);
                let y = from.y - 1.6 * head.y..=from.y + 1.6 * head.y;
                self.painter
                    .vline(to.x - head.x, y, theme.stroke(2.0, colour));
                continue;
            }
            self.painter
                .hline(from.x + 3.0..=to.x - 0.5 * head.x, from.y, stroke);
            let tip = [to, to + vec2(-head.x, -head.y), to + vec2(-head.x, head.y)];
            let tip = Shape::convex_polygon(tip.to_vec(), colour, Stroke::NONE);
            self.painter.add(tip);
        }
    }

    fn travellers(&self) {
        let n = self.row.travellers.len();
        let mut taken = Rect::NOTHING;
        for (i, traveller) in self.row.travellers.iter().enumerate() {
            let Some(nth) = traveller.arrow.checked_sub(self.plan.shown.start) else {
                continue;
            };
            let [from, to] = self.plan.arrow(nth);
            let along = match (n, i, traveller.fate) {
                (1, _, Fate::Dropped) => 0.3,
                (1, ..) => 0.45,
                (_, 0, _) => 0.62,
                _ => 0.24,
            };
            let at = from + along * (to - from);
            self.marker(at, traveller.fate);
            let name = self.look.catalog.value(&traveller.name);
            let font = FontId::new(12.0 * self.look.theme.text_scale, semibold());
            let label = self
                .painter
                .layout_no_wrap(name, font, self.look.theme.signal);
            let place = self.label_place(traveller, at, label.size(), taken);
            self.painter.galley(place.min, label, Color32::PLACEHOLDER);
            taken = place;
        }
    }

    /// Above the arrow, clear of the boxes; below it where another label stands.
    fn label_place(&self, traveller: &Traveller, at: Pos2, size: Vec2, taken: Rect) -> Rect {
        let off = 6.0 * self.look.theme.stroke_scale.sqrt();
        let mut x = at.x - 0.5 * size.x;
        if traveller.arrow == 0 {
            let [_, head] = self.plan.arrow(0);
            x = x.min(head.x - size.x - 3.0);
        }
        if traveller.arrow == self.row.clippers.len() {
            let [tail, _] = self.plan.arrow(self.plan.shown.len());
            x = x.max(tail.x + 3.0);
        }
        let above = Rect::from_min_size(pos2(x, at.y - off - size.y), size);
        if above.expand2(vec2(1.5, 0.0)).intersects(taken) {
            above.translate(vec2(0.0, size.y + 2.0 * off))
        } else {
            above
        }
    }

    /// A dot goes on, a ring is yet to be worked out, a cross stays behind.
    fn marker(&self, at: Pos2, fate: Fate) {
        let theme = self.look.theme;
        let r = 4.5 * theme.stroke_scale.sqrt();
        match fate {
            Fate::GoesOn => {
                self.painter.circle_filled(at, r, theme.signal);
            }
            Fate::Due => {
                let stroke = theme.stroke(1.75, theme.signal);
                self.painter.circle(at, r - 0.5, theme.background, stroke);
            }
            Fate::Dropped => {
                // The arrow must not cross the cross out.
                self.painter.circle_filled(at, 1.4 * r, theme.background);
                let stroke = theme.stroke(2.0, theme.signal);
                for y in [-r, r] {
                    let ends = [at + 0.9 * vec2(-r, -y), at + 0.9 * vec2(r, y)];
                    self.painter.line_segment(ends, stroke);
                }
            }
        }
    }

    fn boxes(&self, ui: &Ui, lit: Option<Link>, pointer: Option<Pos2>) -> Option<Link> {
        let theme = self.look.theme;
        let scale = self.shrink(ui);
        let mut pointed = None;
        for (nth, idx) in self.plan.shown.clone().enumerate() {
            let clipper = &self.row.clippers[idx];
            let place = self.plan.place(nth);
            let is_near = pointer.is_some_and(|pointer| place.contains(pointer));
            if is_near {
                pointed = clipper.link;
            }
            if is_near || (lit.is_some() && lit == clipper.link) {
                let ring = Stroke::new(1.5, theme.accent);
                let around = place.expand(4.0);
                self.painter
                    .rect_stroke(around, 6.0, ring, StrokeKind::Middle);
            }
            let is_at_work = self.row.at_work == Some(idx);
            let (stroke, colour) = match (is_at_work, clipper.is_closed) {
                (true, _) => (theme.stroke(2.5, theme.signal), theme.ink),
                (false, true) => (theme.stroke(1.0, theme.faint), theme.soft),
                (false, false) => (theme.stroke(1.0, theme.soft), theme.ink),
            };
            self.painter
                .rect(place, 4.0, theme.background, stroke, StrokeKind::Middle);
            let name = self.look.catalog.value(&clipper.name);
            let room = place.width() + 0.6 * self.plan.arrow;
            let name = self.fitted(name, self.small(), colour, room);
            let size = name.size();
            let above = place.center_top() - vec2(0.5 * size.x, size.y + 3.0);
            self.painter.galley(above.round(), name, colour);
            self.memory(ui, clipper, place, colour, scale);
        }
        pointed
    }

    fn mono(ui: &Ui) -> FontId {
        let font = TextStyle::Monospace.resolve(ui.style());
        FontId::new(0.94 * font.size, font.family)
    }

    /// A vertex in one line, or in two.
    fn lines(&self, at: Option<[f64; 2]>) -> Vec<String> {
        match at {
            None => vec!["–".to_owned()],
            Some(at) if self.plan.is_stacked => at.map(|x| self.look.catalog.number(x)).to_vec(),
            Some(at) => vec![self.look.catalog.point(at)],
        }
    }

    /// The width that is left in a box after the letter F.
    fn room(&self) -> f32 {
        self.plan.first.width() - 2.0 * PAD.x - self.letter_width()
    }

    fn letter_width(&self) -> f32 {
        13.0 * self.look.theme.text_scale
    }

    /// All coordinates are set in one size: how much smaller than usual?
    fn shrink(&self, ui: &Ui) -> f32 {
        let clippers = &self.row.clippers[self.plan.shown.clone()];
        let held = clippers.iter().flat_map(|c| [c.first, c.previous]);
        let widths = held.flat_map(|at| self.lines(at)).map(|line| {
            let galley = self
                .painter
                .layout_no_wrap(line, Self::mono(ui), Color32::PLACEHOLDER);
            galley.size().x
        });
        let widest = widths.fold(1.0, f32::max);
        (self.room() / widest).clamp(LEAST_SHRINK, 1.0)
    }

    /// F and S.
    fn memory(&self, ui: &Ui, clipper: &Clipper, place: Rect, colour: Color32, scale: f32) {
        let theme = self.look.theme;
        let mono = Self::mono(ui);
        let font = FontId::new(scale * mono.size, mono.family);
        let inner = place.shrink2(PAD);
        let line_height = line_height(theme);
        let held = [
            ("F", clipper.first, inner.top()),
            (
                "S",
                clipper.previous,
                inner.bottom() - self.n_lines() * line_height,
            ),
        ];
        for (letter, at, top) in held {
            let colour = if at.is_some() { colour } else { theme.faint };
            let middle = |nth: usize| (top + (nth as f32 + 0.5) * line_height).round();
            let start = pos2(inner.left(), middle(0));
            let is = Align2::LEFT_CENTER;
            self.painter
                .text(start, is, letter, self.small(), theme.soft);
            for (nth, line) in self.lines(at).into_iter().enumerate() {
                let galley = self.fitted(line, font.clone(), colour, self.room());
                let x = inner.left() + self.letter_width();
                let at = pos2(x, middle(nth) - 0.5 * galley.size().y);
                self.painter.galley(at, galley, colour);
            }
        }
    }

    const fn n_lines(&self) -> f32 {
        if self.plan.is_stacked { 2.0 } else { 1.0 }
    }

    /// A line of text, cut short where it is too long.
    fn fitted(&self, text: String, font: FontId, colour: Color32, width: f32) -> Arc<Galley> {
        let mut job = LayoutJob::simple_singleline(text, font, colour);
        // Half a point for what rounding does to a text that just fits.
        job.wrap.max_width = width + 0.5;
        job.wrap.max_rows = 1;
        job.wrap.break_anywhere = true;
        self.painter.layout_job(job)
    }
}

/// `x = −4: F = (−2, −1), S = (6, 1); …; P → x = 4; V′: 1`.
fn spoken(look: Look<'_>, row: &ClipperRow) -> String {
    let say = |value: &Value| look.catalog.value(value);
    let held = |symbol: &str, at: Option<[f64; 2]>| match at {
        Some(at) => format!("{symbol} = {}", look.catalog.point(at)),
        None => format!("{symbol} –"),
    };
    let mut parts: Vec<String> = Vec::new();
    for (idx, clipper) in row.clippers.iter().enumerate() {
        let [first, previous] = [held("F", clipper.first), held("S", clipper.previous)];
        let arrow = if row.at_work == Some(idx) { "→ " } else { "" };
        let mut part = format!("{arrow}{}: {first}, {previous}", say(&clipper.name));
        if clipper.is_closed {
            part = format!("{part}, {}", look.say("pipe-closed"));
        }
        parts.push(part);
    }
    let output = say(&row.output);
    for traveller in &row.travellers {
        let next = row.clippers.get(traveller.arrow);
        let next = next.map_or_else(|| output.clone(), |clipper| say(&clipper.name));
        let sign = match traveller.fate {
            Fate::GoesOn | Fate::Due => "→",
            Fate::Dropped => "×",
        };
        parts.push(format!("{} {sign} {next}", say(&traveller.name)));
    }
    parts.push(format!("{output}: {}", row.n_out));
    parts.join("; ")
}
