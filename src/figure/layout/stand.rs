//! The views of one column in one way, on its stage.

use super::{
    READABLE, Sheet, Slot, ViewId,
    groups::{Groups, How, Way},
};
use crate::figure::extent::{Need, Stand};

/// Of its column's height a drawing keeps this part at least, and of its width.
const DRAWING: f32 = 0.42;
/// Over other drawings, where methods stand side by side.
const SHARED: f32 = 0.4;
/// Text is large from this many points on.
const LARGE_EM: f32 = 16.0;
/// Then a picture beside the first one has at least so many ems of text that is read: its title and notes take more of them.
const TITLED: f32 = 9.5;
const NARROW: f32 = 0.3;
const LOW: f32 = 0.82;
/// Between a drawing and what stands beside it, and under it; in ems.
const GAP: [f32; 2] = [2.5, 1.0];
/// Around what is drawn, in ems.
const AROUND: f32 = 4.0;
/// What stands beside a drawing that needs less width may be so much wider.
const SPREAD: f32 = 1.25;
/// And so much higher.
const APART: f32 = 1.4;

impl Sheet {
    /// The drawing, no larger than `most`, and then the others; none where what stands beside it has no room.
    pub(super) fn stand(
        &self,
        (way, part, share): How,
        mut stage: Slot,
        needs: &[Need],
        most: [f32; 2],
    ) -> Vec<(ViewId, Slot)> {
        let mut needs: Vec<Need> = needs.iter().map(|&need| way.turned(need)).collect();
        let mut drawings = needs.iter_mut().filter(|need| need.stand == Stand::Drawing);
        if self.has_large_text() && drawings.next().is_some() {
            drawings.for_each(|need| need.least[1] = need.least[1].max(TITLED));
        }
        let Some(groups) = Groups::of(&needs, way) else {
            return Vec::new();
        };
        let drawing = groups.drawing;
        let over = self.across(way, &mut stage, drawing, &groups.over, Slot::take_top);
        // Under drawings that are to be equal what is read is as low as it can be.
        let is_equal = needs.iter().any(|need| need.is_equal);
        let lowest = |need: &&Need| {
            let [width, height] = need.natural;
            let height = if is_equal { need.least[1] } else { height };
            Need {
                natural: [width, height],
                ..**need
            }
        };
        let across: Vec<Need> = groups.across.iter().map(lowest).collect();
        let across: Vec<&Need> = across.iter().collect();
        let across = self.across(way, &mut stage, drawing, &across, Slot::take_bottom);
        let side = self.side_width(&groups.beside, (part, share), stage.size()[0]);
        let Some((left, side)) = self.beside(stage, &groups, self.board * side) else {
            return Vec::new();
        };
        let Some(row) = self.row(&groups.row, part, left) else {
            return Vec::new();
        };
        let row_height = row.iter().map(|(_, slot)| slot.size()[1]);
        let row_height = row_height.fold(0.0, f32::max);
        let mut room = left;
        if row_height > 0.0 {
            // Numbers of the axes end above what stands below, where there is room for that.
            let clear = if self.has_large_text() {
                0.0
            } else {
                self.spacing.inset
            };
            room.take_bottom(row_height + self.gap() + clear);
        }
        let (drawn, under) = self.under(way, room, &groups, most);
        let mut slots = vec![(drawing.id, drawn)];
        slots.extend(under);
        slots.extend(row);
        slots.extend(self.side(side, &groups.beside));
        slots.extend(over);
        slots.extend(across);
        slots.extend(self.insets(drawn, &groups.insets));
        slots
    }

    /// Of a column's width, what stands beside the drawing is to have so much.
    fn side_width(&self, needs: &[&Need], (part, share): (f32, Option<f32>), width: f32) -> f32 {
        let Some(share) = share else {
            let widths = needs.iter().map(|need| self.width(need, part));
            return widths.fold(0.0, f32::max);
        };
        // Half of two that are to be equal is half of what the gap leaves.
        let gap = if are_equal(needs) {
            self.beside_gap()
        } else {
            0.0
        };
        share * (width - gap)
    }

