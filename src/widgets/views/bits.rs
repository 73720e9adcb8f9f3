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

use crate::figure::{BitRow, Bits};

use super::prelude::*;

const CELL: f32 = 54.0;
const GAP: f32 = 9.0;
const HEADER: f32 = 30.0;
const RULE: f32 = 18.0;
const NOTE_GAP: f32 = 22.0;
const NAME_SIZE: f32 = 15.0;
const HEADER_SIZE: f32 = 12.5;
const NOTE_SIZE: f32 = 13.0;
const DIGIT_SIZE: f32 = 24.0;

struct Plan<'b> {
    bits: &'b Bits,
    origin: Pos2,
    names: f32,
    step: f32,
}

impl<'b> Plan<'b> {
    fn of(slate: &Slate<'_>, bits: &'b Bits, origin: Pos2) -> Self {
        let rows = bits.rows.iter().chain(&bits.result);
        let names = rows.map(|row| slate.width(&row.name, Face::Strong, NAME_SIZE));
        let titles = bits.columns.iter();
        let titles = titles.map(|title| slate.width(title, Face::Strong, HEADER_SIZE));
        let cell = titles.fold(slate.pts(CELL), f32::max);
        Self {
            bits,
            origin,
            names: names.fold(0.0, f32::max).max(slate.pts(32.0)) + slate.pts(20.0),
            step: cell + slate.pts(GAP),
        }
    }

    fn width(&self, slate: &Slate<'_>) -> f32 {
        self.names + self.bits.columns.len() as f32 * self.step - slate.pts(GAP)
    }

    fn cell(&self, slate: &Slate<'_>, row: usize, column: usize) -> Rect {
        let is_result = row == self.bits.rows.len();
        let below = if is_result { 2.0 * RULE - GAP } else { 0.0 };
        let y = slate.pts(HEADER + row as f32 * (CELL + GAP) + below);
        let x = self.names + column as f32 * self.step;
        let size = vec2(self.step - slate.pts(GAP), slate.pts(CELL));
        Rect::from_min_size(self.origin + vec2(x, y), size)
    }

    fn column(&self, slate: &Slate<'_>, column: usize) -> Rect {
        let last = self.bits.rows.len() - usize::from(self.bits.result.is_none());
        let cells = [0, last].map(|row| self.cell(slate, row, column));
        cells[0].union(cells[1])
    }

    fn code(&self, slate: &mut Slate<'_>, nth: usize, row: &BitRow, links: &mut Links) {
        let theme = slate.theme();
        let lit = self.bits.links.iter().position(|it| links.lit == Some(*it));
        let n_columns = self.bits.columns.len();
        let cells = (0..n_columns).map(|column| self.cell(slate, nth, column));
        let cells: Vec<Rect> = cells.collect();
        let Some((first, last)) = cells.first().zip(cells.last()) else {
            return;
        };
        let whole = first.union(*last).with_min_x(self.origin.x);
        let is_lit = links.touch(whole.expand(slate.pts(0.5 * GAP)), row.link);
        // Where no column decides, the code that was found at this step has a bar before it.
        let is_now = row.role == Role::Signal && self.bits.deciding.is_none();
        let name = match row.role {
            _ if is_lit => theme.accent,
            Role::Signal if is_now => theme.signal_text,
            Role::Ink | Role::Soft | Role::Faint | Role::Accent | Role::Signal => theme.ink,
            Role::Accepted | Role::Discarded => theme.soft,
        };
        let name = slate.value(&row.name, (Face::Strong, NAME_SIZE, name));
        slate.put(&name, whole.left_center(), Align2::LEFT_CENTER);
        if is_now {
            let x = first.left() - slate.pts(6.0)..=first.left() - slate.pts(3.0);
            let bar = Rect::from_x_y_ranges(x, first.y_range());
            slate.painter.rect_filled(bar, 0.0, theme.signal);
        }
        for (column, place) in cells.into_iter().enumerate() {
            let is_deciding = self.bits.deciding == Some(column);
            let bit = row.bits.get(column).copied();
            let is_result = nth == self.bits.rows.len();
            let (fill, ink) = match bit {
                Some(true) if is_deciding && is_result => (theme.signal, theme.background),
                // Of a code that is all zeros nothing stands out: it says that there is nothing.
                Some(true) if is_now => (wash(theme, Role::Signal), theme.signal_text),
                _ if is_deciding => (wash(theme, Role::Signal), theme.signal_text),
                _ if is_lit || lit == Some(column) => (theme.accent_wash, theme.ink),
                _ => (theme.panel, theme.ink),
            };
            slate.painter.rect_filled(place, slate.pts(3.0), fill);
            let (digit, face, ink) = match bit {
                None => continue,
                Some(true) => ("1", Face::Strong, ink),
                Some(false) if is_deciding => ("0", Face::Mono, ink),
                Some(false) => ("0", Face::Mono, theme.soft),
            };
            let digit = slate.words(digit, (face, DIGIT_SIZE, ink));
            slate.put(&digit, place.center(), Align2::CENTER_CENTER);
        }
    }
}

