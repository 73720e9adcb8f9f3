//! How good an arrangement is: by the views that it has room for, and by how large its drawings are.

use std::cmp::Reverse;

use super::{Slot, ViewId, groups::How};
use crate::figure::extent::{Need, Stand};

/// Around what is drawn, in points: labels stand there.
const AROUND: f32 = 24.0;
/// What is larger by less is no reason to stand elsewhere.
const CLEARLY: f32 = 1.03;

#[derive(Default)]
pub struct Arranged {
    pub how: Option<How>,
    /// Column by column, the drawing first.
    pub views: Vec<Vec<(ViewId, Slot)>>,
    pub n_views: usize,
    /// Those of text that is cut or set small, as they are less wide than they have to be.
    n_narrow: usize,
    /// How long the sides of the drawings are, in points, multiplied: of two, none is large at the cost of the other.
    pub scale: f32,
    /// The shortest side of a column's drawing, in points.
    pub least: f32,
}

impl Arranged {
    pub fn new(
        how: How,
        views: Vec<Vec<(ViewId, Slot)>>,
        (needs, readable): (&[Vec<Need>], f32),
    ) -> Self {
        let columns = views.iter().zip(needs);
        let all = columns.clone().flat_map(|(views, needs)| {
            let slot = |need: &Need| views.iter().find(|(id, _)| *id == need.id);
            needs
                .iter()
                .filter_map(move |need| Some((need, slot(need)?.1)))
        });
        let is_narrow = |(need, slot): &(&Need, Slot)| {
            need.aspect.is_none() && slot.size()[0] < how.0.turned(**need).least[0] * readable - 1.0
        };
        let n_narrow = all.filter(is_narrow).count();
        let is_equal = needs.iter().flatten().any(|need| need.is_equal);
        let sides = columns.flat_map(|(views, needs)| {
            let drawn = views.iter().enumerate().filter_map(|(nth, (id, slot))| {
                let need = needs.iter().find(|need| need.id == *id)?;
                let is_first = nth == 0;
                let counts = is_first || need.stand == Stand::Drawing;
                let side = side(need.aspect?, *slot);
                // A drawing beside the first one is what the method makes: it counts for more.
                let weight = if is_first || is_equal {
                    1.0
                } else {
                    side.sqrt()
                };
                counts.then_some(side * weight)
            });
            drawn.collect::<Vec<_>>()
        });
        let sides: Vec<f32> = sides.collect();
        let scale = if is_equal {
            let least = sides.iter().copied().reduce(f32::min).unwrap_or(1.0);
            least.powi(sides.len() as i32)
        } else {
            sides.iter().product()
        };
        let is_whole = views.iter().all(|views| !views.is_empty());
        let n_views = views.iter().map(Vec::len).sum();
        let drawings = views.iter().filter_map(|views| views.first());
        let sides = drawings.flat_map(|(_, slot)| slot.size());
        Self {
            least: sides.fold(f32::MAX, f32::min),
            how: Some(how),
            scale,
            n_views: if is_whole { n_views } else { 0 },
            n_narrow,
            views,
        }
    }

    pub fn has_all(&self, needs: &[Vec<Need>]) -> bool {
        self.n_views == needs.iter().map(Vec::len).sum::<usize>()
    }

    /// Has all of them room for their text?
    pub fn reads_all(&self, needs: &[Vec<Need>]) -> bool {
        self.has_all(needs) && self.n_narrow == 0
    }

    pub fn is_better_than(&self, other: &Self) -> bool {
        let is_larger = self.scale > CLEARLY * other.scale;
        let [own, others] = [self, other].map(|it| (it.n_views, Reverse(it.n_narrow)));
        own > others || own == others && is_larger
    }
}

/// The side of a square as large as a drawing of this width over height is in a slot.
fn side(aspect: f32, slot: Slot) -> f32 {
    let [width, height] = slot.size().map(|side| (side - 2.0 * AROUND).max(1.0));
    let width = width.min(aspect * height);
    width / aspect.sqrt()
}

pub fn drawings(needs: &[Need]) -> Vec<Need> {
    let drawings = needs.iter().filter(|need| need.is_drawing());
    drawings.copied().collect()
}

/// The last view that is no drawing goes; is there one?
pub fn drop_last(needs: &mut Vec<Need>) -> bool {
    let last = needs.iter().rposition(|need| !need.is_drawing());
    last.map(|last| needs.remove(last)).is_some()
}