    /// The drawing's part of a stage, and the part beside it, which takes what the drawing cannot fill.
    fn beside(&self, stage: Slot, groups: &Groups<'_>, side: f32) -> Option<(Slot, Slot)> {
        if groups.beside.is_empty() {
            return Some((stage, Slot::new(stage.max, [0.0; 2])));
        }
        let [width, height] = stage.size();
        let gap = self.beside_gap() + self.spacing.inset;
        let room = width - gap - side;
        let is_narrow = |need: &&Need| need.least[0] * self.readable() > side;
        if room < NARROW * width || groups.beside.iter().any(is_narrow) {
            return None;
        }
        // A drawing as high as the stage, and what is written around it.
        let filled = groups.drawing.aspect.map_or(room, |aspect| {
            aspect * (height - AROUND * READABLE) + AROUND * READABLE
        });
        let spare = (room - filled).clamp(0.0, (SPREAD - 1.0) * side);
        let spare = if self.board < 1.0 { 0.0 } else { spare };
        let x = (stage.max[0] - side - spare).round();
        let inset = self.spacing.inset;
        let mut left = Slot {
            max: [(x - gap + inset).round(), stage.max[1]],
            ..stage
        };
        if are_equal(&groups.beside) {
            // Rounding makes none of them larger.
            left.max[0] = left.max[0].min(left.min[0] + (stage.max[0] - x).floor());
        }
        let beside = Slot {
            min: [x - inset, stage.min[1] + inset],
            max: [stage.max[0] - inset, stage.max[1] - inset],
        };
        Some((left, beside))
    }

    /// Side by side at the foot of the stage, each as wide as it is by nature; none where they have no room.
    fn row(&self, needs: &[&Need], part: f32, stage: Slot) -> Option<Vec<(ViewId, Slot)>> {
        if needs.is_empty() {
            return Some(Vec::new());
        }
        let gap = self.beside_gap();
        let size = |need: &&Need| {
            let height = part * need.natural[1] * self.em;
            [
                self.width(need, part),
                height.max(need.least[1] * self.readable()),
            ]
        };
        let inset = self.spacing.inset;
        let room = stage.size()[0] - 2.0 * inset;
        let widths: f32 = needs.iter().map(|need| size(need)[0]).sum();
        let gaps = gap * needs.len().saturating_sub(1) as f32;
        let heights = needs.iter().map(|need| size(need)[1]);
        let height = heights.fold(0.0, f32::max);
        let most = (1.0 - DRAWING) * stage.size()[1];
        let least = needs.iter().map(|need| need.least[1] * self.readable());
        if widths + gaps > room || least.clone().fold(0.0, f32::max) > most {
            return None;
        }
        let least = least.fold(0.0, f32::max);
        let height = (self.board * height.min(most)).clamp(least, most).round();
        let top = stage.max[1] - height - inset;
        let mut left = stage.min[0] + inset;
        let slots = needs.iter().map(|need| {
            let width = size(need)[0].round();
            let slot = Slot::new([left, top], [width, height]);
            left += width + gap;
            (need.id, slot)
        });
        Some(slots.collect())
    }

    /// The drawing, and the strips that stand under it.
    fn under(
        &self,
        way: Way,
        stage: Slot,
        groups: &Groups<'_>,
        most: [f32; 2],
    ) -> (Slot, Vec<(ViewId, Slot)>) {
        let [width, height] = stage.size();
        let inset = self.spacing.inset;
        let lowered: Vec<Need> = groups.under.iter().map(|need| way.lowered(need)).collect();
        let under: Vec<&Need> = lowered.iter().collect();
        let least_height = least_height(way, groups.drawing, height);
        let room = height - least_height - inset;
        let seen = &under[..self.heights(&under, room).len()];
        let least = |need: &&Need| need.least[1] * self.readable() + self.gap();
        // As far as they all are seen, the drawing keeps half; over other drawings, in one of several columns, less.
        let is_one_of_several = most[1] < f32::MAX;
        let is_over_others = is_one_of_several && seen.iter().any(|need| need.aspect.is_some());
        let kept = if is_over_others { SHARED } else { 0.5 };
        let room = room.min(((1.0 - kept) * height).max(seen.iter().map(least).sum()));
        let mut strips = self.heights(seen, room);
        let gaps = self.gap() * strips.len() as f32;
        let most_strips = height - least_height - inset - gaps;
        let board = self.board.min(most_strips / strips.iter().sum::<f32>());
        for (strip, need) in strips.iter_mut().zip(&under) {
            *strip = (board * *strip).max(need.least[1] * self.readable());
        }
        let taken: f32 = strips.iter().map(|strip| strip + self.gap()).sum();
        let inset_under = if strips.is_empty() { 0.0 } else { inset };
        let high = (height - taken - inset_under).round();
        let drawn = Slot::new(stage.min, [width.min(most[0]), high.min(most[1])]);
        let mut below = Slot {
            min: [drawn.min[0] + inset, drawn.max[1]],
            max: [drawn.max[0] - inset, stage.max[1]],
        };
        below.take_top(self.gap());
        (drawn, self.stack(below, &under, &strips))
    }

