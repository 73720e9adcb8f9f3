//! The corner of a drawing in which the camera's picture stands.

use super::super::layout::Slot;

/// The marker of a point that is this near to an inset reaches under it; in points.
const NEAR: f32 = 6.0;

/// Where it covers as much as this in each corner, an inset may be so much smaller, if then it covers less than half of that.
const MUCH: usize = 30;
const SMALLER: [f32; 2] = [0.8, 0.65];

/// Where an inset stands of which the layout has put the lower right corner: in the emptiest of four, by how much would be
/// `under` it and its title, and of corners alike by how much would be near them. The upper left is the one of the drawing's
/// own title.
pub fn emptiest(drawing: Slot, inset: Slot, title: f32, under: impl Fn(Slot) -> usize) -> Slot {
    let mut best = of_four(drawing, inset, title, &under);
    for part in SMALLER {
        if best.0[0] < MUCH {
            break;
        }
        let [width, height] = inset.size().map(|side| part * side);
        let [right, low] = inset.max;
        let smaller = Slot::new([right - width, low - height], [width, height]);
        let found = of_four(drawing, smaller, title, &under);
        if 2 * found.0[0] < best.0[0] {
            best = found;
        }
    }
    best.1
}

/// The emptiest of the four corners, with how much it covers there, and how much with what is near.
fn of_four(
    drawing: Slot,
    inset: Slot,
    title: f32,
    under: &impl Fn(Slot) -> usize,
) -> ([usize; 2], Slot) {
    let [left, top] = [0, 1].map(|i| drawing.min[i] + drawing.max[i] - inset.max[i]);
    let [right, low] = inset.min;
    let corners = [
        [right, low],
        [left, low],
        [right, top + title],
        [left, top + 2.0 * title],
    ];
    let covers = |min: [f32; 2]| {
        let slot = Slot::new(min, inset.size());
        let around = |by: f32| Slot {
            min: [slot.min[0] - by, slot.min[1] - title - by],
            max: slot.max.map(|side| side + by),
        };
        ([under(around(0.0)), under(around(NEAR))], slot)
    };
    let [first, others @ ..] = corners.map(covers);
    let less = |best: ([usize; 2], Slot), more: ([usize; 2], Slot)| {
        if more.0 < best.0 { more } else { best }
    };
    others.into_iter().fold(first, less)
}

/// How many of these places lie in a slot.
pub fn count(places: impl Iterator<Item = [f32; 2]>, slot: Slot) -> usize {
    let is_in = |at: &[f32; 2]| (0..2).all(|i| (slot.min[i]..=slot.max[i]).contains(&at[i]));
    places.filter(is_in).count()
}
