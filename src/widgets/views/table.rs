//! Rows and columns of values. Every row is always there; the step's has a wash and a bar at its left.
//!
//! Numbers stand to the right of their column, under a symbol; words to the left, under a word or nothing.

use egui::{Align2, Painter, Rect, Stroke, pos2, vec2};

use crate::{
    figure::{Cell, Role, Table, TableRow},
    text::{Formula, Message, Notation, Piece, Token, Value},
};

use super::super::look::Look;
use super::{
    fold::Fold,
    on_slate::{Links, OnSlate},
    slate::{Face, LEAST_SCALE, Slate, Style, text_colour, wash},
};

const SIZE: f32 = 14.0;
const NOTE_SIZE: f32 = 13.0;
const FOLD_SIZE: f32 = 12.0;
/// White space left of the names and right of the last column.
const PAD: f32 = 12.0;
/// White space between two columns: the least, and the most.
const GAPS: [f32; 2] = [14.0, 40.0];
/// White space above and below what stands in a row: the least, and the most.
const AIR: [f32; 2] = [1.0, 6.0];
/// Between rows and notes.
const NOTE_GAP: f32 = 14.0;
/// Fewer rows than this are not shown, however little room there is.
const LEAST_ROWS: usize = 3;
/// Above this scale text shrinks; below it rows are folded.
const FOLD_BELOW: f32 = 0.8;

/// Numbers in a column, and in its neighbours, are compared: all of them are fractions, or all decimals.
fn notation(table: &Table) -> Notation {
    let cells = table.rows.iter().flat_map(|row| &row.cells);
    let notes = table.notes.iter().flat_map(|note| &note.text.args);
    let cells = cells.filter_map(|cell| cell.value.as_ref());
    Notation::of(cells.chain(notes.map(|(_, value)| value)))
}

/// A column: its width at a slate's scale, and to which side things stand in it.
struct Column {
    width: f32,
    is_words: bool,
}

struct Plan {
    columns: Vec<Column>,
    /// What a stacked fraction takes: every row has room for one.
    row: f32,
    notes: f32,
}

impl Plan {
    fn of(slate: &Slate<'_>, table: &Table, width: f32) -> Self {
        let columns = table.header.iter().enumerate();
        Self {
            columns: columns
                .map(|(i, title)| column(slate, table, i, title))
                .collect(),
            row: row_height(slate, table),
            notes: notes_height(slate, table, width),
        }
    }

    fn width(&self, slate: &Slate<'_>, gap: f32) -> f32 {
        let text: f32 = self.columns.iter().map(|column| column.width).sum();
        let n_gaps = self.columns.len().saturating_sub(1) as f32;
        text + n_gaps * slate.pts(gap) + 2.0 * slate.pts(PAD)
    }

    /// The edges at which the columns' text stands: the left one of words, the right one of numbers.
    fn edges(&self, slate: &Slate<'_>, rect: Rect) -> Vec<f32> {
        let n_gaps = self.columns.len().saturating_sub(1).max(1) as f32;
        let spare = rect.width() - self.width(slate, 0.0);
        let gap = (spare / n_gaps).clamp(0.0, slate.pts(GAPS[1]));
        let mut left = rect.left() + slate.pts(PAD);
        let edge = |column: &Column| {
            let right = left + column.width;
            let edge = if column.is_words { left } else { right };
            left = right + gap;
            edge
        };
        self.columns.iter().map(edge).collect()
    }
}

/// As wide as what stands in it; one of numbers as a short one at least, so that it stays where it is when one comes.
fn column(slate: &Slate<'_>, table: &Table, idx: usize, title: &Formula) -> Column {
    let ink = slate.theme().ink;
    let is_words = idx == 0 || title.0.iter().all(|token| matches!(token, Token::Term(_)));
    let width = |value: &Value| slate.value(value, (Face::Strong, SIZE, ink)).size().x;
    let least = match title.0[..] {
        [] => 0.0,
        _ => slate.words("−0.88", (Face::Plain, SIZE, ink)).size().x,
    };
    let title = slate.formula(title, (Face::Strong, SIZE, ink)).size().x;
    let values = table.rows.iter().filter_map(|row| match idx {
        0 => Some(&row.name),
        _ => row.cells.get(idx - 1)?.value.as_ref(),
    });
    Column {
        width: values.map(width).fold(least.max(title), f32::max),
        is_words,
    }
}

