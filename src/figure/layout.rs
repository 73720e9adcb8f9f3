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

mod arranged;
mod groups;
mod places;
mod stand;
#[cfg(test)]
mod tests;

use super::{extent::Need, view::ViewId};

use arranged::{Arranged, drawings, drop_last};
use groups::{How, Way};

pub use self::places::{Boundary, ColumnLayout, Slot};

/// What is read with text of this size, in points, is worth drawing, also where a theme has larger text.
const READABLE: f32 = 13.0;
/// What stands beside the drawing has its natural width, and only where nothing else has room a part of it.
const PARTS: [f32; 3] = [1.0, 0.85, 0.7];
/// A drawing that is smaller by less is as large.
const SAME: f32 = 0.99;
/// From the seats of a lecture hall, text that can be read is worth so much of a drawing that no page has to keep.
const SEATED: f32 = 0.8;
/// In a window, of a drawing's side.
const READ: f32 = 0.6;
/// There, a side of a drawing beside another method's, in points: it gives no more than that for text.
const BESIDE: f32 = 200.0;
/// The white space of a page, or of the window's stage.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Spacing {
    pub margin: f32,
    pub gutter: f32,
    /// White space that a view beside the drawing keeps from the edges of its column.
    pub inset: f32,
    /// A title on one line has so much room, whatever its size.
    pub titled: f32,
    pub name: f32,
    /// White space between the views and the hairline over the caption.
    pub over_caption: f32,
    /// Of columns side by side each drawing keeps so much of the side that it has alone.
    pub keeps: f32,
    /// It cannot be enlarged: where nothing else has room, all views are low.
    pub is_fixed: bool,
    /// It is held in one hand: all stands under its drawing, the last of it as long as that stays large.
    pub is_tall: bool,
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
    /// What stands beside the drawing, or under it, is so many times as large as it is where nobody has moved the boundary.
    pub board: f32,
    /// What comes and goes over the area takes so much of its height away: it moves nothing to another side.
    pub taken: f32,
}

