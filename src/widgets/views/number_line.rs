//! What is left of a parameter's interval, on the segment's own axis: the marks at 0 and 1 are its ends.
//!
//! ```text
//!   P₁      left                    right        P₂
//!   ○- - - - -▶━━━━━━━━━━━━━━━━━━━━━◀- - - - - - ○   u
//!   0     u_min = 3/8           u_max = 3/4      1
//! ```
//!
//! A bound is an arrowhead: its flat side stands at the bound, and it points to where the bound allows. In an empty
//! interval both point away from each other, and what lies between them is crossed over.

mod names;

use egui::Vec2b;
use egui_plot::{PlotBounds, PlotTransform};

use crate::figure::{LineTick, NumberLine, Side};

use super::{prelude::*, slate::cross};

const BELOW: f32 = 48.0;
const ABOVE: f32 = 52.0;
const ENDS: [f32; 2] = [26.0, 34.0];
/// Crossings farther out are drawn at the end of the axis, as arrows that point to them.
const BEYOND: f64 = 0.12;
const RING: f32 = 5.0;
const HEAD: f32 = 12.0;
const ARROW: f32 = 8.0;
const CROSS: f32 = 6.0;

impl OnSlate for NumberLine {
    fn slate<'a>(&self, natural: Slate<'a>, room: Vec2) -> Slate<'a> {
        natural.fitted_in(room, |slate| vec2(0.75 * room.x, slate.pts(ABOVE + BELOW)))
    }

    fn draw(&self, slate: &mut Slate<'_>, rect: Rect, links: &mut Links) {
        let axis = Axis::new(slate, rect, self);
        axis.draw(slate);
        axis.names(slate, links);
    }

    fn spoken(&self, look: Look<'_>) -> String {
        let said = |value: &Formula| look.catalog.formula(value);
        let [low, high] = [0, 1].map(|i| said(&self.values[i]));
        let symbol = self.symbol;
        let bounds = format!("{symbol}_min = {low}, {symbol}_max = {high}");
        let empty = self.empty.then(|| {
            // Where the line runs beside the window the bounds are still in order.
            if self.interval[0] > self.interval[1] {
                format!("{symbol}_min > {symbol}_max")
            } else {
                look.catalog.term("view-empty")
            }
        });
        let ticks = self.ticks.iter().map(|tick| {
            let sign = match tick.side {
                Side::Entering => "▶",
                Side::Leaving => "◀",
            };
            let (arrow, name) = (now(tick.current), look.catalog.value(&tick.name));
            format!("{arrow}{name} {sign} {symbol} = {}", said(&tick.value))
        });
        let kept = self.kept.as_ref().map(|(_, kept)| look.catalog.value(kept));
        let said = std::iter::once(bounds).chain(empty).chain(ticks);
        joined(said.chain(kept), "; ")
    }
}

struct Axis<'l> {
    line: &'l NumberLine,
    transform: PlotTransform,
    shown: [f64; 2],
    room: Rect,
    y: f32,
}

impl<'l> Axis<'l> {
    fn new(slate: &Slate<'_>, rect: Rect, line: &'l NumberLine) -> Self {
        let [left, right] = ENDS.map(|end| slate.pts(end));
        let y = (rect.top() + slate.pts(ABOVE)).round();
        let left = rect.left() + left;
        let right = (rect.right() - right).max(left + 1.0);
        let frame = Rect::from_x_y_ranges(left..=right, rect.y_range());
        let mut shown = line.shown;
        if shown != [0.0, 1.0] {
            shown = [shown[0] - BEYOND, shown[1] + BEYOND];
        }
        let bounds = PlotBounds::from_min_max([shown[0], 0.0], [shown[1], 1.0]);
        Self {
            line,
            transform: PlotTransform::new(frame, bounds, Vec2b::FALSE),
            shown,
            room: rect,
            y,
        }
    }

    fn shows(&self, u: f64) -> bool {
        (self.shown[0]..=self.shown[1]).contains(&u)
    }

    fn at(&self, u: f64) -> Pos2 {
        let u = u.clamp(self.shown[0], self.shown[1]);
        pos2(self.transform.position_from_point_x(u).round(), self.y)
    }

    /// Where the mark of a crossing stands: beyond the axis, beside P₁ or P₂ and not over it.
    fn mark_of(&self, slate: &Slate<'_>, u: f64) -> Pos2 {
        let aside = slate.pts(RING + 4.0 + 0.5 * ARROW);
        match u {
            _ if self.shows(u) => self.at(u),
            _ if u < self.shown[0] => self.at(u) + vec2(-aside, 0.0),
            _ => self.at(u) + vec2(aside, 0.0),
        }
    }

    fn draw(&self, slate: &mut Slate<'_>) {
        self.rest(slate);
        if self.line.empty {
            self.crossed_over(slate);
        } else {
            let stroke = slate.stroke(4.0, slate.theme().accent);
            let [low, high] = self.line.interval.map(|u| self.at(u));
            slate.line([low, high], stroke);
        }
        self.parts(slate);
        for tick in self.line.ticks.iter().filter(|tick| !tick.holds) {
            self.tick(slate, tick);
        }
        let r = slate.pts(RING);
        let stroke = slate.stroke(2.0, slate.theme().ink);
        for u in [0.0, 1.0] {
            let painter = slate.painter;
            painter.circle(self.at(u), r, slate.theme().background, stroke);
        }
        for side in [Side::Entering, Side::Leaving] {
            self.head_of(slate, side);
        }
    }

