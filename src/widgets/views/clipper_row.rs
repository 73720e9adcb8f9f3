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

use std::ops::Range;

use crate::figure::{ClipperBox, ClipperRow, Fate, Traveller};

use super::{prelude::*, slate::cross};

const COORDINATE_SIZE: f32 = 12.5;
/// As many clippers as a window has sides are shown wherever they are; more only if there is room.
const LEAST_SHOWN: usize = 4;
const MOST_SHOWN: usize = 6;
const MARGIN: Vec2 = vec2(4.0, 8.0);
const PAD: Vec2 = vec2(7.0, 5.0);
const LEAST_ARROW: f32 = 32.0;
const MOST_ARROW: f32 = 96.0;
const NAME: f32 = 19.0;
const LINE: f32 = 15.5;
const NAME_SIZE: f32 = 13.0;
const LETTER: f32 = 14.0;
const ENDS: [f32; 2] = [16.0, 24.0];

impl OnSlate for ClipperRow {
    fn slate<'a>(&self, natural: Slate<'a>, room: Vec2) -> Slate<'a> {
        let wanted = |slate: &Slate<'_>| natural_size(is_stacked(slate, room)) * slate.scale;
        natural.fitted_in(room, wanted)
    }

    fn draw(&self, slate: &mut Slate<'_>, rect: Rect, links: &mut Links) {
        let plan = Plan::new(slate, rect, self);
        ends(slate, &plan, self);
        arrows(slate, &plan, self);
        let size = coordinate_size(slate, &plan, self);
        for (nth, idx) in plan.shown.clone().enumerate() {
            let is_at_work = self.at_work == Some(idx);
            let place = plan.place(nth);
            let clipper = (&self.clippers[idx], is_at_work, size);
            draw_box(slate, &plan, place, clipper, links);
        }
        travellers(slate, &plan, self);
    }

    /// `x = −4: F = (−2, −1), S = (6, 1); …; P → x = 4; V′: 1`.
    fn spoken(&self, look: Look<'_>) -> String {
        let say = |value: &Value| look.catalog.value(value);
        let held = |symbol: &str, at: Option<[f64; 2]>| match at {
            Some(at) => format!("{symbol} = {}", look.catalog.point(at)),
            None => format!("{symbol} –"),
        };
        let clippers = self.clippers.iter().enumerate().map(|(idx, clipper)| {
            let [first, previous] = [held("F", clipper.first), held("S", clipper.previous)];
            let name = say(&clipper.name);
            let part = format!(
                "{}{name}: {first}, {previous}",
                now(self.at_work == Some(idx))
            );
            if clipper.is_closed {
                format!("{part}, {}", look.say("pipe-closed"))
            } else {
                part
            }
        });
        let output = say(&self.output);
        let travellers = self.travellers.iter().map(|traveller| {
            let next = self.clippers.get(traveller.arrow);
            let next = next.map_or_else(|| output.clone(), |clipper| say(&clipper.name));
            let sign = match traveller.fate {
                Fate::GoesOn | Fate::Due => "→",
                Fate::Dropped => "×",
            };
            format!("{} {sign} {next}", say(&traveller.name))
        });
        let out = format!("{output}: {}", self.n_out);
        joined(clippers.chain(travellers).chain([out]), "; ")
    }
}

fn draw_box(
    slate: &mut Slate<'_>,
    plan: &Plan,
    place: Rect,
    (clipper, is_at_work, size): (&ClipperBox, bool, f32),
    links: &mut Links,
) {
    let theme = slate.theme();
    let corner = slate.pts(4.0);
    if links.touch(place, clipper.link) {
        slate.ring(place.expand(slate.pts(4.0)), corner, 1.5);
    }
    let (stroke, colour) = match (is_at_work, clipper.is_closed) {
        (true, _) => (slate.stroke(2.5, theme.signal), theme.ink),
        (false, true) => (slate.stroke(1.0, theme.faint), theme.soft),
        (false, false) => (slate.stroke(1.0, theme.soft), theme.ink),
    };
    let painter = slate.painter;
    painter.rect(place, corner, theme.background, stroke, StrokeKind::Middle);
    let room = place.width() + 0.6 * plan.arrow;
    let face = Face::strong_if(is_at_work);
    let set = |part: f32| slate.value(&clipper.name, (face, part * NAME_SIZE, colour));
    // As much smaller as it takes to fit: names and coordinates are never cut.
    let mut name = set(1.0);
    if name.size().x > room {
        name = set(room / name.size().x);
    }
    let above = place.center_top() - vec2(0.0, slate.pts(2.5));
    slate.put(&name, above, Align2::CENTER_BOTTOM);
    memory(slate, plan, clipper, (place, colour, size));
}

