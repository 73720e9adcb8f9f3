//! What a kind of view has to say so that it is drawn: its slate, its picture, its words.

use egui::{Painter, Rect};

use super::{super::Look, links::Links, slate::Slate};

/// A view that is drawn on a slate of its own.
pub trait OnSlate {
    /// A slate on which it is as large as the room lets it be.
    fn slate<'a>(&self, painter: &'a Painter, look: Look<'a>, rect: Rect) -> Slate<'a>;
    /// Draws it from the top left of `rect`.
    fn draw(&self, slate: &mut Slate<'_>, rect: Rect, links: &mut Links);
    /// All that it shows, in words.
    fn spoken(&self, look: Look<'_>) -> String;
}
