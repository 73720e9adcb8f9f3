//! The names of handles in space, beside them: of those in use with their numbers, of those that the lesson asks for.

use crate::paint::Placed;

use super::{
    handles::{Handles, Spot, gripped},
    prelude::*,
};

/// From the middle of a handle, or from the pointer, to its name.
const BESIDE: f32 = 18.0;
const PLATE: Vec2 = vec2(4.0, 2.0);

impl Handles<'_> {
    /// While one is dragged its name stands beside the pointer. Those under it are named only where that `is_read`.
    /// They cover none of the `labels`, where there is room beside them.
    pub fn draw_names(
        &self,
        ui: &Ui,
        painter: &Painter,
        canvas: &Response,
        (labels, is_read): (&[Placed], bool),
    ) {
        let mut taken: Vec<Rect> = labels.iter().map(|label| label.rect).collect();
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
            let room = self.viewport.rect;
            taken.push(name(painter, (room, &taken), (self.look, at), said));
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

fn name(
    painter: &Painter,
    (room, taken): (Rect, &[Rect]),
    (look, at): (Look<'_>, Pos2),
    said: String,
) -> Rect {
    const SIDES: [(Align2, Vec2); 4] = [
        (Align2::LEFT_CENTER, vec2(BESIDE, 0.0)),
        (Align2::RIGHT_CENTER, vec2(-BESIDE, 0.0)),
        (Align2::CENTER_BOTTOM, vec2(0.0, -BESIDE)),
        (Align2::CENTER_TOP, vec2(0.0, BESIDE)),
    ];
    let theme = look.theme;
    let font = FontId::proportional(theme.pts(12.0, theme.text_scale));
    let text = painter.layout_no_wrap(said, font, theme.ink);
    let place = |(align, aside): (Align2, Vec2)| {
        let place = align.anchor_size(at + aside, text.size());
        place.expand2(PLATE)
    };
    let mut inside = SIDES
        .map(place)
        .into_iter()
        .filter(|it| room.contains_rect(*it));
    let first = inside.clone().next();
    let free = inside.find(|place| !taken.iter().any(|other| other.intersects(*place)));
    let plate = free.or(first).unwrap_or_else(|| place(SIDES[0]));
    painter.rect_filled(plate, PLATE.x, theme.background);
    painter.galley(plate.min + PLATE, text, theme.ink);
    plate
}
