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

mod flow;
mod plan;

use egui::{Align2, Color32, Painter, Rect, StrokeKind, pos2, vec2};

use crate::{
    figure::{ClipperBox, ClipperRow, Fate},
    paint::Typeset,
    text::Value,
};

use super::super::look::Look;
use super::{
    on_slate::{Links, OnSlate},
    slate::{Face, Slate},
};

use plan::{LETTER, LINE, NAME_SIZE, PAD, Plan};

const COORDINATE_SIZE: f32 = 12.5;

impl OnSlate for ClipperRow {
    fn slate<'a>(&self, painter: &'a Painter, look: Look<'a>, rect: Rect) -> Slate<'a> {
        let room = rect.size();
        Slate::grown(painter, look, room, plan::MOST_GROWN, |slate| {
            plan::wanted(slate, room)
        })
    }

    fn draw(&self, slate: &mut Slate<'_>, rect: Rect, links: &mut Links) {
        let plan = Plan::new(slate, rect, self);
        flow::ends(slate, &plan, self);
        flow::arrows(slate, &plan, self);
        boxes(slate, &plan, self, links);
        flow::travellers(slate, &plan, self);
    }

    /// `x = −4: F = (−2, −1), S = (6, 1); …; P → x = 4; V′: 1`.
    fn spoken(&self, look: Look<'_>) -> String {
        let say = |value: &Value| look.catalog.value(value);
        let held = |symbol: &str, at: Option<[f64; 2]>| match at {
            Some(at) => format!("{symbol} = {}", look.catalog.point(at)),
            None => format!("{symbol} –"),
        };
        let mut parts: Vec<String> = Vec::new();
        for (idx, clipper) in self.clippers.iter().enumerate() {
            let [first, previous] = [held("F", clipper.first), held("S", clipper.previous)];
            let arrow = if self.at_work == Some(idx) {
                "→ "
            } else {
                ""
            };
            let mut part = format!("{arrow}{}: {first}, {previous}", say(&clipper.name));
            if clipper.is_closed {
                part = format!("{part}, {}", look.say("pipe-closed"));
            }
            parts.push(part);
        }
        let output = say(&self.output);
        for traveller in &self.travellers {
            let next = self.clippers.get(traveller.arrow);
            let next = next.map_or_else(|| output.clone(), |clipper| say(&clipper.name));
            let sign = match traveller.fate {
                Fate::GoesOn | Fate::Due => "→",
                Fate::Dropped => "×",
            };
            parts.push(format!("{} {sign} {next}", say(&traveller.name)));
        }
        parts.push(format!("{output}: {}", self.n_out));
        parts.join("; ")
    }
}

fn boxes(slate: &mut Slate<'_>, plan: &Plan, row: &ClipperRow, links: &mut Links) {
    let theme = slate.theme();
    let size = coordinate_size(slate, plan, row);
    for (nth, idx) in plan.shown.clone().enumerate() {
        let clipper = &row.clippers[idx];
        let place = plan.place(nth);
        let corner = slate.pts(4.0);
        if links.touch(place, clipper.link) {
            let ring = slate.stroke(1.5, theme.accent);
            let around = place.expand(slate.pts(4.0));
            slate
                .painter
                .rect_stroke(around, corner, ring, StrokeKind::Middle);
        }
        let is_at_work = row.at_work == Some(idx);
        let (stroke, colour) = match (is_at_work, clipper.is_closed) {
            (true, _) => (slate.stroke(2.5, theme.signal), theme.ink),
            (false, true) => (slate.stroke(1.0, theme.faint), theme.soft),
            (false, false) => (slate.stroke(1.0, theme.soft), theme.ink),
        };
        slate
            .painter
            .rect(place, corner, theme.background, stroke, StrokeKind::Middle);
        let face = if is_at_work {
            Face::Strong
        } else {
            Face::Plain
        };
        let room = place.width() + 0.6 * plan.arrow;
        let name = narrowed(room, |part| {
            slate.value(&clipper.name, (face, part * NAME_SIZE, colour))
        });
        let above = place.center_top() - vec2(0.0, slate.pts(2.5));
        slate.put(&name, above, Align2::CENTER_BOTTOM);
        memory(slate, plan, clipper, (place, colour, size));
    }
}

/// As it is, or as much smaller as it takes to fit: names and coordinates are never cut.
fn narrowed(room: f32, set: impl Fn(f32) -> Typeset) -> Typeset {
    let text = set(1.0);
    let width = text.size().x;
    if width <= room {
        text
    } else {
        set(room / width)
    }
}

/// A vertex in one line, or in two.
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
    let held = clippers
        .iter()
        .flat_map(|clipper| [clipper.first, clipper.previous]);
    let style = (Face::Plain, COORDINATE_SIZE, Color32::PLACEHOLDER);
    let widths = held
        .flat_map(|at| lines(slate, plan, at))
        .map(|line| slate.words(line, style).size().x);
    let widest = widths.fold(1.0, f32::max);
    let room = plan.first.width() - slate.pts(2.0 * PAD.x + LETTER);
    COORDINATE_SIZE * (room / widest).min(1.0)
}

/// F and S.
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
    let held = [
        ("F", clipper.first, inner.top()),
        ("S", clipper.previous, inner.bottom() - n_lines * line),
    ];
    for (letter, at, top) in held {
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
