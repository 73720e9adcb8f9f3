//! Rows and columns of values. Every row is always there; the step's has a wash and a bar at its left.
//!
//! Numbers stand to the right of their column, under a symbol; words to the left, under a word or nothing.

use std::{borrow::Cow, cell::RefCell};

use crate::{
    figure::{Table, TableNote, TableRow},
    text::Token,
};

use super::prelude::*;

const SIZE: f32 = 14.0;
const NOTE_SIZE: f32 = 13.0;
const FOLD_SIZE: f32 = 12.0;
const PAD: f32 = 12.0;
const GAPS: [f32; 2] = [14.0, 32.0];
const AIR: [f32; 2] = [1.0, 12.0];
const NOTE_GAP: f32 = 14.0;
const LEAST_ROWS: usize = 3;
const FOLD_BELOW: f32 = 0.8;

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
    fn of(slate: &Slate<'_>, table: &Table, room: f32) -> Self {
        let ink = slate.theme().ink;
        let titles = table.header.iter();
        let title = |title: &Formula| slate.formula(title, (Face::Strong, SIZE, ink)).size();
        let titles: Vec<Vec2> = titles.map(title).collect();
        let short = slate.words("−0.88", (Face::Plain, SIZE, ink)).size().x;
        let sizes = titles.iter().enumerate();
        let columns = sizes.map(|(idx, title)| column(slate, table, idx, [title.x, short]));
        let number = |x: f64| Formula::default().num(x);
        let fraction = Formula::default().over(number(3.0), number(8.0));
        let fraction = slate.formula(&fraction, (Face::Strong, SIZE, ink)).size().y;
        let row = fraction.max(slate.pts(1.9 * SIZE));
        Self {
            columns: columns.collect(),
            row: titles.iter().map(|title| title.y).fold(row, f32::max),
            notes: notes_height(slate, table, room - 2.0 * slate.pts(PAD)),
        }
    }

    /// Of so many rows under their titles, as low as they can be.
    fn height(&self, slate: &Slate<'_>, n_rows: usize) -> f32 {
        (self.row + 2.0 * slate.pts(AIR[0])) * (n_rows + 1) as f32
    }

    fn width(&self, slate: &Slate<'_>, gap: f32) -> f32 {
        let text: f32 = self.columns.iter().map(|column| column.width).sum();
        let n_gaps = self.columns.len().saturating_sub(1) as f32;
        text + n_gaps * slate.pts(gap) + 2.0 * slate.pts(PAD)
    }

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

fn is_word(title: &Formula) -> bool {
    title.0.iter().all(|token| matches!(token, Token::Term(_)))
}

/// As wide as what stands in it; one of numbers as a short one at least, so that it stays where it is when one comes.
fn column(slate: &Slate<'_>, table: &Table, idx: usize, [title, short]: [f32; 2]) -> Column {
    let values = table.rows.iter().filter_map(|row| match idx {
        0 => Some(&row.name),
        _ => row.cells.get(idx - 1)?.value.as_ref(),
    });
    let widths = values.map(|value| slate.width(value, Face::Strong, SIZE));
    let heading = &table.header[idx];
    let least = if heading.0.is_empty() { 0.0 } else { short };
    Column {
        width: widths.fold(least.max(title), f32::max),
        is_words: idx == 0 || is_word(heading),
    }
}

fn notes_height(slate: &Slate<'_>, table: &Table, width: f32) -> f32 {
    if table.notes.is_empty() {
        return 0.0;
    }
    let style = (Face::Plain, NOTE_SIZE, slate.theme().ink);
    let height = |note: &TableNote| slate.sentence(&note.text, width, style).size().y;
    slate.pts(NOTE_GAP) + table.notes.iter().map(height).sum::<f32>()
}

