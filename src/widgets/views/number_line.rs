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
const END_SIZE: f32 = 13.0;
const BOUND_SIZE: f32 = 13.5;
const TICK_SIZE: f32 = 12.5;
const OFF: f32 = 10.0;

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

    fn names(&self, slate: &mut Slate<'_>, links: &mut Links) {
        self.ends(slate);
        // This step's bound chooses first.
        let is_last = |tick: &LineTick| tick.current && tick.side == Side::Leaving;
        let mut sides = vec![Side::Entering, Side::Leaving];
        if self.line.ticks.iter().any(is_last) {
            sides.reverse();
        }
        if self.is_point() {
            sides.truncate(1);
        }
        let width = |side| self.set_bound(slate, side).size().x;
        let both = width(Side::Entering) + width(Side::Leaving);
        let apart = 0.5 * both + slate.pts(12.0);
        let [low, high] = self.line.interval.map(|u| self.at(u).x);
        // Labels that would touch make way to both sides.
        let way = (0.5 * (apart - (high - low).abs())).max(0.0);
        if let Some((_, kept)) = &self.line.kept {
            let text = slate.value(kept, (Face::Strong, END_SIZE, slate.theme().ink));
            let [low, high] = self.line.interval.map(|u| self.at(u));
            self.put_near(slate, low.lerp(high, 0.5), &text);
        }
        for side in sides {
            self.bound(slate, side, way);
        }
        let mut ticks: Vec<&LineTick> = self.line.ticks.iter().collect();
        ticks.sort_by_key(|tick| (!tick.current, !tick.holds));
        for tick in ticks {
            self.crossing(slate, tick, links);
        }
    }

    fn ends(&self, slate: &mut Slate<'_>) {
        let theme = slate.theme();
        let off = vec2(0.0, slate.pts(OFF));
        for (nth, name) in self.line.ends.iter().enumerate() {
            let u = nth as f64;
            let name = slate.value(name, (Face::Strong, END_SIZE, theme.ink));
            slate.put(&name, self.at(u) - off, Align2::CENTER_BOTTOM);
            let is_at = |bound: f64| (bound - u).abs() < f64::EPSILON;
            if !self.line.interval.into_iter().any(is_at) {
                let number = slate.value(&Value::Count(nth), (Face::Plain, END_SIZE, theme.soft));
                slate.put(&number, self.at(u) + off, Align2::CENTER_TOP);
            }
        }
        let symbol = slate.words(self.line.symbol, (Face::Strong, END_SIZE, theme.ink));
        let at = pos2(self.room.right() - slate.pts(4.0), self.at(0.0).y);
        slate.put(&symbol, at, Align2::RIGHT_CENTER);
    }

    /// `u_min = 3/8`, soft as long as it is what it was at the start.
    fn set_bound(&self, slate: &Slate<'_>, side: Side) -> Typeset {
        let (suffix, own) = match side {
            Side::Entering => ("_min", 0.0),
            Side::Leaving => ("_max", 1.0),
        };
        let nth = side as usize;
        let symbol = format!("{}{suffix} = ", self.line.symbol);
        let both = format!("{0}_min = {0}_max = ", self.line.symbol);
        let symbol = if self.is_point() { both } else { symbol };
        let mut formula = Formula::default().sym(symbol);
        formula.0.extend_from_slice(&self.line.values[nth].0);
        let colour = if (self.line.interval[nth] - own).abs() < f64::EPSILON {
            slate.theme().soft
        } else {
            text_colour(slate.theme(), role_of_bound(self.line, side))
        };
        slate.formula(&formula, (Face::Strong, BOUND_SIZE, colour))
    }

    /// Under its arrowhead, `way` points away from the other bound; beside it where something stands there, else over it.
    fn bound(&self, slate: &mut Slate<'_>, side: Side, way: f32) {
        let u = self.line.interval[side as usize];
        let text = self.set_bound(slate, side);
        let half = 0.5 * text.size();
        let at = self.at(u);
        let other = self.line.interval[0] + self.line.interval[1] - u;
        let is_left = u < other || (u <= other && side == Side::Entering);
        let outward = if is_left { -1.0 } else { 1.0 };
        let way = way.min(0.9 * half.x);
        let under = at.y + slate.pts(OFF) + half.y;
        let over = at.y - slate.pts(OFF) - half.y;
        let far = at.y - slate.pts(2.9 * OFF) - half.y;
        let centres = [under, over, far].into_iter().flat_map(|y| {
            let steps = (0..=12).map(move |nth| outward * nth as f32 / 10.0 * half.x);
            steps.flat_map(move |aside| {
                [aside, -aside].map(|aside| pos2(at.x + outward * way + aside, y))
            })
        });
        self.put_inside(slate, &text, centres);
    }

    /// At the first of these places that is free, each moved until the text is in the room; was there any?
    fn put_inside(
        &self,
        slate: &mut Slate<'_>,
        text: &Typeset,
        centres: impl Iterator<Item = Pos2>,
    ) -> bool {
        let half = 0.5 * text.size().x;
        let least = self.room.left() + half + 1.0;
        let most = (self.room.right() - half - 1.0).max(least);
        let centres = centres.map(|at| pos2(at.x.clamp(least, most), at.y));
        slate.put_free(text, self.room, centres).is_some()
    }

    fn crossing(&self, slate: &mut Slate<'_>, tick: &LineTick, links: &mut Links) {
        let at = self.mark_of(slate, tick.u);
        let reach = vec2(slate.pts(8.0), slate.pts(14.0));
        if links.touch(Rect::from_center_size(at, 2.0 * reach), tick.link) {
            let around = Rect::from_center_size(at, 1.4 * reach);
            slate.ring(around, slate.pts(4.0), 1.5);
        }
        let face = Face::strong_if(tick.current);
        let style = (face, TICK_SIZE, text_colour(slate.theme(), role_of(tick)));
        if tick.holds {
            let name = slate.value(&tick.name, style);
            self.put_near(slate, at, &name);
            return;
        }
        let name = slate.look.catalog.value(&tick.name);
        let mut formula = Formula::default().sym(name).sym("  ");
        formula.0.extend_from_slice(&tick.value.0);
        // It stands near P₁ or P₂ and is neither's.
        if !self.shows(tick.u) {
            formula = match tick.u {
                ..0.0 => {
                    let mut pointing = Formula::default().sym("← ");
                    pointing.0.append(&mut formula.0);
                    pointing
                }
                _ => formula.sym(" →"),
            };
        }
        let stacked = slate.formula(&formula, style);
        if !self.put_near(slate, at, &stacked) {
            // On one line there is room for it over the names of the ends.
            let low = slate.low(&Value::Formula(formula), style);
            self.put_near(slate, at, &low);
        }
    }

    fn put_near(&self, slate: &mut Slate<'_>, at: Pos2, text: &Typeset) -> bool {
        let half = 0.5 * text.size();
        let off = slate.pts(OFF) + half.y;
        let row = slate.pts(1.5 * TICK_SIZE);
        let over = [0.0, 0.5, 1.0].map(|lane| at.y - off - lane * row);
        let heights = over.into_iter().chain([at.y + off, at.y + off + row]);
        let centres = heights.flat_map(|y| {
            (0..=10).flat_map(move |nth| {
                let aside = nth as f32 / 10.0 * half.x;
                [aside, -aside].map(|aside| pos2(at.x + aside, y))
            })
        });
        self.put_inside(slate, text, centres)
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
