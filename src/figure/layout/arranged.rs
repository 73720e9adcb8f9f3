//! How good an arrangement is: by the views that it has room for, and by how large its drawings are.

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
    /// How long the sides of the drawings are, in points, multiplied: of two, none is large at the cost of the other.
    pub scale: f32,
}

impl Arranged {
    pub fn new(how: How, views: Vec<Vec<(ViewId, Slot)>>, needs: &[Vec<Need>]) -> Self {
        let columns = views.iter().zip(needs);
        let scale = columns.flat_map(|(views, needs)| {
            let drawn = views.iter().enumerate().filter_map(|(nth, (id, slot))| {
                let need = needs.iter().find(|need| need.id == *id)?;
                let is_first = nth == 0;
                let counts = is_first || need.stand == Stand::Drawing;
                let side = side(need.aspect?, *slot);
                // A drawing beside the first one is what the method makes: it counts for more.
                let weight = if is_first { 1.0 } else { side.sqrt() };
                counts.then_some(side * weight)
            });
            drawn.collect::<Vec<_>>()
        });
        let is_whole = views.iter().all(|views| !views.is_empty());
        let n_views = views.iter().map(Vec::len).sum();
        Self {
            how: Some(how),
            scale: scale.product(),
            n_views: if is_whole { n_views } else { 0 },
            views,
        }
    }

    pub fn has_all(&self, needs: &[Vec<Need>]) -> bool {
        self.n_views == needs.iter().map(Vec::len).sum::<usize>()
    }

    pub fn is_better_than(&self, other: &Self) -> bool {
        let is_larger = self.scale > CLEARLY * other.scale;
        self.n_views > other.n_views || self.n_views == other.n_views && is_larger
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
