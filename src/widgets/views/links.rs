//! Which part of a view is under the pointer, and which lights up.

use egui::{Pos2, Rect};

use crate::figure::Link;

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
