//! The names of handles in space, beside them: of those in use with their numbers, of those that the lesson asks for.

use std::sync::Arc;

use egui::Galley;

use crate::paint::Placed;

use super::{
    handles::{Handles, Spot, gripped},
    prelude::*,
};

/// From the middle of a handle, or from the pointer, to its name.
const BESIDE: f32 = 18.0;
const PLATE: Vec2 = vec2(4.0, 2.0);
/// Corner to corner with the handle.
const ASLANT: f32 = 0.7 * BESIDE;
const SIDES: [(Align2, Vec2); 8] = [
    (Align2::LEFT_CENTER, vec2(BESIDE, 0.0)),
    (Align2::RIGHT_CENTER, vec2(-BESIDE, 0.0)),
    (Align2::CENTER_BOTTOM, vec2(0.0, -BESIDE)),
    (Align2::CENTER_TOP, vec2(0.0, BESIDE)),
    (Align2::LEFT_BOTTOM, vec2(ASLANT, -ASLANT)),
    (Align2::RIGHT_BOTTOM, vec2(-ASLANT, -ASLANT)),
    (Align2::LEFT_TOP, vec2(ASLANT, ASLANT)),
    (Align2::RIGHT_TOP, vec2(-ASLANT, ASLANT)),
];

impl Handles<'_> {
    /// While one is dragged its name stands beside the pointer. Those under it are named only where that `is_read`.
    /// They cover none of the `labels`, where there is room beside them, and are not under what has `covered` the drawing.
    pub fn draw_names(
        &self,
        ui: &Ui,
        painter: &Painter,
        canvas: &Response,
        (labels, covered, is_read): (&[Placed], &[Rect], bool),
    ) {
        // What lies over the drawing would hide a name.
        let taken = labels.iter().map(|label| label.rect);
        let mut taken: Vec<Rect> = taken.chain(covered.iter().copied()).collect();
        let focused = ui.memory(egui::Memory::focused);
        let held = gripped(ui, self.id);
        let pointer = canvas.hover_pos().filter(|_| is_read && held.is_none());
        let near = pointer.and_then(|at| self.near(ui, at));
        for spot in self.spots.iter().filter(|spot| !spot.locked) {
            let (i, centre) = (spot.index, self.viewport.to_screen(spot.at));
            let (mut at, mut in_use) = (centre, true);
            let said = if held == Some(i) {
                at = canvas.interact_pointer_pos().unwrap_or(centre);
                self.told(spot)
            } else if near == Some(i) {
                self.offered(spot, pointer)
            } else if focused == Some(self.id_of(i)) {
                self.told(spot)
            } else if spot.asked {
                in_use = false;
                spot.name.clone()
            } else {
                continue;
            };
            let tag = Tag::new(painter, self.look, said);
            let room = self.viewport.rect;
            // A name that nobody waits for covers no other.
            let place = tag.place(at, room, &taken);
            let in_sight = || tag.place(at, room, covered);
            let in_use = || in_use.then(|| in_sight().unwrap_or_else(|| tag.nearest(at, room)));
            if let Some(plate) = place.or_else(in_use) {
                tag.paint(painter, self.look, plate);
                taken.push(plate);
            }
        }
    }

    /// Its name, and what a click takes in its place.
    fn offered(&self, spot: &Spot, pointer: Option<Pos2>) -> String {
        let group = pointer.map(|at| self.group(at)).unwrap_or_default();
        let nth = group.iter().position(|&i| i == spot.index);
        let next = nth.map(|nth| group[(nth + 1) % group.len()]);
        let other = next.filter(|&next| next != spot.index);
        let Some(other) = other.and_then(|next| self.spot(next)) else {
            return self.told(spot);
        };
        let other = Message::new("handle-other").with("name", other.name.clone());
        let other = self.look.catalog.message(&other);
        format!("{} · {other}", self.told(spot))
    }
}

struct Tag(Arc<Galley>);

impl Tag {
    fn new(painter: &Painter, look: Look<'_>, said: String) -> Self {
        let font = FontId::proportional(look.theme.pts(12.0, look.theme.text_scale));
        Self(painter.layout_no_wrap(said, font, look.theme.ink))
    }

    /// Where it can stand beside a handle, within the room.
    fn places(&self, at: Pos2, room: Rect) -> impl Iterator<Item = Rect> {
        let place = move |(align, aside)| self.beside(at, align, aside);
        let is_inside = move |place: &Rect| room.contains_rect(*place);
        SIDES.into_iter().map(place).filter(is_inside)
    }

    fn beside(&self, at: Pos2, align: Align2, aside: Vec2) -> Rect {
        let place = align.anchor_size(at + aside, self.0.size());
        place.expand2(PLATE)
    }

    /// The first of them that covers nothing.
    fn place(&self, at: Pos2, room: Rect, taken: &[Rect]) -> Option<Rect> {
        let is_free = |place: &Rect| !taken.iter().any(|other| other.intersects(*place));
        self.places(at, room).find(is_free)
    }

    /// The first of them, whatever it covers.
    fn nearest(&self, at: Pos2, room: Rect) -> Rect {
        let [(align, aside), ..] = SIDES;
        let first = self.places(at, room).next();
        first.unwrap_or_else(|| self.beside(at, align, aside))
    }

    fn paint(&self, painter: &Painter, look: Look<'_>, plate: Rect) {
        let theme = look.theme;
        painter.rect_filled(plate, PLATE.x, theme.background);
        painter.galley(plate.min + PLATE, self.0.clone(), theme.ink);
    }
}
