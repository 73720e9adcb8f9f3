//! Where everything of a figure stands: the one layout of the window's stage and of an exported page.
//!
//! ```text
//! ┌ title ─────────────────────────────┐   ┌ title ─────────────────────────────┐
//! │                                    │   │ method           │ method          │
//! │ drawing                  bits      │   │ drawing          │ drawing         │
//! │                          table     │   │                  │                 │
//! │                          lists     │   │ number line      │ lists           │
//! │ number line              products  │   │                  │                 │
//! │ clippers ───────────────────────── │   │ cost             │ cost            │
//! ├────────────────────────────────────┤   ├──────────────────┼─────────────────┤
//! │ caption                            │   │ caption          │ caption         │
//! └────────────────────────────────────┘   └──────────────────┴─────────────────┘
//! ```
//!
//! Everything is settled by what a whole run wants ([`super::needs`]), so that no step moves anything.

mod groups;
mod places;
#[cfg(test)]
mod tests;

use super::{extent::Need, view::ViewId};

use groups::{Groups, Way};

pub use self::places::{ColumnLayout, Slot};

/// Of its column's width a drawing keeps this part at least, and of its height.
const DRAWING: [f32; 2] = [0.45, 0.42];
/// What is read with text of this size, in points, is worth drawing, also where a theme has larger text.
const READABLE: f32 = 13.0;
/// The same of its width, where there is no room otherwise, or text is larger: what is read has it first.
const NARROW: f32 = 0.36;
const INSET: [f32; 2] = [0.27, 0.4];
/// Between a drawing and what stands beside it, and under it; in ems.
const GAP: [f32; 2] = [3.0, 1.0];

/// The white space of a page, or of the window's stage.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Spacing {
    pub margin: f32,
    pub gutter: f32,
    /// White space that a view beside the drawing keeps from the edges of its column.
    pub inset: f32,
    pub under_title: f32,
    pub name: f32,
    /// White space between the views and the hairline over the caption.
    pub over_caption: f32,
    /// It cannot be enlarged: where nothing else has room, all views are low.
    pub is_fixed: bool,
}

#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Sheet {
    pub area: Slot,
    pub em: f32,
    pub spacing: &'static Spacing,
    pub title: f32,
    pub name: f32,
    pub caption: f32,
    pub cost: f32,
}

#[derive(Clone, PartialEq, Debug)]
pub struct Layout {
    pub title: Slot,
    pub columns: Vec<ColumnLayout>,
}

impl Sheet {
    /// A column for each list of needs. Their drawings have one size: both show the same place at one scale.
    pub fn lay_out(&self, needs: &[Vec<Need>]) -> Layout {
        let mut rest = self.area;
        let mut title = rest.take_top(self.title);
        for slot in [&mut title, &mut rest] {
            slot.min[0] += self.spacing.margin;
            slot.max[0] -= self.spacing.margin;
        }
        let n = needs.len().max(1) as f32;
        let width = (rest.size()[0] - (n - 1.0) * self.spacing.gutter) / n;
        let column = |i: usize| {
            let left = (rest.min[0] + i as f32 * (width + self.spacing.gutter)).round();
            self.column(Slot {
                min: [left, rest.min[1]],
                max: [(left + width).round(), rest.max[1]],
            })
        };
        let columns = (0..needs.len()).map(column);
        let (mut columns, stages): (Vec<ColumnLayout>, Vec<Slot>) = columns.unzip();
        let views = self.views(&stages, needs);
        for (column, views) in columns.iter_mut().zip(views) {
            column.views = views;
        }
        Layout { title, columns }
    }

    /// The views of all columns: in the first way that has room for all of them, or in the one that has for most.
    fn views(&self, stages: &[Slot], needs: &[Vec<Need>]) -> Vec<Vec<(ViewId, Slot)>> {
        let count = |views: &[Vec<(ViewId, Slot)>]| views.iter().map(Vec::len).sum::<usize>();
        let n_wanted: usize = needs.iter().map(Vec::len).sum();
        let mut best = Vec::new();
        let is_portrait = stages.iter().all(|stage| stage.size()[0] < stage.size()[1]);
        let low = self.spacing.is_fixed.then_some(Way::Low);
        for way in Way::roomy(is_portrait).into_iter().chain(low) {
            let views = self.views_in(way, stages, needs);
            if best.is_empty() || count(&views) > count(&best) {
                best = views;
            }
            if count(&best) == n_wanted {
                break;
            }
        }
        best
    }

