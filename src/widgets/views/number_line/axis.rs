//! The axis with its strokes: what is left of it, its ends, the bounds, the crossings that hold none.

use egui::{Pos2, Rect, Shape, Stroke, Vec2b, pos2, vec2};
use egui_plot::{PlotBounds, PlotTransform};

use crate::figure::{LineTick, NumberLine, Role, Side};

use super::super::slate::{Slate, colour};

/// Above the axis: the names of the ends, and two rows for those of borders.
pub const ABOVE: f32 = 52.0;
/// White space at both ends of the axis; on the right the parameter's name.
const ENDS: [f32; 2] = [26.0, 34.0];
/// Crossings farther out are drawn at the end of the axis, as arrows that point to them.
const BEYOND: f64 = 0.12;
/// Radius of the segment's ends.
const RING: f32 = 5.0;
/// Length of a bound's arrowhead.
const HEAD: f32 = 12.0;
/// Length of the arrow to a crossing beyond the axis.
const ARROW: f32 = 8.0;
/// The arms of the cross over an empty interval.
const CROSS: f32 = 6.0;

/// From a parameter to its place.
pub struct NumberAxis {
    transform: PlotTransform,
    shown: [f64; 2],
    /// Where the axis and its labels may be.
    pub room: Rect,
    y: f32,
}

impl NumberAxis {
    pub fn new(slate: &Slate<'_>, rect: Rect, line: &NumberLine) -> Self {
        let [left, right] = ENDS.map(|end| slate.pts(end));
        let y = (rect.top() + slate.pts(ABOVE)).round();
        let frame = Rect::from_min_max(
            pos2(rect.left() + left, rect.top()),
            pos2(
                (rect.right() - right).max(rect.left() + left + 1.0),
                rect.bottom(),
            ),
        );
        let shown = [line.shown[0] - BEYOND, line.shown[1] + BEYOND];
        let shown = if line.shown == [0.0, 1.0] {
            line.shown
        } else {
            shown
        };
        let bounds = PlotBounds::from_min_max([shown[0], 0.0], [shown[1], 1.0]);
        Self {
            transform: PlotTransform::new(frame, bounds, Vec2b::FALSE),
            shown,
            room: rect,
            y,
        }
    }

    /// Is it on the part of the axis that is shown?
    pub fn shows(&self, u: f64) -> bool {
        (self.shown[0]..=self.shown[1]).contains(&u)
    }

    /// The place of a parameter, or the end of the axis beyond which it lies.
    pub fn at(&self, u: f64) -> Pos2 {
        let u = u.clamp(self.shown[0], self.shown[1]);
        pos2(self.transform.position_from_point_x(u).round(), self.y)
    }

    /// Where the mark of a crossing stands: beyond the axis, beside P₁ or P₂ and not over it.
    pub fn mark_of(&self, slate: &Slate<'_>, u: f64) -> Pos2 {
        let aside = slate.pts(RING + 4.0 + 0.5 * ARROW);
        let along = if u < self.shown[0] { -aside } else { aside };
        let at = self.at(u);
        if self.shows(u) {
            at
        } else {
            at + vec2(along, 0.0)
        }
    }

    /// All strokes.
    pub fn draw(&self, slate: &mut Slate<'_>, line: &NumberLine) {
        self.rest(slate, line);
        if line.empty {
            self.crossed_over(slate, line);
        } else {
            let stroke = slate.stroke(4.0, slate.theme().accent);
            let [low, high] = line.interval.map(|u| self.at(u));
            slate.line([low, high], stroke);
            if high.x - low.x < stroke.width {
                // A point is left, and is seen.
                let r = slate.pts(3.5);
                slate.painter.circle_filled(low, r, slate.theme().accent);
            }
        }
        for tick in line.ticks.iter().filter(|tick| !tick.holds) {
            self.tick(slate, tick);
        }
        let r = slate.pts(RING);
        let stroke = slate.stroke(2.0, slate.theme().ink);
        for u in [0.0, 1.0] {
            let at = self.at(u);
            slate
                .painter
                .circle(at, r, slate.theme().background, stroke);
        }
        for side in [Side::Entering, Side::Leaving] {
            self.bound(slate, line, side);
        }
    }

