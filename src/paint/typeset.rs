//! Values, formulas and sentences set for reading: quotients stacked, subscripts lowered, on one line or on
//! lines of a given width. What is set is a galley, so that it can be selected, and copied as plain text.

mod breaks;
mod row;
mod script;
mod span;

use std::sync::Arc;

use egui::{Align2, Color32, FontId, Galley, Painter, Pos2, Rect, Vec2, pos2};

use crate::text::{Catalog, Formula, Message, Value};

use row::SetRow;
use script::Script;

pub use span::Span;

/// Text that has been laid out.
#[derive(Clone)]
pub struct Typeset {
    galley: Arc<Galley>,
    baseline: f32,
    colour: Color32,
}

impl Typeset {
    /// A value as it stands alone: in a table, beside a mark.
    #[must_use]
    pub fn value(
        painter: &Painter,
        catalog: &Catalog,
        value: &Value,
        font: FontId,
        colour: Color32,
    ) -> Self {
        Self::line(painter, &[Span::value(catalog, value, font, colour)])
    }

    /// A formula.
    #[must_use]
    pub fn formula(
        painter: &Painter,
        catalog: &Catalog,
        formula: &Formula,
        font: FontId,
        colour: Color32,
    ) -> Self {
        Self::line(painter, &[Span::formula(catalog, formula, font, colour)])
    }

    /// A sentence on one line.
    #[must_use]
    pub fn message(
        painter: &Painter,
        catalog: &Catalog,
        message: &Message,
        font: FontId,
        colour: Color32,
    ) -> Self {
        Self::line(painter, &[Span::message(catalog, message, font, colour)])
    }

    /// Words.
    #[must_use]
    pub fn text(painter: &Painter, text: impl AsRef<str>, font: FontId, colour: Color32) -> Self {
        Self::line(painter, &[Span::text(text.as_ref(), font, colour)])
    }

    /// Spans after each other on one line.
    #[must_use]
    pub fn line(painter: &Painter, spans: &[Span]) -> Self {
        let script = Script::new(spans);
        let row = SetRow::new(painter, &script, 0..script.chars.len());
        Self::of_rows(&[row], &script)
    }

    /// Spans after each other on lines of at most this width. A line does not break within a coordinate, a
    /// formula or a term that fits on one; where a formula does not, it goes on before a relation.
    #[must_use]
    pub fn wrapped(painter: &Painter, spans: &[Span], width: f32) -> Self {
        let script = Script::new(spans);
        let whole = SetRow::new(painter, &script, 0..script.chars.len());
        let rows = breaks::rows(&script.chars, &whole.places, width);
        if rows.len() < 2 {
            return Self::of_rows(&[whole], &script);
        }
        let rows: Vec<SetRow> = rows
            .into_iter()
            .map(|row| SetRow::new(painter, &script, row))
            .collect();
        Self::of_rows(&rows, &script)
    }

    fn of_rows(rows: &[SetRow], script: &Script) -> Self {
        let colour = script
            .spans
            .first()
            .map_or(Color32::PLACEHOLDER, |span| span.colour);
        let baseline = rows.first().map_or(0.0, |row| row.baseline);
        let galley = match rows {
            [row] => row.galley.clone(),
            _ => Arc::new(joined(rows)),
        };
        Self {
            galley,
            baseline,
            colour,
        }
    }

    /// Of the box around it, in points. What is set on one line has its capitals in the middle of its height,
    /// with a quotient as without.
    #[must_use]
    pub fn size(&self) -> Vec2 {
        self.galley.size()
    }

    /// From the top of the box to the line that the letters of the first row stand on.
    #[must_use]
    pub const fn baseline(&self) -> f32 {
        self.baseline
    }

    /// How many lines it takes.
    #[must_use]
    pub fn n_rows(&self) -> usize {
        self.galley.rows.len()
    }

    /// For a [`Label`](egui::Label) whose text can be selected.
    #[must_use]
    pub fn galley(&self) -> Arc<Galley> {
        self.galley.clone()
    }

    /// Paints it with this corner, edge or middle of its box at `at`; the box.
    #[expect(
        clippy::must_use_candidate,
        reason = "painting is what it is called for"
    )]
    pub fn paint(&self, painter: &Painter, at: Pos2, align: Align2) -> Rect {
        self.paint_in(painter, at, align, self.colour)
    }

    /// The same in this colour, where it was set in [`Color32::PLACEHOLDER`].
    #[expect(
        clippy::must_use_candidate,
        reason = "painting is what it is called for"
    )]
    pub fn paint_in(&self, painter: &Painter, at: Pos2, align: Align2, colour: Color32) -> Rect {
        let rect = align.anchor_size(at, self.size());
        painter.galley(rect.min, self.galley.clone(), colour);
        rect
    }
}

/// One galley of several rows.
fn joined(rows: &[SetRow]) -> Galley {
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
        for placed in &row.galley.rows {
            let mut placed = placed.clone();
            placed.pos = pos2(placed.pos.x, top);
            whole.rect |= placed.rect();
            let bounds = placed.visuals.mesh_bounds.translate(placed.pos.to_vec2());
            whole.mesh_bounds |= bounds;
            whole.num_vertices += placed.visuals.mesh.vertices.len();
            whole.num_indices += placed.visuals.mesh.indices.len();
            top += placed.row.size.y;
            whole.rows.push(placed);
        }
    }
    whole.job = Arc::new(job);
    whole
}

#[cfg(test)]
mod tests;