#[derive(Clone, PartialEq, Debug, Default)]
pub struct Layout {
    pub title: Slot,
    /// As far as there was room.
    pub board: f32,
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
        let settled = Self {
            board: 1.0,
            ..*self
        };
        let (needs, settled) = settled.settled(&stages, needs);
        let (views, board) = self.moved(settled, &stages, &needs);
        for (column, views) in columns.iter_mut().zip(views) {
            column.views = views;
        }
        Layout {
            title,
            board,
            columns,
        }
    }

    /// The needs that all have room, and how they stand. In a window, whose text has a least size, with the room that all of their
    /// text has then, if there is as much and no drawing is much smaller for it; else rows are folded, else columns left out.
    fn settled(&self, stages: &[Slot], needs: &[Vec<Need>]) -> (Vec<Vec<Need>>, Arranged) {
        const SIDES: [[bool; 2]; 3] = [[true, true], [true, false], [false, true]];
        let wanting = |sides: [bool; 2]| {
            let need = |need: &Need| {
                let whole = [0, 1].map(|i| if sides[i] { need.whole[i] } else { 0.0 });
                let least = [0, 1].map(|i| need.least[i].max(whole[i]));
                Need {
                    least,
                    whole,
                    ..*need
                }
            };
            let needs = needs.iter().map(|needs| needs.iter().map(need).collect());
            let needs: Vec<Vec<Need>> = needs.collect();
            let arranged = self.settle(stages, &needs);
            (needs, arranged)
        };
        let is_more = |need: &Need| (0..2).any(|i| need.whole[i] > need.least[i]);
        let has_more = self.spacing.is_fixed && needs.iter().flatten().any(is_more);
        let plain = wanting([false, false]);
        let least = plain.1.scale * READ.powi(stages.len() as i32);
        let is_read = |(needs, arranged): &(Vec<Vec<Need>>, Arranged)| {
            arranged.reads_all(needs)
                && arranged.scale >= least
                && (stages.len() < 2 || arranged.least >= BESIDE || arranged.scale >= plain.1.scale)
        };
        let mut tried = SIDES.into_iter().filter(|_| has_more).map(wanting);
        tried.find(is_read).unwrap_or(plain)
    }

    /// The views in the way in which they stand where nothing has been taken away, as long as they have room.
    fn settle(&self, stages: &[Slot], needs: &[Vec<Need>]) -> Arranged {
        let whole = |stage: &Slot| Slot {
            min: [stage.min[0], stage.min[1] - self.taken],
            ..*stage
        };
        if self.taken > 0.0 {
            let whole: Vec<Slot> = stages.iter().map(whole).collect();
            let mut settled = self.views(&whole, needs);
            let views = settled.how.map(|how| self.views_in(how, stages, needs));
            let views = views.unwrap_or_default();
            let ids = |views: &[Vec<(ViewId, Slot)>]| -> Vec<ViewId> {
                views.iter().flatten().map(|(id, _)| *id).collect()
            };
            if ids(&views) == ids(&settled.views) {
                settled.views = views;
                return settled;
            }
        }
        self.views(stages, needs)
    }

    /// The same views in the same way, with the boundary as near to where it was dragged as they have room.
    fn moved(
        &self,
        settled: Arranged,
        stages: &[Slot],
        needs: &[Vec<Need>],
    ) -> (Vec<Vec<(ViewId, Slot)>>, f32) {
        const ROUNDS: usize = 10;
        let n_views = |views: &[Vec<_>]| views.iter().map(Vec::len).sum::<usize>();
        let Some(how) = settled.how else {
            return (settled.views, 1.0);
        };
        let at = |board: f32| {
            let views = Self { board, ..*self }.views_in(how, stages, needs);
            (n_views(&views) == n_views(&settled.views)).then_some((views, board))
        };
        if (self.board - 1.0).abs() < f32::EPSILON {
            return (settled.views, 1.0);
        }
        let mut best = at(self.board);
        let [mut fits, mut misses] = [1.0, self.board];
        // Where there is no room for that much: half way between what fits and what does not, and again.
        for _ in 0..(if best.is_none() { ROUNDS } else { 0 }) {
            let tried = f32::midpoint(fits, misses);
            match at(tried) {
                Some(found) => (fits, best) = (tried, Some(found)),
                None => misses = tried,
            }
        }
        best.unwrap_or((settled.views, 1.0))
    }

    /// The views of all columns, arranged so that the drawings are as large as they can be. Where text is larger it shrinks,
    /// and views go from the last on, before a drawing is smaller than it is beside text of the readable size; and where
    /// methods stand side by side, before it is much smaller than it is alone.
    fn views(&self, stages: &[Slot], needs: &[Vec<Need>]) -> Arranged {
        let readable = Self {
            em: self.em.min(READABLE),
            ..*self
        };
        // Who looks into a window may choose another theme, or one method; a page is as it is, and in one hand nothing stands aside.
        let is_tall = self.spacing.is_tall;
        let may_go = !self.spacing.is_fixed || is_tall;
        let wanted = if may_go && (is_tall || needs.len() > 1) {
            let alone = readable.largest(
                stages,
                &needs
                    .iter()
                    .map(|needs| drawings(needs))
                    .collect::<Vec<_>>(),
            );
            alone.scale * self.spacing.keeps.powi(needs.len() as i32)
        } else {
            let all = readable.largest(stages, needs);
            if self.em <= READABLE {
                return all;
            }
            let least = if self.spacing.is_fixed { SEATED } else { SAME };
            least * all.scale
        };
        let mut needs = needs.to_vec();
        let mut best = Arranged::default();
        loop {
            for part in PARTS {
                let arranged = self.largest_of(part, stages, &needs);
                if arranged.has_all(&needs) && arranged.scale >= wanted {
                    return arranged;
                }
                if arranged.is_better_than(&best) {
                    best = arranged;
                }
            }
            let fewer = needs.iter_mut().map(drop_last);
            if !may_go || !fewer.fold(false, |any, has_one| any | has_one) {
                return best;
            }
        }
    }

    /// Of all arrangements that have room for most views, the one with the largest drawings.
    fn largest(&self, stages: &[Slot], needs: &[Vec<Need>]) -> Arranged {
        let mut best = Arranged::default();
        for part in PARTS {
            let arranged = self.largest_of(part, stages, needs);
            if arranged.is_better_than(&best) {
                best = arranged;
            }
            if best.has_all(needs) {
                break;
            }
        }
        best
    }

    fn largest_of(&self, part: f32, stages: &[Slot], needs: &[Vec<Need>]) -> Arranged {
        let mut best = Arranged::default();
        for way in Way::ALL {
            if matches!(way, Way::Low | Way::Board) && !self.spacing.is_fixed {
                continue;
            }
            if self.spacing.is_tall && !matches!(way, Way::Under | Way::Low) {
                continue;
            }
            for share in way.shares(needs) {
                let how = (way, part, share);
                let views = self.views_in(how, stages, needs);
                let arranged = Arranged::new(how, views, (needs, self.readable()));
                if arranged.is_better_than(&best) {
                    best = arranged;
                }
            }
        }
        best
    }

    fn views_in(&self, how: How, stages: &[Slot], needs: &[Vec<Need>]) -> Vec<Vec<(ViewId, Slot)>> {
        let mut common = [f32::MAX; 2];
        let mut views = Vec::new();
        // The second time each drawing knows how large the others can be.
        for _ in 0..stages.len().min(2) {
            let columns = stages.iter().zip(needs);
            views = columns
                .map(|(&stage, needs)| self.stand(how, stage, needs, common))
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
}
