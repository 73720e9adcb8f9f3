//! What a kind of view has to say so that it is drawn: its sheet, its picture, its words.

use egui::{Painter, Rect};

use super::{super::Look, links::Links, sheet::Sheet};

/// A view that is drawn on a sheet of its own.
pub trait OnSheet {
    /// A sheet on which it is as large as the room lets it be.
    fn sheet<'a>(&self, painter: &'a Painter, look: Look<'a>, rect: Rect) -> Sheet<'a>;
    /// Draws it from the top left of `rect`.
    fn draw(&self, sheet: &mut Sheet<'_>, rect: Rect, links: &mut Links);
    /// All that it shows, in words.
    fn spoken(&self, look: Look<'_>) -> String;
}
