//! What a person can do to the lines lab's scene, beyond what every lab knows.

use crate::{
    algo::line::BitOrder,
    geom::{Segment, distance_to_segment},
    labs::{ChangeOf, Click, Handle},
    text::Diagnostic,
};

use super::{Scene, random_segments};

/// One change to the scene.
#[derive(Clone, PartialEq, Debug)]
pub enum LinesChange {
    /// Write outcodes in another order.
    BitOrder(BitOrder),
    /// Step the clipping of another segment.
    Focus(usize),
    /// Random segments in place of the present ones.
    Random {
        /// How many.
        count: usize,
        /// The same seed gives the same segments.
        seed: u64,
    },
}

impl ChangeOf for LinesChange {
    type Of = Scene;

    fn make(&self, scene: &mut Scene) -> Result<Option<Handle>, Diagnostic> {
        match *self {
            Self::BitOrder(order) => scene.bit_order = order,
            Self::Focus(segment_idx) => scene.set_focus(segment_idx),
            Self::Random { count, seed } => {
                scene.set_segments(random_segments(&scene.window, count, seed))?;
            }
        }
        Ok(None)
    }

    fn is_another(&self) -> bool {
        matches!(self, Self::Random { .. })
    }
}

/// A segment a little off the focused one, so that it can be seen and taken hold of.
pub fn beside(scene: &Scene) -> Result<Segment, Diagnostic> {
    let [_, ymin, _, ymax] = scene.window.to_array();
    let by = 0.25 * (ymax - ymin);
    let [x1, y1, x2, y2] = scene.focused().to_array();
    Ok(Segment::new(x1, y1 + by, x2, y2 + by)?)
}

/// The segment that a click is on, unless it is in focus already.
pub fn clicked(scene: &Scene, click: &Click<'_>) -> Option<LinesChange> {
    other_under(scene, click).map(LinesChange::Focus)
}

/// The nearest segment within reach of a click, if it is not the one that is clipped.
pub fn other_under(scene: &Scene, click: &Click<'_>) -> Option<usize> {
    under(scene, click).filter(|&segment_idx| segment_idx != scene.focus())
}

/// The nearest segment within reach of a click.
pub fn under(scene: &Scene, click: &Click<'_>) -> Option<usize> {
    let [x, y, _] = click.at;
    let segments = scene.segments().iter().enumerate();
    let near = segments.filter_map(|(i, segment)| {
        let ends = [segment.p1.to_array(), segment.p2.to_array()];
        let distance = distance_to_segment([x, y], ends);
        (distance <= click.reach).then_some((distance, i))
    });
    let (_, nearest) = near.min_by(|a, b| a.0.total_cmp(&b.0))?;
    Some(nearest)
}