    /// The segment outside the interval is dashed; its line beyond its ends is a hairline.
    fn rest(&self, slate: &mut Slate<'_>, line: &NumberLine) {
        let theme = slate.theme();
        let hairline = slate.stroke(1.0, theme.discarded);
        let [first, last] = self.shown;
        for (from, to) in [(first, 0.0), (1.0, last)] {
            if to - from > 1e-9 {
                slate.line([self.at(from), self.at(to)], hairline);
            }
        }
        let dashes = slate.stroke(1.75, theme.ink);
        let [low, high] = line.interval;
        let [low, high] = [low.min(high), low.max(high)].map(|u| u.clamp(0.0, 1.0));
        for (from, to) in [(0.0, low), (high, 1.0)] {
            if to > from {
                slate.dashed([self.at(from), self.at(to)], dashes, 6.0);
            }
        }
    }

    /// There is nothing between the bounds.
    fn crossed_over(&self, slate: &mut Slate<'_>, line: &NumberLine) {
        let [low, high] = line.interval.map(|u| self.at(u));
        let signal = slate.theme().signal;
        let stroke = slate.stroke(2.5, signal);
        if line.interval[0] > line.interval[1] {
            slate.line([high, low], stroke);
        } else {
            // Empty though the bounds are in order: the line runs beside the window.
            let dashes = slate.stroke(1.75, slate.theme().ink);
            slate.dashed([low, high], dashes, 6.0);
        }
        let middle = high.lerp(low, 0.5);
        let arm = slate.pts(CROSS);
        for y in [-arm, arm] {
            let ends = [middle + vec2(-arm, -y), middle + vec2(arm, y)];
            slate.line(ends, stroke);
        }
    }

    /// Its flat side stands at the bound. As long as it is the segment's own end, that one's mark says it.
    fn bound(&self, slate: &mut Slate<'_>, line: &NumberLine, side: Side) {
        let (u, own, along) = match side {
            Side::Entering => (line.interval[0], 0.0, 1.0),
            Side::Leaving => (line.interval[1], 1.0, -1.0),
        };
        let is_own = (u - own).abs() < f64::EPSILON;
        if is_own || !self.shows(u) {
            return;
        }
        let length = slate.pts(HEAD);
        let flat = self.at(u);
        let tip = flat + vec2(along * length, 0.0);
        let colour = colour(slate.theme(), role_of_bound(line, side));
        let half = vec2(0.0, slate.pts(0.5 * HEAD));
        slate.strokes.push([flat - half, flat + half]);
        let [low, high] = line.interval.map(|u| self.at(u).x);
        if !line.empty && high - low < 2.0 * length {
            // No room for both: the lower bound's head stands above the axis, the upper one's below it.
            let aside = if along > 0.0 { -half } else { half };
            let corners = vec![flat, tip, flat + aside];
            slate
                .painter
                .add(Shape::convex_polygon(corners, colour, Stroke::NONE));
            return;
        }
        // What lies under a head does not show at its tip.
        let under = Rect::from_two_pos(flat, tip).expand2(vec2(0.0, slate.pts(3.0)));
        slate
            .painter
            .rect_filled(under, 0.0, slate.theme().background);
        slate.head(tip, vec2(along, 0.0), length, colour);
    }

    /// A crossing that holds no bound: a small stroke, or at the end of the axis an arrow to where it is.
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

/// This step's crossing is signal, one that no longer matters is grey.
pub const fn role_of(tick: &LineTick) -> Role {
    match (tick.current, tick.holds) {
        (true, _) => Role::Signal,
        (false, true) => Role::Ink,
        (false, false) => Role::Soft,
    }
}

/// Of the crossing that holds it, accent as long as anything is left.
pub fn role_of_bound(line: &NumberLine, side: Side) -> Role {
    let is_current = |tick: &LineTick| tick.holds && tick.current && tick.side == side;
    if line.ticks.iter().any(is_current) {
        Role::Signal
    } else if line.empty {
        Role::Ink
    } else {
        Role::Accent
    }
}
