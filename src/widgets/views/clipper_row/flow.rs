//! What flows between clippers: arrows, the vertices that are on their way, what comes in and out at the ends.

use egui::{Align2, Pos2, Rect, Vec2, pos2, vec2};

use crate::figure::{ClipperRow, Fate, Traveller};

use super::super::slate::{Face, Slate};
use super::plan::{ENDS, NAME_SIZE, Plan};

/// V on the left, or what is left out; on the right as many vertices as have come out.
pub fn ends(slate: &mut Slate<'_>, plan: &Plan, row: &ClipperRow) {
    let theme = slate.theme();
    let soft = (Face::Plain, NAME_SIZE, theme.soft);
    let [first, last] = [0, plan.shown.len()].map(|nth| plan.arrow(nth));
    let start = slate.words(if plan.shown.start > 0 { "…" } else { "V" }, soft);
    let at = first[0] - vec2(slate.pts(4.0), 0.0);
    slate.put(&start, at, Align2::RIGHT_CENTER);
    let mut at = last[1] + vec2(slate.pts(5.0), 0.0);
    if plan.is_cut {
        let dots = slate.words("…", soft);
        slate.put(&dots, at, Align2::LEFT_CENTER);
        at.x += slate.pts(ENDS[0]);
    }
    let number = slate.words(
        row.n_out.to_string(),
        (Face::Strong, NAME_SIZE + 1.0, theme.accent),
    );
    let number = slate.put(&number, at, Align2::LEFT_CENTER);
    let symbol = slate.value(&row.output, soft);
    slate.put(&symbol, number.left_top(), Align2::LEFT_BOTTOM);
}

/// One between two clippers each; a bar stands where no vertex will come any more.
pub fn arrows(slate: &mut Slate<'_>, plan: &Plan, row: &ClipperRow) {
    let theme = slate.theme();
    let is_used = |arrow| row.travellers.iter().any(|t| t.arrow == arrow);
    let is_done = row.at_work.is_none() && row.clippers.last().is_some_and(|last| last.is_closed);
    for nth in 0..=plan.shown.len() {
        let arrow = plan.shown.start + nth;
        let is_closed = row
            .clippers
            .get(arrow)
            .map_or(is_done, |clipper| clipper.is_closed);
        let [from, to] = plan.arrow(nth);
        let off = vec2(slate.pts(3.0), 0.0);
        let (from, to) = (from + off, to - off);
        let colour = if is_used(arrow) {
            theme.ink
        } else {
            theme.soft
        };
        let stroke = slate.stroke(1.25, colour);
        if is_closed && !is_used(arrow) {
            let end = to - 2.0 * off;
            let half = vec2(0.0, slate.pts(6.0));
            slate.line([from, end], slate.stroke(1.25, theme.discarded));
            slate.line([end - half, end + half], slate.stroke(2.0, theme.discarded));
        } else {
            slate.arrow([from, to], stroke);
        }
    }
}

/// The vertices that are on their way, with their names over the arrow.
pub fn travellers(slate: &mut Slate<'_>, plan: &Plan, row: &ClipperRow) {
    let n = row.travellers.len();
    for (i, traveller) in row.travellers.iter().enumerate() {
        let nth = traveller.arrow.checked_sub(plan.shown.start);
        let Some(nth) = nth.filter(|&nth| nth <= plan.shown.len()) else {
            continue;
        };
        let [from, to] = plan.arrow(nth);
        let along = match (n, i, traveller.fate) {
            (1, _, Fate::Dropped) => 0.3,
            (1, ..) => 0.45,
            (_, 0, _) => 0.62,
            _ => 0.24,
        };
        let at = from + along * (to - from);
        marker(slate, at, traveller.fate);
        name(slate, plan, traveller, (nth, at));
    }
}

/// Above the arrow, clear of the boxes; below it where another name stands.
fn name(slate: &mut Slate<'_>, plan: &Plan, traveller: &Traveller, (nth, at): (usize, Pos2)) {
    let style = (Face::Strong, NAME_SIZE, slate.theme().signal_text);
    let name = slate.value(&traveller.name, style);
    let size: Vec2 = name.size();
    let [from, to] = plan.arrow(nth);
    let half = 0.5 * size.x + 1.0;
    // At the ends of the row there is room beyond the arrow, elsewhere there is a box.
    let left = if nth == 0 {
        f32::NEG_INFINITY
    } else {
        from.x + half
    };
    let right = if nth == plan.shown.len() {
        f32::INFINITY
    } else {
        to.x - half
    };
    let x = if left <= right {
        at.x.clamp(left, right)
    } else {
        0.5 * (from.x + to.x)
    };
    let off = slate.pts(7.0) + 0.5 * size.y;
    let box_of = |y: f32| Rect::from_center_size(pos2(x, y), size);
    let above = box_of(at.y - off);
    let is_taken = slate
        .texts
        .iter()
        .any(|text| text.intersects(above.expand2(vec2(1.5, 0.0))));
    let place = if is_taken { box_of(at.y + off) } else { above };
    slate.put(&name, place.center(), Align2::CENTER_CENTER);
}

/// A dot goes on, a ring is yet to be worked out, a cross stays behind.
fn marker(slate: &mut Slate<'_>, at: Pos2, fate: Fate) {
    let theme = slate.theme();
    let r = slate.pts(4.5);
    match fate {
        Fate::GoesOn => {
            slate.painter.circle_filled(at, r, theme.signal);
        }
        Fate::Due => {
            let stroke = slate.stroke(1.75, theme.signal);
            slate.painter.circle(at, r - 0.5, theme.background, stroke);
        }
        Fate::Dropped => {
            // The arrow must not cross the cross out.
            slate.painter.circle_filled(at, 1.4 * r, theme.background);
            let stroke = slate.stroke(2.0, theme.signal);
            for y in [-r, r] {
                let ends = [at + 0.9 * vec2(-r, -y), at + 0.9 * vec2(r, y)];
                slate.painter.line_segment(ends, stroke);
            }
        }
    }
}
