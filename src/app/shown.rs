//! What the window shows of itself: what is open, and what it has been told of whoever sits before it.

use egui::Vec2;

use super::{
    Dialog,
    controls::Controls,
    prelude::*,
    room::{Room, Whereabouts},
    window::Before,
};

#[allow(
    clippy::struct_excessive_bools,
    reason = "each is open or not whatever the others are"
)]
#[derive(Default)]
pub struct Shown {
    pub size: Vec2,
    pub measures: bool,
    pub code: CodeView,
    pub controls: Controls,
    pub dialog: Option<Dialog>,
    pub is_measuring: bool,
    pub lists_lessons: bool,
    pub is_answered: bool,
    /// Is the question under the stage, where no lesson text is beside it?
    pub asks: bool,
    pub presenting: Option<Before>,
    /// A frame of another page shows what a presentation does, for ever.
    pub is_embedded: bool,
    pub has_notes: bool,
    /// Is the course open where it is a strip else?
    pub unfolded: bool,
    pub room: Room,
    /// Fingers have been seen.
    pub is_touched: bool,
    /// The language that is spoken once its texts are there.
    pub awaited: Option<Lang>,
    /// The mesh that is shipped could not be fetched.
    pub has_lost: bool,
    /// The theme that the context has been given, and how large its text is.
    pub theme: Option<(ThemeKind, f32)>,
    /// The least size of what is pressed, and whether nothing moves by itself, as the context has been told.
    pub hand: Option<(Vec2, bool)>,
    pub title: String,
    /// Where the camera's picture is as large as the observer's.
    pub large_picture: Option<Whereabouts>,
}