/// Where text may not be so small that all columns have room: without the widest of words, as long as that is needed. With how
/// that stands at the slate's scale.
fn planned<'t>(slate: &Slate<'_>, table: &'t Table, width: f32) -> (Cow<'t, Table>, Plan) {
    let whole = Plan::of(slate, table, width);
    let least = Slate {
        scale: slate.theme().least_text / SIZE,
        ..Slate::new(slate.painter, slate.look)
    };
    let has_room = slate.scale >= least.scale && whole.width(slate, GAPS[0]) <= width;
    if least.scale == 0.0 || has_room || !table.header.iter().skip(1).any(is_word) {
        return (Cow::Borrowed(table), whole);
    }
    let mut trimmed = Cow::Borrowed(table);
    let widest = |table: &Table| {
        let plan = Plan::of(&least, table, width);
        let columns = plan.columns.iter().enumerate().skip(1);
        let words = columns.filter(|(_, column)| column.is_words);
        let widest = words.max_by(|(_, a), (_, b)| a.width.total_cmp(&b.width));
        let widest = widest.filter(|_| plan.width(&least, GAPS[0]) > width);
        widest.map(|(widest, _)| widest)
    };
    while let Some(widest) = widest(&trimmed) {
        let table = trimmed.to_mut();
        table.header.remove(widest);
        let rows = table.rows.iter_mut();
        for row in rows.filter(|row| widest <= row.cells.len()) {
            row.cells.remove(widest - 1);
        }
    }
    let plan = match &trimmed {
        Cow::Borrowed(_) => whole,
        Cow::Owned(trimmed) => Plan::of(slate, trimmed, width),
    };
    (trimmed, plan)
}

impl OnSlate for Table {
    fn slate<'a>(&self, natural: Slate<'a>, room: Vec2) -> Slate<'a> {
        let fold_below = FOLD_BELOW * natural.scale;
        let (table, plan) = planned(&natural, self, room.x);
        // What has been measured last, and at which scale.
        let measured = RefCell::new((natural.scale, plan));
        let wanted = |slate: &Slate<'_>| {
            let mut measured = measured.borrow_mut();
            if measured.0 != slate.scale {
                *measured = (slate.scale, Plan::of(slate, &table, room.x));
            }
            let plan = &measured.1;
            let height = |n_rows: usize| plan.height(slate, n_rows) + plan.notes;
            // Rows are folded before their text becomes too small.
            let mut n_rows = self.rows.len();
            if room.y / height(n_rows) * slate.scale < fold_below {
                n_rows = n_rows.min(LEAST_ROWS);
            }
            vec2(plan.width(slate, GAPS[0]), height(n_rows))
        };
        let slate = natural.fitted_in(room, wanted);
        // Rows that have no room are folded; a column that had none would be cut.
        slate.shrunk_to(LEAST_SCALE, vec2(room.x, f32::INFINITY), wanted)
    }

    fn draw(&self, slate: &mut Slate<'_>, rect: Rect, links: &mut Links) {
        let text_width = rect.width() - 2.0 * slate.pts(PAD);
        let (table, mut plan) = planned(slate, self, rect.width());
        // Notes go before rows are folded.
        if plan.height(slate, self.rows.len()) + plan.notes > rect.height() {
            plan.notes = 0.0;
        }
        let width = rect.width().min(plan.width(slate, GAPS[1]));
        let rect = Rect::from_min_size(rect.min, vec2(width, rect.height()));
        let edges = plan.edges(slate, rect);
        let room = rect.height() - plan.notes;
        let [least, most] = AIR.map(|air| plan.row + 2.0 * slate.pts(air));
        let n_fit = ((room / least + 0.01) as usize).saturating_sub(1);
        let focus = self.rows.iter().position(|row| row.is_current);
        let fold = Fold::about(self.rows.len(), focus, n_fit.max(LEAST_ROWS));
        let step = (room / (fold.n_rows() + 1) as f32)
            .clamp(least, most)
            .floor();
        let place = |nth: usize| {
            let top = rect.top() + nth as f32 * step;
            Rect::from_min_size(pos2(rect.left(), top), vec2(width, step))
        };
        header(slate, place(0), &table, &edges);
        for idx in fold.shown.clone() {
            let nth = idx - fold.shown.start + fold.first_row() + 1;
            row(slate, place(nth), &table.rows[idx], (&plan, &edges), links);
        }
        for (count, nth) in [(fold.before, 1), (fold.after, fold.n_rows())] {
            if count > 0 {
                let words = slate.more(count, FOLD_SIZE);
                let at = place(nth).left_center() + vec2(slate.pts(PAD), 0.0);
                slate.put(&words, at, Align2::LEFT_CENTER);
            }
        }
        let mut y = place(fold.n_rows()).bottom() + slate.pts(NOTE_GAP);
        for note in self.notes.iter().filter(|_| plan.notes > 0.0) {
            let theme = slate.theme();
            let ink = if note.applies { theme.ink } else { theme.soft };
            let lines = slate.sentence(&note.text, text_width, (Face::Plain, NOTE_SIZE, ink));
            let at = pos2(rect.left() + slate.pts(PAD), y);
            y = slate.put(&lines, at, Align2::LEFT_TOP).bottom();
        }
    }

    /// `edge, p, q; → left: p = −8, q = −3; …`.
    fn spoken(&self, look: Look<'_>) -> String {
        let said = |value: &Value| look.catalog.value(value);
        let titles = self.header.iter().map(|title| look.catalog.formula(title));
        let titles: Vec<String> = titles.collect();
        let row = |row: &TableRow| {
            let cells = row.cells.iter().zip(titles.iter().skip(1));
            let cells = cells.filter_map(|(cell, title)| {
                let value = said(cell.value.as_ref()?);
                let is_bare = title.is_empty();
                Some(if is_bare {
                    value
                } else {
                    format!("{title}: {value}")
                })
            });
            let (arrow, name) = (now(row.is_current), said(&row.name));
            format!("{arrow}{name} {}", joined(cells, ", "))
        };
        let notes = self.notes.iter().filter(|note| note.applies);
        let notes = notes.map(|note| look.catalog.message(&note.text));
        joined(self.rows.iter().map(row).chain(notes), "; ")
    }
}

