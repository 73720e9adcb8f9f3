//! What stands at an axis: its ends, both bounds, and the crossings, each where it is free.

use crate::figure::{LineTick, Side};

use super::{super::prelude::*, Axis, role_of, role_of_bound};

const END_SIZE: f32 = 13.0;
const BOUND_SIZE: f32 = 13.5;
const TICK_SIZE: f32 = 12.5;
const OFF: f32 = 10.0;

impl Axis<'_> {
    pub(super) fn names(&self, slate: &mut Slate<'_>, links: &mut Links) {
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
        // What holds keeps its place while others come.
        let mut ticks: Vec<&LineTick> = self.line.ticks.iter().collect();
        ticks.sort_by_key(|tick| (!tick.holds, !tick.current));
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
