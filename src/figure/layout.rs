//! Where everything of a figure stands: the one layout of the window's stage and of an exported page.
//!
//! ```text
//! ┌ title ─────────────────────────────┐   ┌ title ─────────────────────────────┐
//! │                                    │   │ method           │ method          │
//! │ drawing                  bits      │   │ drawing          │ drawing         │
//! │                          table     │   │                  │                 │
//! │                          lists     │   │ number line      │ bits            │
//! │ number line, clippers    products  │   │                  │                 │
//! ├────────────────────────────────────┤   ├──────────────────┼─────────────────┤
//! │ caption                            │   │ caption, cost    │ caption, cost   │
//! └────────────────────────────────────┘   └──────────────────┴─────────────────┘
//! ```
//!
//! Everything is settled by what a whole run wants ([`super::needs`]), so that no step moves anything.

use super::{Need, Stand, ViewId};

/// Of its column's width a drawing keeps this part at least, and of its height.
const DRAWING: [f32; 2] = [0.45, 0.4];
/// Between a drawing and what stands beside it, and under it; in ems.
const GAP: [f32; 2] = [3.0, 1.0];

/// A rectangle, in points; y goes down.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Slot {
    /// Left and top.
    pub min: [f32; 2],
    /// Right and bottom.
    pub max: [f32; 2],
}

impl Slot {
    /// Of this size, from its corner at the left and top.
    #[must_use]
    pub const fn new(min: [f32; 2], size: [f32; 2]) -> Self {
        let max = [min[0] + size[0], min[1] + size[1]];
        Self { min, max }
    }

    /// Width and height.
    #[must_use]
    pub const fn size(&self) -> [f32; 2] {
        [self.max[0] - self.min[0], self.max[1] - self.min[1]]
    }

    /// Cuts a strip of this height off the top.
    fn take_top(&mut self, height: f32) -> Self {
        let y = (self.min[1] + height.min(self.size()[1])).round();
        let top = Self {
            max: [self.max[0], y],
            ..*self
        };
        self.min[1] = y;
        top
    }

    /// Cuts a strip of this height off the bottom.
    fn take_bottom(&mut self, height: f32) -> Self {
        let y = (self.max[1] - height.min(self.size()[1])).round();
        let bottom = Self {
            min: [self.min[0], y],
            ..*self
        };
        self.max[1] = y;
        bottom
    }
}

/// What a figure is laid out on, in points.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Sheet {
    /// All there is.
    pub area: Slot,
    /// The size of the text.
    pub em: f32,
    /// White space inside the area, left and right.
    pub margin: f32,
    /// White space that a view beside the drawing keeps from the edges of its column.
    pub inset: f32,
    /// White space between two columns.
    pub gutter: f32,
    /// Height of the strip with the step's title.
    pub title: f32,
    /// Height of the strip with the method's name.
    pub name: f32,
    /// White space between the views and the hairline over the caption.
    pub over_caption: f32,
    /// Height of the caption, with the hairline over it.
    pub caption: f32,
    /// Height of the row with the cost.
    pub cost: f32,
}

/// Where everything stands.
#[derive(Clone, PartialEq, Debug)]
pub struct Layout {
    /// The step's title.
    pub title: Slot,
    /// One or two.
    pub columns: Vec<ColumnLayout>,
}

/// Where everything of one method stands.
#[derive(Clone, PartialEq, Debug)]
pub struct ColumnLayout {
    /// All of the column.
    pub whole: Slot,
    /// The method's name.
    pub name: Slot,
    /// The views there is room for.
    pub views: Vec<(ViewId, Slot)>,
    /// The step's sentence, the hairline being its upper edge.
    pub caption: Slot,
    /// The cost so far.
    pub cost: Slot,
}

impl ColumnLayout {
    /// The place of a view; `None` where there is no room for it.
    #[must_use]
    pub fn slot(&self, id: ViewId) -> Option<Slot> {
        let found = self.views.iter().find(|(of, _)| *of == id);
        found.map(|&(_, slot)| slot)
    }
}

