//! What a narrow window shows of itself.

use egui::Vec2;

/// In windows narrower than this, in points, the course and the inspector take the stage's place.
const NARROW: f32 = 860.0;

/// The one place that a narrow window has room for.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Room {
    /// The stage.
    Stage,
    /// The course.
    Course,
    /// The inspector.
    Inspector,
}

impl Room {
    /// Opens a place, or the stage where it is open already.
    #[must_use]
    pub fn toggled(self, to: Self) -> Self {
        if self == to { Self::Stage } else { to }
    }
}

/// Is a window of this size narrow?
#[must_use]
pub fn is_narrow(size: Vec2) -> bool {
    size.x < NARROW
}
