//! Codes over each other, bit by bit: a box goes through all rows where one column decides.
//!
//! ```text
//!        top  bottom right left
//!       ┏━━━┓
//!   P₁  ┃ 1 ┃  0      0     1
//!   P₂  ┃ 1 ┃  0      0     0
//!       ┠───┨────────────────
//!  AND  ┃▐1▌┃  0      0     0
//!       ┗━━━┛
//!   AND keeps a bit only where both have it.
//! ```

use egui::{Align2, Painter, Rect, Vec2, pos2, vec2};

use crate::{
    figure::{BitRow, Bits, Role},
    text::Value,
};

use super::super::look::Look;
use super::{
    on_slate::{Links, OnSlate},
    slate::{Face, LEAST_SCALE, Slate, wash},
};

/// A cell, and white space between two of them.
const CELL: f32 = 54.0;
const GAP: f32 = 9.0;
/// The names of the columns, above the cells.
const HEADER: f32 = 30.0;
/// White space between the codes and the line under them, and below it.
const RULE: f32 = 18.0;
/// Between the rows and the note.
const NOTE_GAP: f32 = 22.0;
const NAME_SIZE: f32 = 15.0;
const HEADER_SIZE: f32 = 12.5;
const NOTE_SIZE: f32 = 13.0;
const DIGIT_SIZE: f32 = 24.0;
/// Where there is room, all of it grows to so many times its natural size.
const MOST_GROWN: f32 = 1.35;

/// Where everything stands, at a slate's scale.
struct Plan {
    /// Left of the first cell, from the view's left.
    names: f32,
    /// Width of a cell and the space after it.
    step: f32,
    n_rows: usize,
}

impl Plan {
    fn of(slate: &Slate<'_>, bits: &Bits) -> Self {
        let ink = slate.theme().ink;
        let width = |value: &Value, face, size| slate.value(value, (face, size, ink)).size().x;
        let rows = bits.rows.iter().chain(&bits.result);
        let names = rows.map(|row| width(&row.name, Face::Strong, NAME_SIZE));
        let titles = bits.columns.iter();
        let titles = titles.map(|title| width(title, Face::Strong, HEADER_SIZE));
        let cell = titles.fold(slate.pts(CELL), f32::max);
        Self {
            names: names.fold(0.0, f32::max).max(slate.pts(32.0)) + slate.pts(20.0),
            step: cell + slate.pts(GAP),
            n_rows: bits.rows.len(),
        }
    }

    fn width(&self, slate: &Slate<'_>, bits: &Bits) -> f32 {
        self.names + bits.columns.len() as f32 * self.step - slate.pts(GAP)
    }

    /// The cell in a row and a column; the result stands in the row after the last.
    fn cell(&self, slate: &Slate<'_>, origin: egui::Pos2, row: usize, column: usize) -> Rect {
        let is_result = row == self.n_rows;
        let below = if is_result { 2.0 * RULE - GAP } else { 0.0 };
        let y = slate.pts(HEADER + row as f32 * (CELL + GAP) + below);
        let x = self.names + column as f32 * self.step;
        let size = vec2(self.step - slate.pts(GAP), slate.pts(CELL));
        Rect::from_min_size(origin + vec2(x, y), size)
    }
}

/// How much room the view wants on a slate; that for the result and the note is kept from the start.
fn wanted(slate: &Slate<'_>, bits: &Bits) -> Vec2 {
    let plan = Plan::of(slate, bits);
    let width = plan.width(slate, bits);
    let last = plan.cell(slate, pos2(0.0, 0.0), plan.n_rows, 0);
    let note = slate.pts(NOTE_GAP) + 2.0 * slate.pts(1.4 * NOTE_SIZE);
    vec2(width + slate.pts(6.0), last.bottom() + note)
}

impl OnSlate for Bits {
    fn slate<'a>(&self, painter: &'a Painter, look: Look<'a>, rect: Rect) -> Slate<'a> {
        let wanted = |slate: &Slate<'_>| wanted(slate, self);
        let mut slate = Slate::new(painter, look);
        slate.scale *= MOST_GROWN;
        // Digits are large: they can become smaller than other text, also where that is large.
        slate.shrunk_to(LEAST_SCALE, rect.size(), wanted)
    }

    fn draw(&self, slate: &mut Slate<'_>, rect: Rect, links: &mut Links) {
        draw(slate, rect, self, links);
    }

    fn spoken(&self, look: Look<'_>) -> String {
        spoken(look, self)
    }
}