/// Room for a stacked fraction in every row, for the titles above them.
fn row_height(slate: &Slate<'_>, table: &Table) -> f32 {
    let fraction =
        Formula::default().over(Formula::default().num(3.0), Formula::default().num(8.0));
    let style = (Face::Strong, SIZE, slate.theme().ink);
    let height = |formula: &Formula| slate.formula(formula, style).size().y;
    let titles = table.header.iter().map(height);
    titles.fold(height(&fraction).max(slate.pts(1.9 * SIZE)), f32::max)
}

fn notes_height(slate: &Slate<'_>, table: &Table, width: f32) -> f32 {
    if table.notes.is_empty() {
        return 0.0;
    }
    let heights = table.notes.iter().map(|note| {
        let style = (Face::Plain, NOTE_SIZE, slate.theme().ink);
        slate.sentence(&note.text, width, style).size().y
    });
    slate.pts(NOTE_GAP) + heights.sum::<f32>()
}

impl OnSlate for Table {
    fn slate<'a>(&self, painter: &'a Painter, look: Look<'a>, rect: Rect) -> Slate<'a> {
        let room = rect.size();
        let n_rows = self.rows.len();
        let slate = Slate::with_numbers(painter, look, notation(self));
        let plan_of = |slate: &Slate<'_>| Plan::of(slate, self, room.x - 2.0 * slate.pts(PAD));
        let slate = slate.fitted_in(room, |slate| {
            let plan = plan_of(slate);
            let row = plan.row + 2.0 * slate.pts(AIR[0]);
            let height = |n_rows: usize| row * (n_rows + 1) as f32 + plan.notes;
            // Rows are folded before their text becomes too small.
            let would_be = room.y / height(n_rows) * slate.scale;
            let folds = would_be < FOLD_BELOW * look.theme.text_scale;
            let n_rows = if folds {
                n_rows.min(LEAST_ROWS)
            } else {
                n_rows
            };
            vec2(plan.width(slate, GAPS[0]), height(n_rows))
        });
        // Rows that have no room are folded; a column that had none would be cut.
        slate.shrunk_to(LEAST_SCALE, vec2(room.x, f32::INFINITY), |slate| {
            vec2(plan_of(slate).width(slate, GAPS[0]), 1.0)
        })
    }

    fn draw(&self, slate: &mut Slate<'_>, rect: Rect, links: &mut Links) {
        draw(slate, rect, self, links);
    }

    fn spoken(&self, look: Look<'_>) -> String {
        spoken(look, self)
    }
}

fn draw(slate: &mut Slate<'_>, rect: Rect, table: &Table, links: &mut Links) {
    let text_width = rect.width() - 2.0 * slate.pts(PAD);
    let plan = Plan::of(slate, table, text_width);
    let width = rect.width().min(plan.width(slate, GAPS[1]));
    let rect = Rect::from_min_size(rect.min, vec2(width, rect.height()));
    let edges = plan.edges(slate, rect);
    let room = rect.height() - plan.notes;
    let least = plan.row + 2.0 * slate.pts(AIR[0]);
    let n_fit = ((room / least + 0.01) as usize)
        .saturating_sub(1)
        .max(LEAST_ROWS);
    let focus = table.rows.iter().position(|row| row.is_current);
    let fold = Fold::about(table.rows.len(), focus, n_fit);
    let most = plan.row + 2.0 * slate.pts(AIR[1]);
    let step = (room / (fold.n_rows() + 1) as f32)
        .clamp(least, most)
        .floor();
    let place = |nth: usize| {
        let top = rect.top() + nth as f32 * step;
        Rect::from_min_size(pos2(rect.left(), top), vec2(width, step))
    };
    header(slate, place(0), table, &edges);
    if fold.before > 0 {
        folded(slate, place(1), fold.before);
    }
    for idx in fold.shown.clone() {
        let nth = idx - fold.shown.start + fold.first_row() + 1;
        row(slate, place(nth), &table.rows[idx], (&plan, &edges), links);
    }
    if fold.after > 0 {
        folded(slate, place(fold.n_rows()), fold.after);
    }
    let mut y = place(fold.n_rows()).bottom() + slate.pts(NOTE_GAP);
    for note in &table.notes {
        let theme = slate.theme();
        let ink = if note.applies { theme.ink } else { theme.soft };
        let lines = slate.sentence(&note.text, text_width, (Face::Plain, NOTE_SIZE, ink));
        let at = pos2(rect.left() + slate.pts(PAD), y);
        y = slate.put(&lines, at, Align2::LEFT_TOP).bottom();
    }
}