    /// Over each other beside the drawing, at their natural heights. Of what is left other drawings have all; where there are none
    /// rows stand farther apart, and the last view has what that leaves.
    fn side(&self, side: Slot, needs: &[&Need]) -> Vec<(ViewId, Slot)> {
        let room = side.size()[1] + self.gap();
        let mut needs: Vec<Need> = needs.iter().map(|&&need| need).collect();
        let n_drawn = needs.iter().filter(|need| need.aspect.is_some()).count();
        for drawn in needs.iter_mut().filter(|need| need.aspect.is_some()) {
            // The others first, as they are by nature.
            drawn.natural[1] = drawn.least[1];
        }
        let needs: Vec<&Need> = needs.iter().collect();
        let mut heights = self.heights(&needs, room);
        let taken: f32 = heights.iter().map(|height| height + self.gap()).sum();
        if heights.len() == needs.len() && taken < room {
            let natural: f32 = heights.iter().sum();
            let most = if n_drawn == 0 { APART - 1.0 } else { 0.0 };
            let apart = (room - taken).min(most * natural);
            let left = (room - taken - apart) / n_drawn.max(1) as f32;
            let last = needs.len().saturating_sub(1);
            for (nth, height) in heights.iter_mut().enumerate() {
                let grows = match n_drawn {
                    0 => nth == last,
                    _ => needs[nth].aspect.is_some(),
                };
                *height += apart * *height / natural + if grows { left } else { 0.0 };
            }
        }
        self.stack(side, &needs, &heights)
    }

    fn insets(&self, drawing: Slot, needs: &[&Need]) -> Vec<(ViewId, Slot)> {
        let mut rest = drawing;
        let mut slots = Vec::new();
        for need in needs {
            let slot = rest.inset(need.natural, self.gap());
            slots.push((need.id, slot));
            rest.max[0] = slot.min[0];
        }
        slots
    }

    const fn has_large_text(&self) -> bool {
        self.spacing.is_fixed && self.em > LARGE_EM
    }

    fn beside_gap(&self) -> f32 {
        (GAP[0] * self.readable()).round()
    }

    fn gap(&self) -> f32 {
        GAP[1] * self.readable()
    }

    /// The size of text that is still read.
    pub(super) const fn readable(&self) -> f32 {
        READABLE.min(self.em)
    }

    fn width(&self, need: &Need, part: f32) -> f32 {
        let natural = if need.natural[0] < f32::MAX {
            part * need.natural[0]
        } else {
            LONGEST
        };
        (natural * self.em).max(need.least[0] * self.readable())
    }

    fn across(
        &self,
        way: Way,
        stage: &mut Slot,
        drawing: &Need,
        needs: &[&Need],
        take: fn(&mut Slot, f32) -> Slot,
    ) -> Vec<(ViewId, Slot)> {
        let [width, height] = stage.size();
        let has_room = |need: &&&Need| need.least[0] * READABLE <= width - 2.0 * self.spacing.inset;
        let needs: Vec<&Need> = needs.iter().filter(has_room).copied().collect();
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
            if need.aspect.is_none() {
                let natural = SPREAD * need.natural[0] * self.em;
                let most = natural.max(need.least[0] * self.readable());
                slot.max[0] = slot.max[0].min((slot.min[0] + most).round());
            }
            slots.push((need.id, slot));
            rest.take_top(self.gap());
        }
        slots
    }

    /// Each with a gap after it, between least and natural; the last ones get none where there is too little.
    fn heights(&self, needs: &[&Need], room: f32) -> Vec<f32> {
        let least = |need: &Need| need.least[1] * self.readable();
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

/// Of what may be as wide as the column, beside a drawing, in ems.
const LONGEST: f32 = 24.0;

impl Way {
    fn lowered(self, need: &Need) -> Need {
        let is_whole = need.whole[1] > 0.0 && need.least[1] >= need.whole[1];
        let part = if self == Self::Low && !is_whole {
            LOW
        } else {
            1.0
        };
        Need {
            least: [need.least[0], part * need.least[1]],
            ..*need
        }
    }
}

/// Is what stands beside the drawing to be as large?
fn are_equal(beside: &[&Need]) -> bool {
    beside.iter().any(|need| need.is_equal)
}

fn least_height(way: Way, drawing: &Need, height: f32) -> f32 {
    let least = drawing.least[1] * READABLE;
    if way == Way::Low {
        least
    } else {
        least.max(DRAWING * height)
    }
}