    fn views_in(&self, way: Way, stages: &[Slot], needs: &[Vec<Need>]) -> Vec<Vec<(ViewId, Slot)>> {
        let mut common = [f32::MAX; 2];
        let mut views = Vec::new();
        // The second time each drawing knows how large the others can be.
        for _ in 0..2 {
            let columns = stages.iter().zip(needs);
            views = columns
                .map(|(&stage, needs)| self.stand(way, stage, &way.wanted(needs), common))
                .collect::<Vec<_>>();
            for (_, slot) in views.iter().filter_map(|views| views.first()) {
                let size = slot.size();
                common = [common[0].min(size[0]), common[1].min(size[1])];
            }
        }
        views
    }

    fn column(&self, whole: Slot) -> (ColumnLayout, Slot) {
        let mut stage = whole;
        let most = 0.4 * whole.size()[1];
        let name = stage.take_top(self.name);
        // The white space that a short sentence leaves is at the foot of the page.
        let caption = stage.take_bottom(self.caption.min(most));
        stage.take_bottom(self.spacing.over_caption);
        let cost = stage.take_bottom(self.cost.min(most));
        let column = ColumnLayout {
            whole,
            name,
            views: Vec::new(),
            caption,
            cost,
        };
        (column, stage)
    }

    /// The drawing, no larger than `most`, and then the others; none where what stands beside it has no room.
    fn stand(
        &self,
        way: Way,
        mut stage: Slot,
        needs: &[Need],
        most: [f32; 2],
    ) -> Vec<(ViewId, Slot)> {
        let Some(Groups {
            drawing,
            insets,
            over,
            across,
            under,
            beside,
        }) = Groups::of(needs, way)
        else {
            return Vec::new();
        };
        let over = self.across(way, &mut stage, drawing, over, Slot::take_top);
        let across = self.across(way, &mut stage, drawing, across, Slot::take_bottom);
        let [width, height] = stage.size();
        let (em, least_width) = self.least_width(way, drawing, width);
        let gap_x = GAP[0] * em;
        let room = width - least_width - gap_x - self.spacing.inset;
        let side_width = beside.iter().map(|need| need.natural[0] * self.em);
        let side_width = side_width.fold(0.0, f32::max).min(room);
        if beside.iter().any(|need| need.least[0] * em > side_width) {
            return Vec::new();
        }
        let mut left = stage;
        if !beside.is_empty() {
            left.max[0] -= (side_width + gap_x + self.spacing.inset).round();
        }
        let least_height = least_height(way, drawing, height);
        let strips = self.heights(&under, height - least_height - self.spacing.inset);
        // As far as they all are seen, the drawing keeps half.
        let half = self.heights(&under, 0.5 * height);
        let is_enough = half.len() == strips.len();
        let strips = if is_enough { half } else { strips };
        let taken: f32 = strips.iter().map(|strip| strip + self.gap()).sum();
        let size = left.size();
        let inset = if strips.is_empty() {
            0.0
        } else {
            self.spacing.inset
        };
        let high = (height - taken - inset).round();
        let drawn = Slot::new(left.min, [size[0].min(most[0]), high.min(most[1])]);
        let mut slots = vec![(drawing.id, drawn)];
        let mut below = Slot {
            min: [drawn.min[0] + self.spacing.inset, drawn.max[1]],
            max: [drawn.max[0] - self.spacing.inset, stage.max[1]],
        };
        below.take_top(self.gap());
        slots.extend(self.stack(below, &under, &strips));
        let side = Slot {
            min: [
                left.max[0] + gap_x.round(),
                stage.min[1] + self.spacing.inset,
            ],
            max: [
                stage.max[0] - self.spacing.inset,
                stage.max[1] - self.spacing.inset,
            ],
        };
        let mut heights = self.heights(&beside, side.size()[1] + self.gap());
        // The last one may grow into what is left.
        if heights.len() == beside.len()
            && let Some(last) = heights.last_mut()
        {
            *last = f32::MAX;
        }
        slots.extend(self.stack(side, &beside, &heights));
        slots.extend(over);
        slots.extend(across);
        slots.extend(self.insets(drawn, &insets));
        slots
    }

