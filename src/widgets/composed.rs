//! A figure in its layout: everything but the drawings, for the window's stage and the exported page alike.

use crate::{
    figure::{Caption, ColumnLayout, Layout, Need, Sheet, Slot, Spacing, View},
    labs::Difference,
    paint::{fonts::semibold, notes},
};

use super::{caption, headings::column_title, prelude::*, views::view};

/// The size of text in points, at scale 1: what a [`Slot`]'s ems are.
pub const TEXT_PTS: f32 = 13.0;
const TITLE_PTS: f32 = 19.5;
const LEAST_UNDER_TITLE: f32 = 8.0;

#[derive(Clone, Copy)]
pub struct Composition<'a> {
    pub look: Look<'a>,
    pub spacing: &'static Spacing,
    /// What is written over each column, where there are several.
    pub headings: &'a [String],
    pub difference: Option<Difference>,
}

impl Composition<'_> {
    pub fn column_width(&self, area: Rect) -> f32 {
        let space = self.spacing;
        let n = self.headings.len().max(1) as f32;
        let columns = area.width() - 2.0 * space.margin - (n - 1.0) * space.gutter;
        columns / n - 2.0 * space.inset
    }

    /// Finds where everything stands, and draws the step's title over all columns.
    pub fn lay_out(
        &self,
        ui: &Ui,
        area: Rect,
        title: Option<&str>,
        [caption, cost]: [f32; 2],
        needs: &[Vec<Need>],
        [board, taken]: [f32; 2],
    ) -> Layout {
        let (theme, spacing) = (self.look.theme, self.spacing);
        let width = area.width() - 2.0 * (spacing.margin + spacing.inset);
        let font = FontId::new(TITLE_PTS * theme.title_scale, semibold());
        let title = title.map(|title| Span::text(title, font, theme.ink));
        let title = title.map(|title| Typeset::wrapped(ui.painter(), &[title], width));
        let [min, max] = [area.min, area.max].map(|at| [at.x, at.y]);
        let is_alone = self.headings.len() <= 1;
        let name = if is_alone { 0.0 } else { spacing.name };
        let height = title.as_ref().map(|title| title.size().y);
        let sheet = Sheet {
            area: Slot { min, max },
            em: TEXT_PTS * theme.text_scale,
            spacing,
            title: height.map_or(0.0, |height| {
                // On a projector the drawings keep that room.
                let over = if theme.has_large_text() { 0.0 } else { 0.5 };
                (over * spacing.inset + height + LEAST_UNDER_TITLE).max(spacing.titled)
            }),
            name: name * theme.title_scale,
            caption,
            cost,
            board,
            taken,
        };
        let layout = sheet.lay_out(needs);
        if let Some(title) = title {
            let at = rect_of(layout.title).min + spacing.inset * vec2(1.0, 0.5);
            let painter = ui.painter();
            notes::group(painter, "title", || {
                title.paint(painter, at, Align2::LEFT_TOP)
            });
        }
        layout
    }

    /// Draws all of a method's step but its drawing, which is the first of the views, with the sentence that is `said` and
    /// where it is not the same in all columns the `moment`; the link under the pointer.
    pub fn beside_the_drawing(
        &self,
        ui: &mut Ui,
        (column, places): (usize, &ColumnLayout),
        views: &[View],
        (said, moment): (&Caption, Option<&str>),
        lit: Option<Link>,
    ) -> Option<Link> {
        let look = self.look;
        let inside = |slot: Slot| rect_of(slot).shrink2(vec2(self.spacing.inset, 0.0));
        if let Some(name) = (self.headings.get(column)).filter(|_| self.headings.len() > 1) {
            let difference = self.difference.filter(|known| known.column == column);
            let note = difference.map(|difference| look.catalog.message(&difference.message()));
            let strip = inside(places.name);
            let at = (strip.left_top(), Align2::LEFT_TOP);
            let notes = [moment, note.as_deref()];
            let painter = ui.painter_at(strip);
            notes::group(&painter, "method", || {
                column_title(&painter, look, at, strip.width(), name, notes);
            });
        }
        let mut pointed = None;
        for shown in views.iter().skip(1) {
            if let Some(slot) = places.slot(shown.id) {
                let painter = ui.painter().clone();
                let view = || view(ui, look, rect_of(slot), shown, lit);
                pointed = notes::group(&painter, "view", view).or(pointed);
            }
        }
        let rest = rect_of(places.caption);
        let hairline = Stroke::new(1.0, look.theme.hairline);
        let painter = ui.painter();
        painter.hline(rest.x_range(), rest.top() + 0.5, hairline);
        let painter = painter.clone();
        notes::group(&painter, "sentence", || {
            caption(ui, look, inside(places.caption), said);
        });
        pointed
    }
}

pub fn rect_of(slot: Slot) -> Rect {
    let [min, max] = [slot.min, slot.max].map(|[x, y]| pos2(x, y));
    Rect::from_min_max(min, max)
}
