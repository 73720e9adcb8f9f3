//! A figure in its layout: everything but the drawings, for the window's stage and the exported page alike.

use egui::{Align2, FontId, Painter, Rect, Stroke, Ui, pos2, vec2};

use crate::{
    figure::{Caption, ColumnLayout, Layout, Link, Need, Sheet, Slot, View},
    labs::{Difference, MethodCard},
    paint::{Span, Theme, Typeset, fonts::semibold},
};

use super::{caption, headings::column_title, look::Look, views::view};

/// The size of text in points, at scale 1: what a [`Slot`]'s ems are.
pub const TEXT_PTS: f32 = 13.0;
/// The step's title, at scale 1.
const TITLE_PTS: f32 = 19.5;

/// White space of a figure, in points: a window has little of it, a page more.
pub struct Spacing {
    /// At the left and right of all.
    pub margin: f32,
    /// Between the methods that stand side by side.
    pub gutter: f32,
    /// Beside words, and around what stands beside a drawing.
    pub inset: f32,
    /// Under the title.
    pub under_title: f32,
    /// Height of the strip that names a method, where two are compared.
    pub name: f32,
    /// Over the hairline of the caption.
    pub over_caption: f32,
    /// The place cannot be enlarged.
    pub is_fixed: bool,
}

/// A figure of one method or of several side by side, on the window's stage or on an exported page.
#[derive(Clone, Copy)]
pub struct Composition<'a> {
    /// Colours and words.
    pub look: Look<'a>,
    /// Its white space.
    pub spacing: &'static Spacing,
    /// The methods, from left to right.
    pub methods: &'a [&'static MethodCard],
    /// Where one of them is wrong on purpose.
    pub difference: Option<Difference>,
}

impl Composition<'_> {
    /// The width that words have in each column.
    pub fn column_width(&self, area: Rect) -> f32 {
        let Spacing {
            margin,
            gutter,
            inset,
            ..
        } = self.spacing;
        let n = self.methods.len().max(1) as f32;
        (area.width() - 2.0 * margin - (n - 1.0) * gutter) / n - 2.0 * inset
    }

    /// Finds where everything stands, and draws what stands over all columns: the step's title. The heights are those of
    /// the caption and of the cost.
    pub fn lay_out(
        &self,
        ui: &Ui,
        area: Rect,
        title: Option<&str>,
        [caption, cost]: [f32; 2],
        needs: &[Vec<Need>],
    ) -> Layout {
        let (theme, spacing) = (self.look.theme, self.spacing);
        let width = area.width() - 2.0 * (spacing.margin + spacing.inset);
        let title = title.map(|title| headline(ui.painter(), theme, title, width));
        let is_comparison = self.methods.len() > 1;
        let sheet = Sheet {
            area: slot_of(area),
            em: TEXT_PTS * theme.text_scale,
            margin: spacing.margin,
            inset: spacing.inset,
            gutter: spacing.gutter,
            title: title
                .as_ref()
                .map_or(0.0, |title| title.size().y + spacing.under_title),
            name: if is_comparison {
                spacing.name * theme.title_scale
            } else {
                0.0
            },
            over_caption: spacing.over_caption,
            caption,
            cost,
            is_fixed: spacing.is_fixed,
        };
        let layout = sheet.lay_out(needs);
        if let Some(title) = title {
            let at = rect_of(layout.title).min + spacing.inset * vec2(1.0, 0.5);
            title.paint(ui.painter(), at, Align2::LEFT_TOP);
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
        if let Some(method) = self.methods.get(column).filter(|_| self.methods.len() > 1) {
            let difference = self.difference.filter(|known| known.column == column);
            let note = difference.map(|difference| look.catalog.message(&difference.message()));
            let strip = inside(places.name);
            column_title(
                &ui.painter_at(strip),
                look,
                (strip.left_top(), Align2::LEFT_TOP),
                strip.width(),
                &look.say(method.name_key),
                [moment, note.as_deref()],
            );
        }
        let mut pointed = None;
        for shown in views.iter().skip(1) {
            if let Some(slot) = places.slot(shown.id) {
                pointed = view(ui, look, rect_of(slot), shown, lit).or(pointed);
            }
        }
        let rest = rect_of(places.caption);
        let hairline = Stroke::new(1.0, look.theme.hairline);
        ui.painter()
            .hline(rest.x_range(), rest.top() + 0.5, hairline);
        caption(ui, look, inside(places.caption), said);
        pointed
    }
}

/// The step's title, whole: on as many lines as it takes in this width.
fn headline(painter: &Painter, theme: &Theme, title: &str, width: f32) -> Typeset {
    let font = FontId::new(TITLE_PTS * theme.title_scale, semibold());
    Typeset::wrapped(painter, &[Span::text(title, font, theme.ink)], width)
}

/// A slot on the screen.
pub fn rect_of(slot: Slot) -> Rect {
    let [min, max] = [slot.min, slot.max].map(|[x, y]| pos2(x, y));
    Rect::from_min_max(min, max)
}

/// A place on the screen as a slot.
fn slot_of(rect: Rect) -> Slot {
    let [min, max] = [rect.min, rect.max].map(|at| [at.x, at.y]);
    Slot { min, max }
}