fn header(slate: &mut Slate<'_>, place: Rect, table: &Table, edges: &[f32]) {
    let theme = slate.theme();
    for (idx, (title, &edge)) in table.header.iter().zip(edges).enumerate() {
        let is_word = is_word(title);
        let ink = if is_word { theme.soft } else { theme.ink };
        let title = slate.formula(title, (Face::strong_if(!is_word), SIZE, ink));
        let at = pos2(edge, place.center().y);
        slate.put(&title, at, align(idx == 0 || is_word));
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
    let corner = slate.pts(2.0);
    if row.is_current {
        let bar = place.with_max_x(place.left() + slate.pts(3.0));
        let tint = wash(theme, Role::Signal);
        slate.painter.rect_filled(place, corner, tint);
        slate.painter.rect_filled(bar, 0.0, theme.signal);
    } else if is_lit {
        let tint = theme.accent_wash;
        slate.painter.rect_filled(place, corner, tint);
    }
    let at = |edge: f32| pos2(edge, place.center().y);
    let name = (Face::strong_if(row.is_current), SIZE, theme.ink);
    let name = slate.value(&row.name, name);
    if let Some(&edge) = edges.first() {
        slate.put(&name, at(edge), Align2::LEFT_CENTER);
    }
    let columns = edges.iter().zip(&plan.columns).skip(1);
    for (cell, (&edge, column)) in row.cells.iter().zip(columns) {
        if let Some(value) = &cell.value {
            // What was worked out at this step, or has changed, also weighs more.
            let face = Face::strong_if(cell.strong || cell.role == Role::Signal);
            let style = (face, SIZE, text_colour(theme, cell.role));
            let value = slate.value(value, style);
            slate.put(&value, at(edge), align(column.is_words));
        }
    }
}