impl Sheet {
    /// Lays out as many columns as there are lists of needs. Their drawings have the same size, so that both show the
    /// same place at the same scale.
    #[must_use]
    pub fn lay_out(&self, needs: &[Vec<Need>]) -> Layout {
        let mut rest = self.area;
        let mut title = rest.take_top(self.title);
        for slot in [&mut title, &mut rest] {
            slot.min[0] += self.margin;
            slot.max[0] -= self.margin;
        }
        let n = needs.len().max(1) as f32;
        let width = (rest.size()[0] - (n - 1.0) * self.gutter) / n;
        let mut columns: Vec<(ColumnLayout, Slot)> = (0..needs.len())
            .map(|i| {
                let left = (rest.min[0] + i as f32 * (width + self.gutter)).round();
                let whole = Slot {
                    min: [left, rest.min[1]],
                    max: [(left + width).round(), rest.max[1]],
                };
                self.column(whole)
            })
            .collect();
        let mut common = [f32::MAX; 2];
        // The second time each drawing knows how large the others can be.
        for _ in 0..2 {
            for ((column, stage), needs) in columns.iter_mut().zip(needs) {
                column.views = self.views(*stage, needs, common);
            }
            for (column, _) in &columns {
                if let Some((_, slot)) = column.views.first() {
                    let size = slot.size();
                    common = [common[0].min(size[0]), common[1].min(size[1])];
                }
            }
        }
        let columns = columns.into_iter().map(|(column, _)| column).collect();
        Layout { title, columns }
    }

    /// A column, and the room it leaves for its views.
    fn column(&self, whole: Slot) -> (ColumnLayout, Slot) {
        let mut stage = whole;
        let most = 0.4 * whole.size()[1];
        let name = stage.take_top(self.name);
        let cost = stage.take_bottom(self.cost.min(most));
        let caption = stage.take_bottom(self.caption.min(most));
        stage.take_bottom(self.over_caption);
        let column = ColumnLayout {
            whole,
            name,
            views: Vec::new(),
            caption,
            cost,
        };
        (column, stage)
    }

    /// The views of a column, the drawing first and no larger than `most`.
    fn views(&self, stage: Slot, needs: &[Need], most: [f32; 2]) -> Vec<(ViewId, Slot)> {
        let Some(first) = needs.iter().position(|need| need.stand == Stand::Drawing) else {
            return Vec::new();
        };
        let drawing = &needs[first];
        let others = needs[..first].iter().chain(&needs[first + 1..]);
        let (mut under, mut beside): (Vec<&Need>, Vec<&Need>) =
            others.partition(|need| need.stand == Stand::Under);
        let [width, height] = stage.size();
        let [gap_x, gap_y] = GAP.map(|gap| gap * self.em);
        let least_width = (drawing.least[0] * self.em).max(DRAWING[0] * width);
        let room = width - least_width - gap_x - self.inset;
        let side_width = beside.iter().map(|need| need.natural[0] * self.em);
        let side_width = side_width.fold(0.0, f32::max).min(room);
        if beside
            .iter()
            .any(|need| need.least[0] * self.em > side_width)
        {
            under.append(&mut beside);
        }
        let mut left = stage;
        if !beside.is_empty() {
            left.max[0] -= (side_width + gap_x + self.inset).round();
        }
        let least_height = (drawing.least[1] * self.em).max(DRAWING[1] * height);
        let strips = self.heights(&under, height - least_height - self.inset);
        let taken: f32 = strips.iter().map(|strip| strip + gap_y).sum();
        let size = left.size();
        let inset = if strips.is_empty() { 0.0 } else { self.inset };
        let high = (height - taken - inset).round();
        let drawn = Slot::new(left.min, [size[0].min(most[0]), high.min(most[1])]);
        let mut slots = vec![(drawing.id, drawn)];
        let mut below = Slot {
            min: [drawn.min[0] + self.inset, drawn.max[1]],
            max: [drawn.max[0] - self.inset, stage.max[1]],
        };
        below.take_top(gap_y);
        slots.extend(self.stack(below, &under, &strips));
        let side = Slot {
            min: [left.max[0] + gap_x.round(), stage.min[1] + self.inset],
            max: [stage.max[0] - self.inset, stage.max[1] - self.inset],
        };
        let heights = self.heights(&beside, side.size()[1] + gap_y);
        slots.extend(self.stack(side, &beside, &heights));
        slots
    }

    /// Views above each other, from the top of a column.
    fn stack(&self, mut rest: Slot, needs: &[&Need], heights: &[f32]) -> Vec<(ViewId, Slot)> {
        let mut slots = Vec::new();
        for (need, &height) in needs.iter().zip(heights) {
            let mut slot = rest.take_top(height);
            // What stands under the drawing for want of room is no wider than it would be beside it.
            let natural = (slot.min[0] + need.natural[0] * self.em).round();
            slot.max[0] = slot.max[0].min(natural);
            slots.push((need.id, slot));
            rest.take_top(GAP[1] * self.em);
        }
        slots
    }

