//! What a narrow window shows of itself.

use egui::Vec2;

use crate::{paint::Theme, widgets::transport_width};

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
    pub fn toggled(self, to: Self) -> Self {
        if self == to { Self::Stage } else { to }
    }
}

/// Is a window of this size narrow?
pub fn is_narrow(size: Vec2) -> bool {
    size.x < NARROW
}

/// Widths of the side panels: they leave the stage 60 % of 1280.
pub const COURSE: f32 = 216.0;
/// See above.
pub const INSPECTOR: f32 = 296.0;
/// Of the window's width the stage keeps three fifths.
const BESIDE: f32 = 0.4;

/// How much of the course stands beside the stage.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum CoursePart {
    /// Nothing.
    Hidden,
    /// The numbers of the lesson's steps.
    Strip,
    /// All of it.
    Whole,
}

/// Do the panels, as wide as this theme's text wants them, leave the stage too little of such a window?
pub fn wants_strip(theme: &Theme, width: f32) -> bool {
    (COURSE + INSPECTOR) * panel_scale(theme) > BESIDE * width
}

/// Larger text wants wider panels.
pub fn panel_scale(theme: &Theme) -> f32 {
    theme.text_scale.sqrt()
}

/// White space beside the transport of a narrow window.
pub const BESIDE_TRANSPORT: i8 = 4;

/// Is there room in `width` for the transport, a timeline and what stands after it?
pub fn transport_has_room(width: f32) -> bool {
    width > transport_width() + 260.0
}