    /// Has what is left no length? Then both bounds are one mark.
    fn is_point(&self) -> bool {
        let [low, high] = self.line.interval;
        !self.line.empty && low.total_cmp(&high).is_eq()
    }

    /// Equal parts of the segment, as on a ruler.
    fn parts(&self, slate: &mut Slate<'_>) {
        let n = self.line.kept.as_ref().map_or(1, |(n, _)| *n);
        let half = vec2(0.0, slate.pts(4.0));
        let stroke = slate.stroke(1.0, slate.theme().ink);
        for part in 1..n {
            let at = self.at(part as f64 / n as f64);
            slate.line([at - half, at + half], stroke);
        }
    }

    fn rest(&self, slate: &mut Slate<'_>) {
        let theme = slate.theme();
        let hairline = slate.stroke(1.0, theme.discarded);
        let [first, last] = self.shown;
        for (from, to) in [(first, 0.0), (1.0, last)] {
            if to - from > 1e-9 {
                slate.line([self.at(from), self.at(to)], hairline);
            }
        }
        let dashes = slate.stroke(1.75, theme.ink);
        let [low, high] = self.line.interval;
        let [low, high] = [low.min(high), low.max(high)].map(|u| u.clamp(0.0, 1.0));
        for (from, to) in [(0.0, low), (high, 1.0)] {
            if to > from {
                slate.dashed([self.at(from), self.at(to)], dashes, 6.0);
            }
        }
    }

    fn crossed_over(&self, slate: &mut Slate<'_>) {
        let [low, high] = self.line.interval.map(|u| self.at(u));
        let signal = slate.theme().signal;
        let stroke = slate.stroke(2.5, signal);
        if self.line.interval[0] > self.line.interval[1] {
            slate.line([high, low], stroke);
        } else {
            // Empty though the bounds are in order: the line runs beside the window.
            let dashes = slate.stroke(1.75, slate.theme().ink);
            slate.dashed([low, high], dashes, 6.0);
        }
        for ends in cross(high.lerp(low, 0.5), slate.pts(CROSS)) {
            slate.line(ends, stroke);
        }
    }

    /// Its flat side stands at the bound. As long as it is the segment's own end, that one's mark says it.
    fn head_of(&self, slate: &mut Slate<'_>, side: Side) {
        let (own, along) = match side {
            Side::Entering => (0.0, 1.0),
            Side::Leaving => (1.0, -1.0),
        };
        let u = self.line.interval[side as usize];
        if (u - own).abs() < f64::EPSILON || !self.shows(u) {
            return;
        }
        let length = slate.pts(HEAD);
        let flat = self.at(u);
        let tip = flat + vec2(along * length, 0.0);
        let colour = colour(slate.theme(), role_of_bound(self.line, side));
        let half = vec2(0.0, slate.pts(0.5 * HEAD));
        slate.strokes.push([flat - half, flat + half]);
        if self.is_point() {
            slate.head(flat, vec2(along, 0.0), length, colour);
            slate.line([flat - half, flat + half], slate.stroke(2.0, colour));
            return;
        }
        let [low, high] = self.line.interval.map(|u| self.at(u).x);
        if !self.line.empty && high - low < 2.0 * length {
            // No room for both: the lower bound's head stands above the axis, the upper one's below it.
            let aside = if along > 0.0 { -half } else { half };
            slate.area(vec![flat, tip, flat + aside], colour);
            return;
        }
        // What lies under a head does not show at its tip.
        let under = Rect::from_two_pos(flat, tip).expand2(vec2(0.0, slate.pts(3.0)));
        let background = slate.theme().background;
        slate.painter.rect_filled(under, 0.0, background);
        slate.head(tip, vec2(along, 0.0), length, colour);
    }

    fn tick(&self, slate: &mut Slate<'_>, tick: &LineTick) {
        let colour = colour(slate.theme(), role_of(tick));
        let at = self.at(tick.u);
        if self.shows(tick.u) {
            let half = slate.pts(5.0);
            let stroke = slate.stroke(1.75, colour);
            slate.line([at - vec2(0.0, half), at + vec2(0.0, half)], stroke);
            return;
        }
        let along = if tick.u < self.shown[0] { -1.0 } else { 1.0 };
        let tip = self.mark_of(slate, tick.u) + vec2(along * slate.pts(0.5 * ARROW), 0.0);
        slate.head(tip, vec2(along, 0.0), slate.pts(ARROW), colour);
    }
}

const fn role_of(tick: &LineTick) -> Role {
    match (tick.current, tick.holds) {
        (true, _) => Role::Signal,
        (false, true) => Role::Ink,
        (false, false) => Role::Soft,
    }
}

fn role_of_bound(line: &NumberLine, side: Side) -> Role {
    let is_current = |tick: &LineTick| tick.holds && tick.current && tick.side == side;
    if line.ticks.iter().any(is_current) {
        Role::Signal
    } else if line.empty {
        Role::Ink
    } else {
        Role::Accent
    }
}
