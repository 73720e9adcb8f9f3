//! Values and formulas set for reading: on one line, ready to be measured and painted.

use std::sync::Arc;

use egui::{Align2, Color32, FontId, Galley, Painter, Pos2, Rect, Vec2};

use crate::text::{Catalog, Formula, Value};

/// One line that has been laid out.
pub struct Typeset {
    galley: Arc<Galley>,
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
        Self::text(painter, catalog.value(value), font, colour)
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
        Self::text(painter, catalog.formula(formula), font, colour)
    }

    /// Words.
    #[must_use]
    pub fn text(painter: &Painter, text: String, font: FontId, colour: Color32) -> Self {
        let galley = painter.layout_no_wrap(text, font, colour);
        Self { galley, colour }
    }

    /// Of the box around it, in points.
    #[must_use]
    pub fn size(&self) -> Vec2 {
        self.galley.size()
    }

    /// Paints it with this corner, edge or middle of its box at `at`; the box.
    pub fn paint(&self, painter: &Painter, at: Pos2, align: Align2) -> Rect {
        let rect = align.anchor_size(at, self.size());
        painter.galley(rect.min, self.galley.clone(), self.colour);
        rect
    }
}
