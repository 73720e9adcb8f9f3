//! What a person can do to the lines lab's scene.

use std::fmt;

use crate::{
    algo::line::BitOrder,
    geom::{GeomError, Segment},
    labs::lines::{Handle, Method, Scene, SceneError},
    lesson::random_segments,
};

/// One change to the scene.
#[derive(Clone, PartialEq, Debug)]
pub enum LinesEdit {
    /// Clip with another method.
    Method(Method),
    /// Put another method beside it, or none.
    Compare(Option<Method>),
    /// Write outcodes in another order.
    BitOrder(BitOrder),
    /// Move a handle.
    Drag(Handle, [f64; 2]),
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
    /// Another scene altogether.
    Replace(Box<Scene>),
}

/// Why a change is not made: the scene is as it was.
#[derive(Clone, Debug)]
pub enum EditError {
    /// The shapes would not be valid.
    Geom(GeomError),
    /// The document would not be valid.
    Scene(SceneError),
}

impl fmt::Display for EditError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Geom(error) => error.fmt(f),
            Self::Scene(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for EditError {}

impl From<GeomError> for EditError {
    fn from(error: GeomError) -> Self {
        Self::Geom(error)
    }
}

impl From<SceneError> for EditError {
    fn from(error: SceneError) -> Self {
        Self::Scene(error)
    }
}

impl LinesEdit {
    /// Makes the change.
    ///
    /// # Errors
    /// [`EditError`] where the scene would not be valid: it is left as it was.
    pub fn apply(self, scene: &mut Scene) -> Result<(), EditError> {
        match self {
            Self::Method(method) => {
                scene.method = method;
                scene.compare = scene.compare.filter(|&other| other != method);
            }
            Self::Compare(other) => scene.compare = other,
            Self::BitOrder(order) => scene.bit_order = order,
            Self::Drag(handle, to) => handle.drag(scene, to)?,
            Self::Focus(segment_idx) => scene.set_focus(segment_idx),
            Self::Add => scene.add_segment(beside(scene)?)?,
            Self::Remove => scene.remove_focused(),
            Self::Random { count, seed } => {
                scene.set_segments(random_segments(&scene.window, count, seed))?;
            }
            Self::Replace(other) => *scene = *other,
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
