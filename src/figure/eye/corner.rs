//! The corner of a drawing in which the camera's picture stands.

use super::super::layout::Slot;

/// How near a point may be that is not under an inset and whose marker is, in points.
const NEAR: f32 = 6.0;

/// Where an inset stands of which the layout has put the lower right corner: in the emptiest of four, by how much would be
/// `under` it and its title, and of corners alike by how much would be near them. The upper left is the one of the drawing's own title.
pub fn emptiest(drawing: Slot, inset: Slot, title: f32, under: impl Fn(Slot) -> usize) -> Slot {
    let [left, top] = [0, 1].map(|i| drawing.min[i] + drawing.max[i] - inset.max[i]);
    let [right, low] = inset.min;
    let corners = [
        [right, low],
        [left, low],
        [right, top + title],
        [left, top + 2.0 * title],
    ];
    let stands = corners.map(|min| Slot::new(min, inset.size()));
    let covers = |slot: Slot| {
        let around = |by: f32| Slot {
            min: [slot.min[0] - by, slot.min[1] - title - by],
            max: slot.max.map(|side| side + by),
        };
        [under(around(0.0)), under(around(NEAR))]
    };
    let mut best = (covers(stands[0]), stands[0]);
    for slot in &stands[1..] {
        let n_covered = covers(*slot);
        if n_covered < best.0 {
            best = (n_covered, *slot);
        }
    }
    best.1
}

/// How many of these places lie in a slot.
pub fn count(places: impl Iterator<Item = [f32; 2]>, slot: Slot) -> usize {
    let is_in = |at: &[f32; 2]| (0..2).all(|i| (slot.min[i]..=slot.max[i]).contains(&at[i]));
    places.filter(is_in).count()
}
