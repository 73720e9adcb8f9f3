//! What panels may read.

use crate::{labs::Scene, lesson::CodeView, widgets::Look};

use super::{
    Dialog, Settings,
    bookmark::Bookmark,
    desk::Desk,
    notice::Notice,
    playback::Playback,
    room::{CoursePart, Room},
};

/// The app as its panels see it.
#[derive(Clone, Copy)]
#[allow(
    clippy::struct_excessive_bools,
    reason = "each is a question that panels ask, and none decides another"
)]
pub struct Model<'a> {
    /// Colours and words.
    pub look: Look<'a>,
    /// What is remembered.
    pub settings: &'a Settings,
    /// Where in the course.
    pub bookmark: &'a Bookmark,
    /// What was done on the other pages.
    pub desk: &'a Desk,
    /// The document.
    pub scene: &'a Scene,
    /// Another number after every change of it.
    pub revision: u64,
    /// Runs and cursor.
    pub playback: &'a Playback,
    /// How the pseudocode is shown.
    pub code: CodeView,
    /// Can costs be measured in its lab?
    pub measures: bool,
    /// Is it still the lesson's own scene?
    pub is_untouched: bool,
    /// Does the list of lessons stand in the lesson's place?
    pub lists_lessons: bool,
    /// Has the open step's text an answer, and is it shown?
    pub has_answer: bool,
    /// See above.
    pub is_answered: bool,
    /// Is there something to undo, and to redo?
    pub can_travel: [bool; 2],
    /// What a narrow window shows; else the stage.
    pub room: Room,
    /// What of the course stands beside the stage.
    pub course: CoursePart,
    /// Is the course a strip until it is asked for?
    pub has_strip: bool,
    /// Stage, caption and a small transport alone.
    pub is_presenting: bool,
    /// May the system have dialogs for files?
    pub has_file_dialogs: bool,
    /// The open dialog.
    pub dialog: Option<&'a Dialog>,
    /// Messages over the window.
    pub notices: &'a [Notice],
    /// Is the window with the measured costs open?
    pub is_measuring: bool,
    /// A narrow window, where only one place is shown.
    pub is_narrow: bool,
    /// Not high enough for comfort.
    pub is_low: bool,
}