fn lines(slate: &Slate<'_>, plan: &Plan, at: Option<[f64; 2]>) -> Vec<String> {
    let catalog = slate.look.catalog;
    let Some(at) = at else {
        return vec!["–".to_owned()];
    };
    let point = catalog.point(at);
    if !plan.is_stacked {
        return vec![point];
    }
    // Also below each other, the numbers of a point are all fractions or all decimals.
    let numbers = point.trim_matches(['(', ')']);
    let numbers = numbers.split(catalog.lang().list_separator());
    numbers.map(str::to_owned).collect()
}

/// All coordinates are set in one size: that in which the longest fits.
fn coordinate_size(slate: &Slate<'_>, plan: &Plan, row: &ClipperRow) -> f32 {
    let clippers = &row.clippers[plan.shown.clone()];
    let clippers = clippers.iter();
    let held = clippers.flat_map(|clipper| [clipper.first, clipper.previous]);
    let style = (Face::Plain, COORDINATE_SIZE, Color32::PLACEHOLDER);
    let lines = held.flat_map(|at| lines(slate, plan, at));
    let widths = lines.map(|line| slate.words(line, style).size().x);
    let widest = widths.fold(1.0, f32::max);
    let room = plan.first.width() - slate.pts(2.0 * PAD.x + LETTER);
    COORDINATE_SIZE * (room / widest).min(1.0)
}

fn memory(
    slate: &mut Slate<'_>,
    plan: &Plan,
    clipper: &ClipperBox,
    (place, colour, size): (Rect, Color32, f32),
) {
    let theme = slate.theme();
    let inner = place.shrink2(PAD * slate.scale);
    let line = slate.pts(LINE);
    let n_lines = if plan.is_stacked { 2.0 } else { 1.0 };
    let tops = [inner.top(), inner.bottom() - n_lines * line];
    let held = [("F", clipper.first), ("S", clipper.previous)];
    for ((letter, at), top) in held.into_iter().zip(tops) {
        let colour = if at.is_some() { colour } else { theme.soft };
        let middle = |nth: usize| top + (nth as f32 + 0.5) * line;
        let letter = slate.words(letter, (Face::Plain, COORDINATE_SIZE, theme.soft));
        slate.put(&letter, pos2(inner.left(), middle(0)), Align2::LEFT_CENTER);
        let left = inner.left() + slate.pts(LETTER);
        for (nth, words) in lines(slate, plan, at).into_iter().enumerate() {
            let words = slate.words(words, (Face::Plain, size, colour));
            slate.put(&words, pos2(left, middle(nth)), Align2::LEFT_CENTER);
        }
    }
}

fn box_size(is_stacked: bool) -> Vec2 {
    // Room for `(−1/3, 0.1235)`, or stacked for `0.1235`, after the letter; stacked, F and S are set apart.
    let [n_lines, apart, text] = if is_stacked {
        [4.0, 5.0, 48.0]
    } else {
        [2.0, 0.0, 96.0]
    };
    2.0 * PAD + vec2(LETTER + text, n_lines * LINE + apart)
}

fn natural_size(is_stacked: bool) -> Vec2 {
    let n = LEAST_SHOWN as f32;
    let size = box_size(is_stacked);
    let ends = ENDS[0] + ENDS[1] + (n + 1.0) * LEAST_ARROW;
    2.0 * MARGIN + vec2(n * size.x + ends, NAME + size.y)
}

/// A coordinate stands below the other where they have no room beside each other, not even in text of plain size.
fn is_stacked(slate: &Slate<'_>, room: Vec2) -> bool {
    room.x < slate.scale.min(1.0) * natural_size(false).x
}

struct Plan {
    shown: Range<usize>,
    is_stacked: bool,
    first: Rect,
    arrow: f32,
    is_cut: bool,
}