impl OnSlate for Bits {
    fn slate<'a>(&self, natural: Slate<'a>, room: Vec2) -> Slate<'a> {
        // Digits are large: they can become smaller than other text, also where that is large.
        natural.shrunk_to(LEAST_SCALE, room, |slate| {
            let plan = Plan::of(slate, self, Pos2::ZERO);
            // Room for the result and the note is kept from the start.
            let last = plan.cell(slate, self.rows.len(), 0);
            let note = slate.pts(NOTE_GAP) + 2.0 * slate.pts(1.4 * NOTE_SIZE);
            vec2(plan.width(slate) + slate.pts(6.0), last.bottom() + note)
        })
    }

    fn draw(&self, slate: &mut Slate<'_>, rect: Rect, links: &mut Links) {
        let plan = Plan::of(slate, self, rect.min);
        let theme = slate.theme();
        for (column, title) in self.columns.iter().enumerate() {
            let is_deciding = self.deciding == Some(column);
            let (soft, strong) = (theme.soft, theme.signal_text);
            let ink = if is_deciding { strong } else { soft };
            let title = slate.value(title, (Face::strong_if(is_deciding), HEADER_SIZE, ink));
            let at = plan.cell(slate, 0, column).center_top() - vec2(0.0, slate.pts(11.0));
            slate.put(&title, at, Align2::CENTER_BOTTOM);
        }
        for (i, row) in self.rows.iter().enumerate() {
            plan.code(slate, i, row, links);
        }
        // While a column is what might come, its cells are the column's and not the row's.
        for (column, link) in self.links.iter().enumerate() {
            let is_asked = links.chips.iter().any(|chip| chip.link == Some(*link));
            if is_asked {
                links.touch(plan.column(slate, column), Some(*link));
            }
        }
        let n = self.rows.len();
        if let Some(result) = &self.result {
            let first = plan.cell(slate, n, 0);
            let y = (first.top() - slate.pts(RULE)).round() + 0.5;
            let line = [first.left(), rect.min.x + plan.width(slate)];
            let stroke = slate.stroke(1.5, slate.theme().ink);
            slate.line(line.map(|x| pos2(x, y)), stroke);
            plan.code(slate, n, result, links);
        }
        if let Some(column) = self.deciding {
            let last = n - usize::from(self.result.is_none()).min(n);
            let [top, bottom] = [0, last].map(|row| plan.cell(slate, row, column));
            let box_through = top.union(bottom).expand(slate.pts(5.0));
            let stroke = slate.stroke(2.25, slate.theme().signal);
            slate.rim(box_through, slate.pts(6.0), stroke, StrokeKind::Middle);
        }
        if let Some(note) = &self.note {
            let bottom = plan.cell(slate, n, 0).bottom();
            let at = pos2(rect.min.x, bottom + slate.pts(NOTE_GAP));
            let most = plan.width(slate).max(slate.pts(320.0));
            let style = (Face::Plain, NOTE_SIZE, slate.theme().soft);
            let note = slate.sentence(note, rect.width().min(most), style);
            slate.put(&note, at, Align2::LEFT_TOP);
        }
    }

    /// `P₁: 1001; P₂: 1000; AND: 1000 (top). AND keeps a bit only where both have it.`
    fn spoken(&self, look: Look<'_>) -> String {
        let code = |row: &BitRow| {
            let digits = row.bits.iter().map(|&bit| if bit { '1' } else { '0' });
            let digits: String = digits.collect();
            let digits = if digits.is_empty() { "–" } else { &digits };
            format!("{}: {digits}", look.catalog.value(&row.name))
        };
        let rows = joined(self.rows.iter().chain(&self.result).map(code), "; ");
        let deciding = self.deciding.and_then(|column| self.columns.get(column));
        let deciding = deciding.into_iter().map(|title| look.catalog.value(title));
        let said = bracketed(&rows, deciding);
        match &self.note {
            Some(note) => format!("{said}. {}", look.catalog.message(note)),
            None => said,
        }
    }
}