fn header(slate: &mut Slate<'_>, place: Rect, table: &Table, edges: &[f32]) {
    let theme = slate.theme();
    for (idx, (title, &edge)) in table.header.iter().zip(edges).enumerate() {
        let is_word = title.0.iter().all(|token| matches!(token, Token::Term(_)));
        let style: Style = if is_word {
            (Face::Plain, SIZE, theme.soft)
        } else {
            (Face::Strong, SIZE, theme.ink)
        };
        let title = slate.formula(title, style);
        let align = align(idx == 0 || is_word);
        slate.put(&title, pos2(edge, place.center().y), align);
    }
    let y = place.bottom().round() - 0.5;
    let stroke = Stroke::new(1.0, theme.hairline);
    slate.line([place.left(), place.right()].map(|x| pos2(x, y)), stroke);
}

const fn align(is_words: bool) -> Align2 {
    if is_words {
        Align2::LEFT_CENTER
    } else {
        Align2::RIGHT_CENTER
    }
}

fn row(
    slate: &mut Slate<'_>,
    place: Rect,
    row: &TableRow,
    (plan, edges): (&Plan, &[f32]),
    links: &mut Links,
) {
    let theme = slate.theme();
    let is_lit = links.touch(place, row.link);
    if row.is_current {
        let bar = place.with_max_x(place.left() + slate.pts(3.0));
        let tint = wash(theme, Role::Signal);
        slate.painter.rect_filled(place, slate.pts(2.0), tint);
        slate.painter.rect_filled(bar, 0.0, theme.signal);
    } else if is_lit {
        slate
            .painter
            .rect_filled(place, slate.pts(2.0), theme.accent_wash);
    }
    let at = |edge: f32| pos2(edge, place.center().y);
    let face = if row.is_current {
        Face::Strong
    } else {
        Face::Plain
    };
    let name = slate.value(&row.name, (face, SIZE, theme.ink));
    if let Some(&edge) = edges.first() {
        slate.put(&name, at(edge), Align2::LEFT_CENTER);
    }
    for (nth, cell) in row.cells.iter().enumerate() {
        let (Some(&edge), Some(column)) = (edges.get(nth + 1), plan.columns.get(nth + 1)) else {
            break;
        };
        if let Some(value) = &cell.value {
            let value = slate.value(value, (face_of(cell), SIZE, text_colour(theme, cell.role)));
            slate.put(&value, at(edge), align(column.is_words));
        }
    }
}

/// What was worked out at this step, or has changed, also weighs more.
const fn face_of(cell: &Cell) -> Face {
    if cell.strong || matches!(cell.role, Role::Signal) {
        Face::Strong
    } else {
        Face::Plain
    }
}

fn folded(slate: &mut Slate<'_>, place: Rect, count: usize) {
    let words = slate.look.catalog.message(&more(count));
    let words = slate.words(words, (Face::Plain, FOLD_SIZE, slate.theme().soft));
    let at = place.left_center() + vec2(slate.pts(PAD), 0.0);
    slate.put(&words, at, Align2::LEFT_CENTER);
}

/// `… 37 more`.
pub fn more(count: usize) -> Message {
    Message::new("view-more").with("count", count)
}

/// `edge, p, q; → left: p = −8, q = −3; …`.
fn spoken(look: Look<'_>, table: &Table) -> String {
    let notation = notation(table);
    let said = |value: &Value| look.catalog.value_as(value, notation);
    let titles: Vec<String> = table
        .header
        .iter()
        .map(|title| look.catalog.formula(title))
        .collect();
    let row = |row: &TableRow| {
        let arrow = if row.is_current { "→ " } else { "" };
        let cells = row.cells.iter().zip(titles.iter().skip(1));
        let cells = cells.filter_map(|(cell, title)| {
            let value = said(cell.value.as_ref()?);
            Some(if title.is_empty() {
                value
            } else {
                format!("{title}: {value}")
            })
        });
        let cells: Vec<String> = cells.collect();
        format!("{arrow}{} {}", said(&row.name), cells.join(", "))
    };
    let notes = table.notes.iter().filter(|note| note.applies);
    let notes =
        notes.map(|note| Piece::plain(&look.catalog.message_pieces_as(&note.text, notation)));
    let parts: Vec<String> = table.rows.iter().map(row).chain(notes).collect();
    parts.join("; ")
}