impl Plan {
    fn new(slate: &Slate<'_>, rect: Rect, row: &ClipperRow) -> Self {
        let is_stacked = is_stacked(slate, rect.size());
        let natural = box_size(is_stacked) * slate.scale;
        let [left, right] = ENDS.map(|end| slate.pts(end));
        let least = slate.pts(LEAST_ARROW);
        let margin = MARGIN * slate.scale;
        let room = rect.width() - 2.0 * margin.x - left - right;
        let fit = ((room - least) / (natural.x + least)).max(0.0) as usize;
        // Of many clippers those about the one at work.
        let n_all = row.clippers.len();
        let last = n_all.saturating_sub(1);
        let on_its_way = row.travellers.first().map(|traveller| traveller.arrow);
        let is_done = row.clippers.iter().all(|clipper| clipper.is_closed);
        let at_rest = if is_done { last } else { 0 };
        let about = row.at_work.or(on_its_way).unwrap_or(at_rest).min(last);
        let n = fit.clamp(LEAST_SHOWN, MOST_SHOWN).min(n_all);
        let start = about.saturating_sub(n / 2).min(n_all - n);
        let shown = start..start + n;
        let is_cut = shown.end < row.clippers.len();
        let room = if is_cut { room - left } else { room };
        let n = shown.len() as f32;
        let fair = (room - (n + 1.0) * least) / n;
        let width = natural.x.min(fair).max(1.0).floor();
        let arrow = ((room - n * width) / (n + 1.0)).min(slate.pts(MOST_ARROW));
        let spare = 0.5 * (room - n * width - (n + 1.0) * arrow);
        let x = rect.left() + margin.x + left + spare + arrow;
        let used = slate.pts(NAME) + natural.y;
        let y = rect.top() + (0.5 * (rect.height() - used)).min(2.0 * margin.y) + slate.pts(NAME);
        Self {
            shown,
            is_stacked,
            first: Rect::from_min_size(pos2(x, y).round(), vec2(width, natural.y.round())),
            arrow,
            is_cut,
        }
    }

    fn place(&self, nth: usize) -> Rect {
        let x = nth as f32 * (self.first.width() + self.arrow);
        self.first.translate(vec2(x.round(), 0.0))
    }

    fn arrow(&self, nth: usize) -> [Pos2; 2] {
        let head = self.place(nth).left_center();
        [head - vec2(self.arrow, 0.0), head]
    }
}

fn ends(slate: &mut Slate<'_>, plan: &Plan, row: &ClipperRow) {
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
    let style = (Face::Strong, NAME_SIZE + 1.0, theme.accent);
    let number = slate.words(row.n_out.to_string(), style);
    let number = slate.put(&number, at, Align2::LEFT_CENTER);
    let symbol = slate.value(&row.output, soft);
    slate.put(&symbol, number.left_top(), Align2::LEFT_BOTTOM);
}

fn arrows(slate: &mut Slate<'_>, plan: &Plan, row: &ClipperRow) {
    let theme = slate.theme();
    let is_used = |arrow| row.travellers.iter().any(|t| t.arrow == arrow);
    let is_done = row.at_work.is_none() && row.clippers.last().is_some_and(|last| last.is_closed);
    for nth in 0..=plan.shown.len() {
        let arrow = plan.shown.start + nth;
        let next = row.clippers.get(arrow);
        let is_closed = next.map_or(is_done, |clipper| clipper.is_closed);
        let [from, to] = plan.arrow(nth);
        let off = vec2(slate.pts(3.0), 0.0);
        let (from, to) = (from + off, to - off);
        let is_used = is_used(arrow);
        if is_closed && !is_used {
            let end = to - 2.0 * off;
            let half = vec2(0.0, slate.pts(6.0));
            slate.line([from, end], slate.stroke(1.25, theme.discarded));
            slate.line([end - half, end + half], slate.stroke(2.0, theme.discarded));
        } else {
            let colour = if is_used { theme.ink } else { theme.soft };
            slate.arrow([from, to], slate.stroke(1.25, colour));
        }
    }
}

fn travellers(slate: &mut Slate<'_>, plan: &Plan, row: &ClipperRow) {
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

fn name(slate: &mut Slate<'_>, plan: &Plan, traveller: &Traveller, (nth, at): (usize, Pos2)) {
    let style = (Face::Strong, NAME_SIZE, slate.theme().signal_text);
    let name = slate.value(&traveller.name, style);
    let size = name.size();
    let [from, to] = plan.arrow(nth);
    let half = 0.5 * size.x + 1.0;
    // At the ends of the row there is room beyond the arrow, elsewhere there is a box.
    let [mut left, mut right] = [from.x + half, to.x - half];
    if nth == 0 {
        left = f32::NEG_INFINITY;
    }
    if nth == plan.shown.len() {
        right = f32::INFINITY;
    }
    let x = if left <= right {
        at.x.clamp(left, right)
    } else {
        0.5 * (from.x + to.x)
    };
    let off = slate.pts(7.0) + 0.5 * size.y;
    let box_of = |y: f32| Rect::from_center_size(pos2(x, y), size);
    let above = box_of(at.y - off);
    let around = above.expand2(vec2(1.5, 0.0));
    let is_taken = slate.texts.iter().any(|text| text.intersects(around));
    let place = if is_taken { box_of(at.y + off) } else { above };
    slate.put(&name, place.center(), Align2::CENTER_CENTER);
}

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
            for ends in cross(at, 0.9 * r) {
                slate.painter.line_segment(ends, stroke);
            }
        }
    }
}