fn draw(slate: &mut Slate<'_>, rect: Rect, bits: &Bits, links: &mut Links) {
    let plan = Plan::of(slate, bits);
    let origin = rect.min;
    header(slate, &plan, origin, bits);
    for (i, row) in bits.rows.iter().enumerate() {
        code(slate, &plan, origin, bits, (i, row), links);
    }
    let n = plan.n_rows;
    if let Some(result) = &bits.result {
        let first = plan.cell(slate, origin, n, 0);
        let y = (first.top() - slate.pts(RULE)).round() + 0.5;
        let line = [first.left(), origin.x + plan.width(slate, bits)];
        let stroke = slate.stroke(1.5, slate.theme().ink);
        slate.line(line.map(|x| pos2(x, y)), stroke);
        code(slate, &plan, origin, bits, (n, result), links);
    }
    if let Some(column) = bits.deciding {
        let last = n - usize::from(bits.result.is_none()).min(n);
        let [top, bottom] = [0, last].map(|row| plan.cell(slate, origin, row, column));
        let box_through = top.union(bottom).expand(slate.pts(5.0));
        let stroke = slate.stroke(2.25, slate.theme().signal);
        let kind = egui::StrokeKind::Middle;
        let corner = slate.pts(6.0);
        slate.painter.rect_stroke(box_through, corner, stroke, kind);
    }
    if let Some(note) = &bits.note {
        let bottom = plan.cell(slate, origin, n, 0).bottom();
        let at = pos2(origin.x, bottom + slate.pts(NOTE_GAP));
        let width = rect
            .width()
            .min(plan.width(slate, bits).max(slate.pts(320.0)));
        let style = (Face::Plain, NOTE_SIZE, slate.theme().soft);
        let note = slate.sentence(note, width, style);
        slate.put(&note, at, Align2::LEFT_TOP);
    }
}

fn header(slate: &mut Slate<'_>, plan: &Plan, origin: egui::Pos2, bits: &Bits) {
    let theme = slate.theme();
    for (column, title) in bits.columns.iter().enumerate() {
        let style = if bits.deciding == Some(column) {
            (Face::Strong, HEADER_SIZE, theme.signal_text)
        } else {
            (Face::Plain, HEADER_SIZE, theme.soft)
        };
        let title = slate.value(title, style);
        let cell = plan.cell(slate, origin, 0, column);
        let at = cell.center_top() - vec2(0.0, slate.pts(11.0));
        slate.put(&title, at, Align2::CENTER_BOTTOM);
    }
}

/// A row: its name, and a cell a column whether its bits are known or not.
fn code(
    slate: &mut Slate<'_>,
    plan: &Plan,
    origin: egui::Pos2,
    bits: &Bits,
    (nth, row): (usize, &BitRow),
    links: &mut Links,
) {
    let theme = slate.theme();
    let is_result = nth == plan.n_rows;
    let cells = (0..bits.columns.len()).map(|column| plan.cell(slate, origin, nth, column));
    let cells: Vec<Rect> = cells.collect();
    let Some((first, last)) = cells.first().zip(cells.last()) else {
        return;
    };
    let whole = first.union(*last).with_min_x(origin.x);
    let is_lit = links.touch(whole.expand(slate.pts(0.5 * GAP)), row.link);
    // Where no column decides, the code that was found at this step has a bar before it.
    let is_now = row.role == Role::Signal && bits.deciding.is_none();
    let name = match row.role {
        _ if is_lit => theme.accent,
        Role::Signal if is_now => theme.signal_text,
        Role::Ink | Role::Soft | Role::Faint | Role::Accent | Role::Signal => theme.ink,
        Role::Accepted | Role::Discarded => theme.soft,
    };
    let name = slate.value(&row.name, (Face::Strong, NAME_SIZE, name));
    slate.put(&name, whole.left_center(), Align2::LEFT_CENTER);
    if is_now {
        let bar = Rect::from_x_y_ranges(
            first.left() - slate.pts(6.0)..=first.left() - slate.pts(3.0),
            first.y_range(),
        );
        slate.painter.rect_filled(bar, 0.0, theme.signal);
    }
    for (column, place) in cells.into_iter().enumerate() {
        let is_deciding = bits.deciding == Some(column);
        let bit = row.bits.get(column).copied();
        let is_solid = is_deciding && is_result && bit == Some(true);
        let (fill, ink) = match bit {
            _ if is_solid => (theme.signal, theme.background),
            _ if is_deciding || is_now => (wash(theme, Role::Signal), theme.signal_text),
            _ if is_lit => (theme.accent_wash, theme.ink),
            _ => (theme.panel, theme.ink),
        };
        slate.painter.rect_filled(place, slate.pts(3.0), fill);
        let style = match bit {
            None => continue,
            Some(true) => (Face::Strong, DIGIT_SIZE, ink),
            Some(false) if is_deciding => (Face::Mono, DIGIT_SIZE, ink),
            Some(false) => (Face::Mono, DIGIT_SIZE, theme.soft),
        };
        let digit = slate.words(if bit == Some(true) { "1" } else { "0" }, style);
        slate.put(&digit, place.center(), Align2::CENTER_CENTER);
    }
}

/// `P₁: 1001; P₂: 1000; AND: 1000 (top). AND keeps a bit only where both have it.`
fn spoken(look: Look<'_>, bits: &Bits) -> String {
    let code = |row: &BitRow| {
        let digits = row.bits.iter().map(|&bit| if bit { '1' } else { '0' });
        let digits: String = digits.collect();
        let digits = if digits.is_empty() { "–" } else { &digits };
        format!("{}: {digits}", look.catalog.value(&row.name))
    };
    let rows: Vec<String> = bits.rows.iter().chain(&bits.result).map(code).collect();
    let mut said = rows.join("; ");
    if let Some(title) = bits.deciding.and_then(|column| bits.columns.get(column)) {
        said = format!("{said} ({})", look.catalog.value(title));
    }
    match &bits.note {
        Some(note) => format!("{said}. {}", look.catalog.message(note)),
        None => said,
    }
}
