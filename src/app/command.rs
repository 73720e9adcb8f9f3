//! Everything that can be done, and the keys that do it.

use egui::{Key, Modifiers, Pos2};

use crate::{
    figure::{Link, ViewId},
    geom::Orbit,
    labs::{Edit, Handle, OutlineKind},
    lesson::CodeView,
    paint::ThemeKind,
    text::Lang,
    widgets::PanZoom,
};

use super::{dialog::Dialog, history::UndoGroup};

/// Something to be done: applied between frames, whether a key, a button or a drag asked for it.
#[derive(Clone, Debug)]
pub enum Command {
    /// So many steps on, or back.
    Step(isize),
    /// To a step.
    Seek(usize),
    /// To the first step.
    First,
    /// To the last one.
    Last,
    /// To the next phase, or back to the one before.
    Phase(isize),
    /// Play or pause.
    Play,
    /// Steps a second.
    Speed(f32),
    /// The scene and the view as the lesson has them.
    Reset,
    /// To the next step of the lesson, or back.
    Lesson {
        /// On or back.
        forward: bool,
    },
    /// Opens a step of a lesson, by its indices.
    Open([usize; 2]),
    /// To the lab with this id, where it was left.
    Lab(&'static str),
    /// Takes the scene along to the lab with this id.
    Adopt(&'static str),
    /// Shows the list of lessons, or the open one.
    Contents(bool),
    /// Shows the answer to the open step's question, or hides it.
    Answer(bool),
    /// From the course to the lab's free scene, or back.
    Free,
    /// Changes the scene.
    Edit(Edit, Option<UndoGroup>),
    /// One more of what the lab has many of.
    Add,
    /// One less.
    Remove,
    /// Takes hold of a vertex: what Insert and Delete are about.
    Select(Handle),
    /// Asks why this was kept or dropped; or nothing any more.
    Ask(Option<Link>),
    /// To the step that says so.
    Verdict,
    /// Opens the field in which the place of a handle is typed, or closes it.
    Type(Option<Handle>),
    /// The same where its place is shown.
    TypeAt(Handle, Pos2),
    /// The same of the handle that has the focus, or was taken hold of last.
    TypeChosen,
    /// What was typed is to be done.
    Typed,
    /// Begins an outline that is drawn by clicking.
    Draw(&'static OutlineKind),
    /// The same, by its place among those of the open lab.
    DrawNth(usize),
    /// Places its next point.
    Place([f64; 2]),
    /// Takes its last point back.
    TakeBack,
    /// Closes it: the scene changes.
    CloseOutline,
    /// The pointer has let go of what it dragged.
    EndGesture,
    /// Takes a change back.
    Undo,
    /// Makes it again.
    Redo,
    /// Asks which file to open, in the system's dialog where there is one.
    OpenFile,
    /// Asks where to save the scene, in the same way.
    Save,
    /// The same in the window, where the path is typed.
    TypePath(PathOf),
    /// In place of the open dialog, the system's.
    Browse,
    /// Asks where to export the figure.
    Export,
    /// Opens or closes a dialog.
    Show(Option<Dialog>),
    /// Does what the open dialog offers.
    Confirm,
    /// Opens or closes the list of keys.
    Help,
    /// Enters or leaves the presentation.
    Present,
    /// While presenting: the theme for a projector, or the one before.
    Projector,
    /// Leaves what is open: a dialog, the presentation.
    Cancel,
    /// Shows or hides the course.
    Course,
    /// Shows or hides the inspector.
    Inspector,
    /// Speaks another language.
    Language(Lang),
    /// Takes on another look.
    Theme(ThemeKind),
    /// Shows the pseudocode in another way.
    Code(CodeView),
    /// Handles keep to the grid, or not.
    Snap(bool),
    /// Looks elsewhere.
    View(ViewId, PanZoom),
    /// Goes round what a view of space shows.
    Turn(ViewId, Orbit),
    /// Looks at the whole scene.
    FitView,
    /// Looks nearer, or from farther away.
    Zoom(f64),
    /// Opens or closes the measured costs.
    Measure(bool),
    /// The messages have been read.
    Dismiss,
}

/// What a path is typed for.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum PathOf {
    /// To be opened.
    Opened,
    /// To be saved.
    Saved,
}

impl Command {
    /// May it be done while an outline is half drawn? The run does not move then, and nothing else is edited.
    pub(super) const fn goes_with_a_sketch(&self) -> bool {
        !matches!(
            self,
            Self::Step(_)
                | Self::Seek(_)
                | Self::First
                | Self::Last
                | Self::Phase(_)
                | Self::Verdict
                | Self::Play
                | Self::Add
                | Self::Remove
                | Self::Redo
        )
    }
}

/// One line of the table of keys.
pub struct Binding {
    /// What is done.
    pub command: Command,
    /// The keys that do it.
    pub keys: &'static [(Modifiers, Key)],
    /// Catalogue key of what the help says; lines with the same one are one line of the help.
    pub help: &'static str,
    /// Does it go on while the key is held?
    pub repeats: bool,
}

const NONE: Modifiers = Modifiers::NONE;
const SHIFT: Modifiers = Modifiers::SHIFT;
const CTRL: Modifiers = Modifiers::COMMAND;
const CTRL_SHIFT: Modifiers = Modifiers::COMMAND.plus(Modifiers::SHIFT);
/// A zoom by one key press.
const ZOOM: f64 = 1.25;

const fn held(command: Command, keys: &'static [(Modifiers, Key)], help: &'static str) -> Binding {
    Binding {
        command,
        keys,
        help,
        repeats: true,
    }
}

const fn once(command: Command, keys: &'static [(Modifiers, Key)], help: &'static str) -> Binding {
    Binding {
        command,
        keys,
        help,
        repeats: false,
    }
}

/// Every key, in the order of the help.
pub static BINDINGS: [Binding; 35] = [
    held(Command::Step(-1), &[(NONE, Key::ArrowLeft)], "help-step"),
    held(Command::Step(1), &[(NONE, Key::ArrowRight)], "help-step"),
    held(
        Command::Step(-10),
        &[(SHIFT, Key::ArrowLeft)],
        "help-step-ten",
    ),
    held(
        Command::Step(10),
        &[(SHIFT, Key::ArrowRight)],
        "help-step-ten",
    ),
    held(Command::Phase(-1), &[(CTRL, Key::ArrowLeft)], "help-phase"),
    held(Command::Phase(1), &[(CTRL, Key::ArrowRight)], "help-phase"),
    once(Command::First, &[(NONE, Key::Home)], "help-ends"),
    once(Command::Last, &[(NONE, Key::End)], "help-ends"),
    once(Command::Play, &[(NONE, Key::Space)], "help-play"),
    once(Command::Reset, &[(NONE, Key::R)], "help-reset"),
    once(
        Command::Lesson { forward: false },
        &[(NONE, Key::PageUp)],
        "help-lesson-step",
    ),
    once(
        Command::Lesson { forward: true },
        &[(NONE, Key::PageDown)],
        "help-lesson-step",
    ),
    once(Command::FitView, &[(NONE, Key::Num0)], "action-reset-view"),
    held(
        Command::Zoom(ZOOM),
        &[(NONE, Key::Plus), (NONE, Key::Equals)],
        "help-zoom",
    ),
    held(
        Command::Zoom(1.0 / ZOOM),
        &[(NONE, Key::Minus)],
        "help-zoom",
    ),
    held(Command::Undo, &[(CTRL, Key::Z)], "action-undo"),
    held(
        Command::Redo,
        &[(CTRL_SHIFT, Key::Z), (CTRL, Key::Y)],
        "action-redo",
    ),
    once(Command::Add, &[(NONE, Key::Insert)], "help-add"),
    once(Command::Remove, &[(NONE, Key::Delete)], "help-remove"),
    once(
        Command::DrawNth(0),
        &[(NONE, Key::D)],
        "action-draw-subject",
    ),
    once(Command::DrawNth(1), &[(NONE, Key::C)], "action-draw-clip"),
    once(Command::DrawNth(2), &[(NONE, Key::H)], "action-draw-hole"),
    once(
        Command::CloseOutline,
        &[(NONE, Key::Enter)],
        "help-draw-close",
    ),
    held(
        Command::TakeBack,
        &[(NONE, Key::Backspace)],
        "help-draw-back",
    ),
    once(Command::OpenFile, &[(CTRL, Key::O)], "action-open"),
    once(Command::Save, &[(CTRL, Key::S)], "action-save"),
    once(Command::Export, &[(CTRL, Key::E)], "action-export"),
    once(Command::Course, &[(NONE, Key::F6)], "help-course"),
    once(Command::Inspector, &[(NONE, Key::F7)], "help-inspector"),
    once(Command::Free, &[(NONE, Key::F8)], "action-free"),
    once(Command::TypeChosen, &[(NONE, Key::F2)], "help-type"),
    once(Command::Present, &[(NONE, Key::F5)], "action-present"),
    once(Command::Cancel, &[(NONE, Key::Escape)], "help-leave"),
    once(
        Command::Help,
        &[(NONE, Key::Questionmark), (NONE, Key::F1)],
        "action-help",
    ),
    once(Command::Measure(true), &[(CTRL, Key::M)], "cost-measure"),
];
