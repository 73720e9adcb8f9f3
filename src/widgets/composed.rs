//! A figure in its layout: everything of a method but the drawing, for the window's stage and the exported page alike.

use egui::{Align2, FontId, Painter, Rect, Stroke, Ui, pos2, vec2};

use crate::{
    figure::{Caption, ColumnLayout, Link, Slot, View},
    paint::{Span, Theme, Typeset, fonts::semibold},
};

use super::{caption, headings::column_title, look::Look, views::view};

/// The size of text in points, at scale 1: what a [`Slot`]'s ems are.
pub const TEXT_PTS: f32 = 13.0;
/// The step's title, at scale 1.
const TITLE_PTS: f32 = 19.5;

/// What is said in words of a method's step.
#[derive(Clone, Copy)]
pub struct StepWords<'a> {
    /// The method's name, where two stand side by side.
    pub name: Option<&'a str>,
    /// Which of its steps is shown, where the other's may be another.
    pub moment: Option<&'a str>,
    /// What is said of a method that is wrong on purpose.
    pub note: Option<&'a str>,
    /// The step's sentence.
    pub said: &'a Caption,
    /// White space on the left and right of words.
    pub indent: f32,
}

/// Draws all of a method's step but its drawing, which is the first of the views; the link under the pointer.
pub fn beside_the_drawing(
    ui: &mut Ui,
    look: Look<'_>,
    places: &ColumnLayout,
    views: &[View],
    words: &StepWords<'_>,
    lit: Option<Link>,
) -> Option<Link> {
    let inside = |slot: Slot| rect_of(slot).shrink2(vec2(words.indent, 0.0));
    if let Some(name) = words.name {
        let strip = inside(places.name);
        column_title(
            &ui.painter_at(strip),
            look,
            (strip.left_top(), Align2::LEFT_TOP),
            strip.width(),
            name,
            [words.moment, words.note],
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
    caption(ui, look, inside(places.caption), words.said);
    pointed
}

/// The step's title, whole: on as many lines as it takes in this width.
#[must_use]
pub fn headline(painter: &Painter, theme: &Theme, title: &str, width: f32) -> Typeset {
    let font = FontId::new(TITLE_PTS * theme.title_scale, semibold());
    Typeset::wrapped(painter, &[Span::text(title, font, theme.ink)], width)
}

/// A slot on the screen.
#[must_use]
pub fn rect_of(slot: Slot) -> Rect {
    let [min, max] = [slot.min, slot.max].map(|[x, y]| pos2(x, y));
    Rect::from_min_max(min, max)
}

/// A place on the screen as a slot.
#[must_use]
pub fn slot_of(rect: Rect) -> Slot {
    let [min, max] = [rect.min, rect.max].map(|at| [at.x, at.y]);
    Slot { min, max }
}
