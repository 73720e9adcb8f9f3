//! What a person can do to the lines lab's scene.

use crate::{
    algo::line::BitOrder,
    geom::{GeomError, Segment},
    labs::lines::{Scene, random_segments},
    panels::EditError,
};

/// One change to the scene.
#[derive(Clone, PartialEq, Debug)]
pub enum LinesEdit {
    /// Write outcodes in another order.
    BitOrder(BitOrder),
    /// Step the clipping of another segment.
    Focus(usize),
    /// One more segment, and step it.
    Add,
    /// Take the focused segment out.
    Remove,
    /// Random segments in place of the present ones.
    Random {
        /// How many.
        count: usize,
        /// The same seed gives the same segments.
        seed: u64,
    },
}

impl LinesEdit {
    /// Does the change bring a scene that should be seen whole?
    #[must_use]
    pub const fn brings_another(&self) -> bool {
        matches!(self, Self::Random { .. })
    }

    /// Makes the change.
    ///
    /// # Errors
    /// [`EditError`] where the scene would not be valid: it is left as it was.
    pub fn apply(self, scene: &mut Scene) -> Result<(), EditError> {
        match self {
            Self::BitOrder(order) => scene.bit_order = order,
            Self::Focus(segment_idx) => scene.set_focus(segment_idx),
            Self::Add => scene.add_segment(beside(scene)?)?,
            Self::Remove => scene.remove_focused(),
            Self::Random { count, seed } => {
                scene.set_segments(random_segments(&scene.window, count, seed))?;
            }
        }
        Ok(())
    }
}

/// A segment a little off the focused one, so that it can be seen and taken hold of.
fn beside(scene: &Scene) -> Result<Segment, GeomError> {
    let [_, ymin, _, ymax] = scene.window.to_array();
    let by = 0.25 * (ymax - ymin);
    let [x1, y1, x2, y2] = scene.focused().to_array();
    Segment::new(x1, y1 + by, x2, y2 + by)
}
