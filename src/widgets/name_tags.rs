//! The names of handles in space, beside them: of those in use with their numbers, of those that the lesson asks for.

use super::{
    handles::{Handles, Spot, gripped},
    prelude::*,
};

/// From the middle of a handle, or from the pointer, to its name.
const BESIDE: f32 = 18.0;
const PLATE: Vec2 = vec2(4.0, 2.0);

impl Handles<'_> {
    /// While one is dragged its name stands beside the pointer. Those under it are named only where that `is_read`.
    pub fn draw_names(&self, ui: &Ui, painter: &Painter, canvas: &Response, is_read: bool) {
        let focused = ui.memory(egui::Memory::focused);
        let held = gripped(ui, self.id);
        let pointer = canvas.hover_pos().filter(|_| is_read && held.is_none());
        let near = pointer.and_then(|at| self.near(ui, at));
        for spot in self.spots.iter().filter(|spot| !spot.locked) {
            let (i, centre) = (spot.index, self.viewport.to_screen(spot.at));
            let mut at = centre;
            let said = if held == Some(i) {
                at = canvas.interact_pointer_pos().unwrap_or(centre);
                self.told(spot)
            } else if near == Some(i) {
                self.offered(spot, pointer)
            } else if focused == Some(self.id_of(i)) {
                self.told(spot)
            } else if spot.asked {
                spot.name.clone()
            } else {
                continue;
            };
            name(painter, self.viewport.rect, (self.look, at), said);
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

fn name(painter: &Painter, rect: Rect, (look, at): (Look<'_>, Pos2), said: String) {
    let theme = look.theme;
    let font = FontId::proportional(12.0 * theme.text_scale.sqrt());
    let text = painter.layout_no_wrap(said, font, theme.ink);
    let aside = vec2(BESIDE, 0.0);
    let right = Align2::LEFT_CENTER.anchor_size(at + aside, text.size());
    let place = if rect.right() < right.right() {
        Align2::RIGHT_CENTER.anchor_size(at - aside, text.size())
    } else {
        right
    };
    painter.rect_filled(place.expand2(PLATE), PLATE.x, theme.background);
    painter.galley(place.min, text, theme.ink);
}