    /// The size of text that views beside a drawing are measured by, and what that keeps of a column's width.
    fn least_width(&self, way: Way, drawing: &Need, width: f32) -> (f32, f32) {
        let readable = READABLE.min(self.em);
        match way {
            Way::Beside => {
                let is_large = self.em > READABLE;
                let part = if is_large { NARROW } else { DRAWING[0] };
                let least = drawing.least[0] * readable;
                (self.em, least.max(part * width))
            }
            Way::Narrow => (readable, NARROW * width),
            Way::Under | Way::Low => (self.em, width),
        }
    }

    fn insets(&self, drawing: Slot, needs: &[&Need]) -> Vec<(ViewId, Slot)> {
        let gap = self.gap();
        let mut right = drawing.max[0] - gap;
        let mut slots = Vec::new();
        for need in needs {
            let [width, height] = [0, 1].map(|i| INSET[i] * drawing.size()[i]);
            let part = (width / need.natural[0]).min(height / need.natural[1]);
            let size = need.natural.map(|side| (part * side).round());
            let min = [right - size[0], drawing.max[1] - gap - size[1]];
            slots.push((need.id, Slot::new(min, size)));
            right = min[0] - gap;
        }
        slots
    }

    fn gap(&self) -> f32 {
        GAP[1] * READABLE.min(self.em)
    }

    fn across(
        &self,
        way: Way,
        stage: &mut Slot,
        drawing: &Need,
        mut needs: Vec<&Need>,
        take: fn(&mut Slot, f32) -> Slot,
    ) -> Vec<(ViewId, Slot)> {
        let [width, height] = stage.size();
        needs.retain(|need| need.least[0] * READABLE <= width - 2.0 * self.spacing.inset);
        let room = height - least_height(way, drawing, height) - self.spacing.inset;
        let heights = self.heights(&needs, room);
        if heights.is_empty() {
            return Vec::new();
        }
        let gap = self.gap();
        let taken: f32 = heights.iter().map(|height| height + gap).sum();
        let mut strips = take(stage, taken + self.spacing.inset);
        strips.min[0] += self.spacing.inset;
        strips.max[0] -= self.spacing.inset;
        // On the side that the other views are on.
        let is_under = strips.max[1] > stage.min[1];
        strips.take_top(if is_under { gap } else { self.spacing.inset });
        self.stack(strips, &needs, &heights)
    }

    fn stack(&self, mut rest: Slot, needs: &[&Need], heights: &[f32]) -> Vec<(ViewId, Slot)> {
        let mut slots = Vec::new();
        for (need, &height) in needs.iter().zip(heights) {
            let mut slot = rest.take_top(height);
            // What stands under the drawing for want of room is no wider than it would be beside it.
            let natural = (slot.min[0] + need.natural[0] * self.em).round();
            slot.max[0] = slot.max[0].min(natural);
            slots.push((need.id, slot));
            rest.take_top(self.gap());
        }
        slots
    }

    /// Each with a gap after it, between least and natural; the last ones get none where there is too little.
    fn heights(&self, needs: &[&Need], room: f32) -> Vec<f32> {
        let least = |need: &Need| need.least[1] * READABLE.min(self.em);
        let natural = |need: &Need| need.natural[1] * self.em;
        let gap = self.gap();
        let mut needs = needs.to_vec();
        let sum = |needs: &[&Need], of: &dyn Fn(&Need) -> f32| -> f32 {
            needs.iter().map(|need| of(need) + gap).sum()
        };
        while !needs.is_empty() && sum(&needs, &least) > room {
            needs.pop();
        }
        let (low, high) = (sum(&needs, &least), sum(&needs, &natural));
        let part = if high > room {
            (room - low) / (high - low)
        } else {
            1.0
        };
        let height = |need: &&Need| least(need) + part * (natural(need) - least(need));
        needs.iter().map(height).collect()
    }
}

fn least_height(way: Way, drawing: &Need, height: f32) -> f32 {
    let least = drawing.least[1] * READABLE;
    match way {
        Way::Beside | Way::Under | Way::Narrow => least.max(DRAWING[1] * height),
        Way::Low => least,
    }
}
