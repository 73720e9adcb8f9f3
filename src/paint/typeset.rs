//! Text set for reading: quotients stacked, subscripts lowered. It is a galley: selected, and copied as plain text.

mod row;
mod script;

use std::{ops::Range, sync::Arc};

use egui::{Align2, Color32, FontId, Galley, Painter, Pos2, Rect, Vec2, pos2, vec2};

use crate::text::Piece;

use row::SetRow;
use script::{Script, break_rows};

pub use script::Span;

#[derive(Clone)]
pub struct Typeset {
    galley: Arc<Galley>,
    baseline: f32,
    colour: Color32,
}

impl Typeset {
    pub fn text(painter: &Painter, text: impl AsRef<str>, font: FontId, colour: Color32) -> Self {
        Self::line(painter, &[Span::text(text.as_ref(), font, colour)])
    }

    pub fn line(painter: &Painter, spans: &[Span]) -> Self {
        let script = Script::new(spans);
        let row = SetRow::new(painter, &script, 0..script.chars.len());
        Self::of_rows(&[row], &script)
    }

    /// No line breaks within a coordinate, a formula or a term that fits on one; a longer one breaks before a relation.
    pub fn wrapped(painter: &Painter, spans: &[Span], width: f32) -> Self {
        let script = Script::new(spans);
        Self::of_rows(&wrapped(painter, &script, width), &script)
    }

    /// Running text: the same on lines that are at least so high. A line feed begins another line.
    pub fn running(painter: &Painter, spans: &[Span], width: f32, line_height: f32) -> Self {
        let mut rows = Vec::new();
        for line in lines(spans) {
            rows.extend(wrapped(painter, &Script::new(&line), width));
            if let Some(last) = rows.last_mut() {
                last.ends_line = true;
            }
        }
        if let Some(last) = rows.last_mut() {
            last.ends_line = false;
        }
        let mut galley = joined(&rows, line_height);
        // A space at the end of a line takes no room.
        galley.rect.max.x = galley.rect.max.x.min(width);
        Self {
            galley: Arc::new(galley),
            ..Self::of_rows(&rows[..1], &Script::new(spans))
        }
    }

    fn of_rows(rows: &[SetRow], script: &Script) -> Self {
        let first = script.spans.first();
        let colour = first.map_or(Color32::PLACEHOLDER, |span| span.colour);
        let baseline = rows.first().map_or(0.0, |row| row.baseline);
        let galley = match rows {
            [row] => row.galley.clone(),
            _ => Arc::new(joined(rows, 0.0)),
        };
        Self {
            galley,
            baseline,
            colour,
        }
    }

    /// In points. The capitals of one line are in the middle of its height, with a quotient as without.
    pub fn size(&self) -> Vec2 {
        self.galley.size()
    }

    pub const fn baseline(&self) -> f32 {
        self.baseline
    }

    /// Where the characters of a part stand, a box a row; they are counted over all spans, without the marks of subscripts and the
    /// ends of lines.
    pub fn boxes(&self, part: Range<usize>) -> Vec<Rect> {
        let mut first = 0;
        let mut boxes = Vec::new();
        for placed in &self.galley.rows {
            let glyphs = &placed.row.glyphs;
            let own = part.start.max(first)..part.end.min(first + glyphs.len());
            if own.start < own.end {
                let (from, to) = (&glyphs[own.start - first], &glyphs[own.end - 1 - first]);
                let right = to.pos.x + to.advance_width;
                let left = placed.pos + vec2(from.pos.x, 0.0);
                let size = vec2(right - from.pos.x, placed.row.size.y);
                boxes.push(Rect::from_min_size(left, size));
            }
            first += glyphs.len();
        }
        boxes
    }

    pub fn n_rows(&self) -> usize {
        self.galley.rows.len()
    }

    pub fn galley(&self) -> Arc<Galley> {
        self.galley.clone()
    }

    /// Paints it with this corner, edge or middle of its box at `at`; the box.
    pub fn paint(&self, painter: &Painter, at: Pos2, align: Align2) -> Rect {
        self.paint_in(painter, at, align, self.colour)
    }

    pub fn paint_in(&self, painter: &Painter, at: Pos2, align: Align2, colour: Color32) -> Rect {
        let rect = align.anchor_size(at, self.size());
        painter.galley(rect.min, self.galley.clone(), colour);
        rect
    }
}

fn wrapped(painter: &Painter, script: &Script, width: f32) -> Vec<SetRow> {
    let whole = SetRow::new(painter, script, 0..script.chars.len());
    let rows = break_rows(&script.chars, &whole.places, width);
    if rows.len() < 2 {
        return vec![whole];
    }
    let set = |row| SetRow::new(painter, script, row);
    rows.into_iter().map(set).collect()
}

fn lines(spans: &[Span]) -> Vec<Vec<Span>> {
    let (mut lines, mut line) = (Vec::new(), Vec::new());
    for span in spans {
        let text = Piece::plain(&span.pieces);
        for (i, part) in text.split('\n').enumerate() {
            if i > 0 {
                lines.push(std::mem::take(&mut line));
            }
            line.push(Span {
                pieces: Piece::words(part),
                ..span.clone()
            });
        }
    }
    lines.push(line);
    lines
}

fn joined(rows: &[SetRow], least: f32) -> Galley {
    let mut whole = (*rows[0].galley).clone();
    let mut job = (*whole.job).clone();
    whole.rows.clear();
    whole.rect = Rect::ZERO;
    whole.mesh_bounds = Rect::NOTHING;
    (whole.num_vertices, whole.num_indices) = (0, 0);
    job.text.clear();
    job.sections.clear();
    let mut top = 0.0;
    for row in rows {
        for section in &row.galley.job.sections {
            let mut section = section.clone();
            section.byte_range =
                section.byte_range.start + job.text.len()..section.byte_range.end + job.text.len();
            job.sections.push(section);
        }
        job.text.push_str(&row.galley.job.text);
        if row.ends_line {
            job.text.push('\n');
        }
        for placed in &row.galley.rows {
            let mut placed = placed.clone();
            let leading = (least - placed.row.size.y).max(0.0);
            placed.pos = pos2(placed.pos.x, top + (0.5 * leading).round());
            placed.ends_with_newline = row.ends_line;
            whole.rect |= placed.rect();
            let bounds = placed.visuals.mesh_bounds.translate(placed.pos.to_vec2());
            whole.mesh_bounds |= bounds;
            whole.num_vertices += placed.visuals.mesh.vertices.len();
            whole.num_indices += placed.visuals.mesh.indices.len();
            top += placed.row.size.y + leading;
            whole.rows.push(placed);
        }
    }
    whole.job = Arc::new(job);
    whole
}

#[cfg(test)]
mod tests;
