//! What a kind of view has to say so that it is drawn: its slate, its picture, its words; and which part of it is under the
//! pointer, and which lights up.

use egui::{Painter, Pos2, Rect};

use crate::figure::Link;

use super::{super::look::Look, slate::Slate};

/// A view that is drawn on a slate of its own.
pub trait OnSlate {
    /// A slate on which it is as large as the room lets it be.
    fn slate<'a>(&self, painter: &'a Painter, look: Look<'a>, rect: Rect) -> Slate<'a>;
    /// Draws it from the top left of `rect`.
    fn draw(&self, slate: &mut Slate<'_>, rect: Rect, links: &mut Links);
    /// All that it shows, in words.
    fn spoken(&self, look: Look<'_>) -> String;
}

/// The pointer, what stands out, and what was found.
pub struct Links {
    /// What stands out, here and elsewhere.
    pub lit: Option<Link>,
    /// Where the pointer is, if it is on the view.
    pub pointer: Option<Pos2>,
    /// What it is on.
    pub pointed: Option<Link>,
}

impl Links {
    /// A part with this link takes this place: does it stand out?
    pub fn touch(&mut self, place: Rect, link: Option<Link>) -> bool {
        let is_near = self.pointer.is_some_and(|pointer| place.contains(pointer));
        if is_near && link.is_some() {
            self.pointed = link;
        }
        link.is_some() && (is_near || link == self.lit)
    }
}
