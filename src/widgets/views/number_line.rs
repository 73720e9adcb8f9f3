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

mod axis;
mod names;

use egui::{Painter, Rect, vec2};

use crate::{
    figure::{LineTick, NumberLine, Side},
    text::{Formula, Notation, Value},
};

use super::super::look::Look;
use super::{
    on_slate::{Links, OnSlate},
    slate::Slate,
};

use axis::{ABOVE, NumberAxis};

/// Below it: 0 and 1, and a bound with a stacked fraction.
const BELOW: f32 = 48.0;

impl OnSlate for NumberLine {
    fn slate<'a>(&self, painter: &'a Painter, look: Look<'a>, rect: Rect) -> Slate<'a> {
        let slate = Slate::with_numbers(painter, look, notation(self));
        slate.fitted_in(rect.size(), |slate| {
            vec2(0.75 * rect.width(), slate.pts(ABOVE + BELOW))
        })
    }

    fn draw(&self, slate: &mut Slate<'_>, rect: Rect, links: &mut Links) {
        let axis = NumberAxis::new(slate, rect, self);
        axis.draw(slate, self);
        names::draw(slate, &axis, self, links);
    }

    fn spoken(&self, look: Look<'_>) -> String {
        let notation = notation(self);
        let said = |value: &Formula| look.catalog.formula_as(value, notation);
        let [low, high] = [0, 1].map(|i| said(&self.values[i]));
        let symbol = self.symbol;
        let mut parts = vec![format!("{symbol}_min = {low}, {symbol}_max = {high}")];
        if self.empty {
            // Where the line runs beside the window the bounds are still in order.
            let is_crossed_over = self.interval[0] > self.interval[1];
            parts.push(if is_crossed_over {
                format!("{symbol}_min > {symbol}_max")
            } else {
                look.catalog.term("view-empty")
            });
        }
        let tick = |tick: &LineTick| {
            let arrow = if tick.current { "→ " } else { "" };
            let sign = match tick.side {
                Side::Entering => "▶",
                Side::Leaving => "◀",
            };
            let name = look.catalog.value(&tick.name);
            format!("{arrow}{name} {sign} {symbol} = {}", said(&tick.value))
        };
        parts.extend(self.ticks.iter().map(tick));
        parts.join("; ")
    }
}

/// Bounds and crossings are compared: all of them are fractions, or all decimals.
fn notation(line: &NumberLine) -> Notation {
    let crossings = line.ticks.iter().map(|tick| &tick.value);
    let values = line.values.iter().chain(crossings).cloned();
    let values: Vec<Value> = values.map(Value::Formula).collect();
    Notation::of(&values)
}
