//! What is written along the axis. Each text takes the first of its places that is free; bounds that are closer to
//! each other than their labels are wide take opposite sides.

use egui::{Align2, Pos2, Rect, StrokeKind, pos2, vec2};

use crate::{
    figure::{LineTick, NumberLine, Side},
    paint::Typeset,
    text::{Formula, Value},
};

use super::super::{
    on_slate::Links,
    slate::{Face, Slate, text_colour},
};
use super::axis::{NumberAxis, role_of, role_of_bound};

const END_SIZE: f32 = 13.0;
const BOUND_SIZE: f32 = 13.5;
const TICK_SIZE: f32 = 12.5;
/// From the axis to the nearest text.
const OFF: f32 = 10.0;

/// Writes everything: first what stands still, then the bounds, then the names of the crossings.
pub fn draw(slate: &mut Slate<'_>, axis: &NumberAxis, line: &NumberLine, links: &mut Links) {
    ends(slate, axis, line);
    symbol(slate, axis, line);
    // This step's bound chooses first.
    let is_current = |side| {
        line.ticks
            .iter()
            .any(|tick| tick.current && tick.side == side)
    };
    let sides = if is_current(Side::Leaving) {
        [Side::Leaving, Side::Entering]
    } else {
        [Side::Entering, Side::Leaving]
    };
    let widths = [Side::Entering, Side::Leaving].map(|side| set_bound(slate, line, side).size().x);
    let apart = 0.5 * (widths[0] + widths[1]) + slate.pts(12.0);
    let [low, high] = line.interval.map(|u| axis.at(u).x);
    // Labels that would touch make way to both sides.
    let way = (0.5 * (apart - (high - low).abs())).max(0.0);
    for side in sides {
        bound(slate, axis, line, (side, way));
    }
    let mut ticks: Vec<&LineTick> = line.ticks.iter().collect();
    ticks.sort_by_key(|tick| (!tick.current, !tick.holds));
    for tick in ticks {
        crossing(slate, axis, tick, links);
    }
}

/// The names of the segment's ends over its marks, 0 and 1 under them where no bound says so.
fn ends(slate: &mut Slate<'_>, axis: &NumberAxis, line: &NumberLine) {
    let theme = slate.theme();
    let off = vec2(0.0, slate.pts(OFF));
    for (nth, name) in line.ends.iter().enumerate() {
        let u = nth as f64;
        let name = slate.value(name, (Face::Strong, END_SIZE, theme.ink));
        slate.put(&name, axis.at(u) - off, Align2::CENTER_BOTTOM);
        let is_bound = line
            .interval
            .iter()
            .any(|bound| (bound - u).abs() < f64::EPSILON);
        if !is_bound {
            let number = slate.value(&Value::Count(nth), (Face::Plain, END_SIZE, theme.soft));
            slate.put(&number, axis.at(u) + off, Align2::CENTER_TOP);
        }
    }
}

/// The parameter's name beyond the axis's right end.
fn symbol(slate: &mut Slate<'_>, axis: &NumberAxis, line: &NumberLine) {
    let style = (Face::Strong, END_SIZE, slate.theme().ink);
    let symbol = slate.words(line.symbol, style);
    let at = pos2(axis.room.right() - slate.pts(4.0), axis.at(0.0).y);
    slate.put(&symbol, at, Align2::RIGHT_CENTER);
}

const fn bound_of(line: &NumberLine, side: Side) -> f64 {
    let [low, high] = line.interval;
    match side {
        Side::Entering => low,
        Side::Leaving => high,
    }
}

/// `u_min = 3/8`, soft as long as it is what it was at the start.
fn set_bound(slate: &Slate<'_>, line: &NumberLine, side: Side) -> Typeset {
    let (suffix, own) = match side {
        Side::Entering => ("_min", 0.0),
        Side::Leaving => ("_max", 1.0),
    };
    let u = bound_of(line, side);
    let symbol = format!("{}{suffix} = ", line.symbol);
    let [low, high] = &line.values;
    let value = match side {
        Side::Entering => low,
        Side::Leaving => high,
    };
    let mut formula = Formula::default().sym(symbol);
    formula.0.extend_from_slice(&value.0);
    let colour = if (u - own).abs() < f64::EPSILON {
        slate.theme().soft
    } else {
        text_colour(slate.theme(), role_of_bound(line, side))
    };
    slate.formula(&formula, (Face::Strong, BOUND_SIZE, colour))
}

/// Under its arrowhead, `way` points away from the other bound; beside it where something stands there, else over it.
fn bound(slate: &mut Slate<'_>, axis: &NumberAxis, line: &NumberLine, (side, way): (Side, f32)) {
    let u = bound_of(line, side);
    let text = set_bound(slate, line, side);
    let half = 0.5 * text.size();
    let at = axis.at(u);
    let other = line.interval[0] + line.interval[1] - u;
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
    let centres: Vec<Pos2> = centres
        .map(|centre| inside(axis.room, centre, half.x))
        .collect();
    slate.put_free(&text, axis.room, centres);
}

/// Moved until a text of this half width is in the room.
fn inside(room: Rect, centre: Pos2, half: f32) -> Pos2 {
    let least = room.left() + half + 1.0;
    pos2(
        centre
            .x
            .clamp(least, (room.right() - half - 1.0).max(least)),
        centre.y,
    )
}

/// The border's name over its crossing, with the parameter where it is no bound.
fn crossing(slate: &mut Slate<'_>, axis: &NumberAxis, tick: &LineTick, links: &mut Links) {
    let at = axis.mark_of(slate, tick.u);
    let reach = vec2(slate.pts(8.0), slate.pts(14.0));
    if links.touch(Rect::from_center_size(at, 2.0 * reach), tick.link) {
        let ring = slate.stroke(1.5, slate.theme().accent);
        let around = Rect::from_center_size(at, 1.4 * reach);
        slate
            .painter
            .rect_stroke(around, slate.pts(4.0), ring, StrokeKind::Middle);
    }
    let face = if tick.current {
        Face::Strong
    } else {
        Face::Plain
    };
    let style = (face, TICK_SIZE, text_colour(slate.theme(), role_of(tick)));
    if tick.holds {
        let name = slate.value(&tick.name, style);
        put_near(slate, axis, at, &name);
        return;
    }
    let name = slate.look.catalog.value(&tick.name);
    let mut formula = Formula::default().sym(name).sym("  ");
    formula.0.extend_from_slice(&tick.value.0);
    // It stands near P₁ or P₂ and is neither's.
    if !axis.shows(tick.u) {
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
    if !put_near(slate, axis, at, &stacked) {
        // On one line there is room for it over the names of the ends.
        let low = slate.low(&Value::Formula(formula), style);
        put_near(slate, axis, at, &low);
    }
}

/// Puts a crossing's name over it, as near as there is room, or under it; was there any?
fn put_near(slate: &mut Slate<'_>, axis: &NumberAxis, at: Pos2, text: &Typeset) -> bool {
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
    let centres: Vec<Pos2> = centres
        .map(|centre| inside(axis.room, centre, half.x))
        .collect();
    slate.put_free(text, axis.room, centres).is_some()
}