    /// Heights of views above each other in a room of this height, each with a gap after it: between what they want at
    /// least and at most. The last ones get none where there is too little.
    fn heights(&self, needs: &[&Need], room: f32) -> Vec<f32> {
        let [least, natural] = [|need: &Need| need.least[1], |need: &Need| need.natural[1]];
        let gap = GAP[1] * self.em;
        let mut needs = needs.to_vec();
        let sum = |needs: &[&Need], of: fn(&Need) -> f32| -> f32 {
            needs.iter().map(|need| of(need) * self.em + gap).sum()
        };
        while !needs.is_empty() && sum(&needs, least) > room {
            needs.pop();
        }
        let (low, high) = (sum(&needs, least), sum(&needs, natural));
        let part = if high > room {
            (room - low) / (high - low)
        } else {
            1.0
        };
        let height = |need: &&Need| {
            let [low, high] = [least(need), natural(need)];
            (low + part * (high - low)) * self.em
        };
        needs.iter().map(height).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn need(id: &'static str, stand: Stand, least: [f32; 2], natural: [f32; 2]) -> Need {
        let id = ViewId(id);
        Need {
            id,
            stand,
            least,
            natural,
        }
    }

    fn sheet(size: [f32; 2], em: f32) -> Sheet {
        Sheet {
            area: Slot::new([0.0; 2], size),
            em,
            margin: 48.0,
            inset: 0.0,
            gutter: 40.0,
            title: 40.0,
            name: 0.0,
            over_caption: 18.0,
            caption: 60.0,
            cost: 0.0,
        }
    }

    fn needs() -> Vec<Need> {
        vec![
            need("plane", Stand::Drawing, [22.0, 11.0], [30.0, 24.0]),
            need("line", Stand::Under, [14.0, 6.0], [60.0, 8.0]),
            need("table", Stand::Beside, [20.0, 12.0], [30.0, 20.0]),
            need("note", Stand::Beside, [10.0, 4.0], [20.0, 8.0]),
        ]
    }

    fn is_apart(a: Slot, b: Slot) -> bool {
        (0..2).any(|i| a.max[i] <= b.min[i] || b.max[i] <= a.min[i])
    }

    #[test]
    fn nothing_overlaps_or_leaves_the_sheet_at_any_size() {
        for em in [13.0, 18.2] {
            for width in (100..2000).step_by(90) {
                for height in (80..1200).step_by(70) {
                    let size = [width as f32, height as f32];
                    let layout = sheet(size, em).lay_out(&[needs(), needs()[..2].to_vec()]);
                    for column in &layout.columns {
                        let slots: Vec<Slot> = column.views.iter().map(|(_, slot)| *slot).collect();
                        for (i, &slot) in slots.iter().enumerate() {
                            let others = slots[..i].iter();
                            assert!(others.copied().all(|other| is_apart(slot, other)));
                            assert!(slot.max[1] <= column.caption.min[1], "{size:?} {slot:?}");
                        }
                    }
                    let [a, b] = [0, 1].map(|i| layout.columns[i].views[0].1.size());
                    assert!((a[0] - b[0]).abs() <= 1.0 && a[1] == b[1], "one scale");
                }
            }
        }
    }

    #[test]
    fn a_table_stands_beside_the_drawing_from_its_height_and_an_axis_under_it_at_its_width() {
        let layout = sheet([960.0, 540.0], 13.0).lay_out(&[needs()]);
        let slot = |id| layout.columns[0].slot(ViewId(id)).unwrap();
        let [plane, line, table] = ["plane", "line", "table"].map(slot);
        assert_eq!(table.min[1], plane.min[1]);
        assert!(table.min[0] > plane.max[0]);
        assert_eq!([line.min[0], line.max[0]], [plane.min[0], plane.max[0]]);
        assert!(line.min[1] > plane.max[1]);
    }

    #[test]
    fn what_has_no_room_is_left_out_from_the_last_on() {
        let shown = |size| {
            let layout = sheet(size, 13.0).lay_out(&[needs()]);
            layout.columns[0].views.len()
        };
        assert_eq!(shown([960.0, 540.0]), 4);
        assert_eq!(shown([400.0, 200.0]), 1);
    }
}
