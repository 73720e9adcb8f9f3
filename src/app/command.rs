//! Everything that can be done, and the keys that do it.

use crate::labs::OutlineKind;

use super::{
    compose::Act,
    desk::{Page, SceneAct},
    dialog::Dialog,
    history::UndoGroup,
    prelude::*,
};

/// What is asked about, and in which column of the stage.
pub type AskedIn = (Link, usize);

/// Something to be done: applied between frames, whether a key, a button or a drag asked for it.
#[derive(Clone, Debug)]
pub enum Command {
    Step(isize),
    Seek(usize),
    Phase(isize),
    Play,
    /// Asks before every decision what comes, or no more.
    Practise,
    /// Answers the open question of the practice.
    Choose(usize),
    /// Has its answer shown.
    ShowMe,
    /// Has the open step ask once more.
    AskAgain,
    /// Do steps of lessons ask?
    AskInLessons(bool),
    /// Are answers of a practice marked when the run is done, and not one by one?
    MarkAtEnd(bool),
    /// A smaller scene with the same difference.
    Smaller,
    /// The next part of the hint towards the open step's goal.
    Hint,
    /// Another student is here: no step has been seen.
    Afresh,
    Speed(f32),
    Reset,
    Lesson {
        forward: bool,
    },
    /// Opens a step of a lesson, by its indices.
    Open([usize; 2]),
    Lab(&'static str),
    Adopt(&'static str),
    Contents(bool),
    /// The course that is built in, or that of a folder.
    OpenCourse(Option<String>),
    Answer(bool),
    /// Shows what the step asks under the stage, where its text is folded away; or no more.
    Question,
    Free,
    OpenPage(Page),
    /// The next free scene of the lab, or the one before.
    NextFree(bool),
    AskAboutScene(SceneAct),
    Edit(Edit, Option<UndoGroup>),
    Add,
    Remove,
    /// Takes hold of a vertex: what Insert and Delete are about.
    Select(Handle),
    /// Asks why this was kept or dropped; or nothing any more.
    Ask(Option<AskedIn>),
    Verdict,
    /// A handle's place, in a field at the pointer or beside the handle; or none any more.
    Type(Option<Handle>, Option<Pos2>),
    /// The same of the handle that has the focus, or was taken hold of last.
    TypeChosen,
    Typed,
    Draw(&'static OutlineKind),
    DrawNth(usize),
    Place([f64; 2]),
    TakeBack,
    CloseOutline,
    EndGesture,
    Undo,
    Redo,
    /// Asks which file to open, in the system's dialog where there is one.
    OpenFile,
    Save,
    /// In place of the open dialog, the system's.
    Browse,
    /// A scene file that was opened lately.
    OpenRecent(String),
    Export,
    CopyFigure,
    /// The same as the text of an SVG file.
    CopySvg,
    CopyLink,
    Show(Option<Dialog>),
    Confirm,
    Help,
    Present,
    /// The window with the notes for whoever presents, or none any more.
    Notes,
    /// Embedded in another page: all of it, in a page of its own.
    OpenWhole,
    /// While presenting: the theme for a projector, or the one before.
    Projector,
    Cancel,
    Course,
    Inspector,
    Language(Lang),
    Theme(ThemeKind),
    TextSize(f32),
    /// Larger text, or smaller; 0 as large as at first.
    TextStep(isize),
    Code(CodeView),
    /// Opens a section of what can be set, by its id, or none.
    Section(Option<&'static str>),
    /// Leads to a control, by its id, or to the first of a section.
    Control(&'static str),
    Snap(bool),
    /// What stands beside the drawings is so many times as large as it is at first.
    Board(f32),
    View(ViewId, PanZoom),
    Turn(ViewId, Orbit),
    FitView,
    /// The camera's picture beside the observer's, as large, or in its corner.
    Picture,
    Zoom(f64),
    Measure(bool),
    /// About the lesson that is made.
    Compose(Act),
    Dismiss,
}

impl Command {
    pub const FIRST: Self = Self::Seek(0);
    pub const LAST: Self = Self::Seek(usize::MAX);

    /// May it be done while an outline is half drawn? The run does not move then, and nothing else is edited.
    pub(super) const fn goes_with_a_sketch(&self) -> bool {
        !matches!(
            self,
            Self::Step(_)
                | Self::Seek(_)
                | Self::Phase(_)
                | Self::Verdict
                | Self::Play
                | Self::Practise
                | Self::Add
                | Self::Remove
                | Self::Redo
        )
    }

    /// Is it for a clicker's keys, in whatever window they are pressed?
    pub(super) const fn is_of_a_presentation(&self) -> bool {
        matches!(
            self,
            Self::Lesson { .. }
                | Self::Step(_)
                | Self::Seek(_)
                | Self::Phase(_)
                | Self::Play
                | Self::Present
                | Self::Notes
        )
    }

    /// Is it what someone new is told to do?
    pub(super) const fn is_a_first_step(&self) -> bool {
        let walks = matches!(
            self,
            Self::Step(_) | Self::Seek(_) | Self::Phase(_) | Self::Play
        );
        // A drag by the pointer has been one when it ends: until then nothing moves under it.
        walks || matches!(self, Self::Edit(Edit::Drag(..), Some(UndoGroup::Nudge(_))))
    }

    /// Does it go on while the key is held?
    pub(super) const fn repeats(&self) -> bool {
        matches!(
            self,
            Self::Step(_)
                | Self::Phase(_)
                | Self::Zoom(_)
                | Self::TextStep(_)
                | Self::Undo
                | Self::Redo
                | Self::TakeBack
        )
    }
}

/// A key, what it does, and the catalogue key of what the help says; keys with the same one are one line of the help.
pub type Binding = (Modifiers, Key, Command, &'static str);

const NONE: Modifiers = Modifiers::NONE;
const SHIFT: Modifiers = Modifiers::SHIFT;
const CTRL: Modifiers = Modifiers::COMMAND;
const CTRL_SHIFT: Modifiers = Modifiers::COMMAND.plus(Modifiers::SHIFT);
/// By one key press.
const ZOOM: f64 = 1.25;
const BACK: Command = Command::Lesson { forward: false };
const ON: Command = Command::Lesson { forward: true };

const fn ask(act: SceneAct) -> Command {
    Command::AskAboutScene(act)
}

/// Every key, in the order of the help.
pub static BINDINGS: [Binding; 59] = [
    (NONE, Key::ArrowLeft, Command::Step(-1), "help-step"),
    (NONE, Key::ArrowRight, Command::Step(1), "help-step"),
    (SHIFT, Key::ArrowLeft, Command::Step(-10), "help-step-ten"),
    (SHIFT, Key::ArrowRight, Command::Step(10), "help-step-ten"),
    (CTRL, Key::ArrowLeft, Command::Phase(-1), "help-phase"),
    (CTRL, Key::ArrowRight, Command::Phase(1), "help-phase"),
    (NONE, Key::Home, Command::FIRST, "help-ends"),
    (NONE, Key::End, Command::LAST, "help-ends"),
    (NONE, Key::Space, Command::Play, "help-play"),
    (NONE, Key::Q, Command::Practise, "action-practise"),
    (NONE, Key::M, Command::Smaller, "action-smaller"),
    (NONE, Key::T, Command::Hint, "action-hint"),
    (NONE, Key::R, Command::Reset, "help-reset"),
    (NONE, Key::PageUp, BACK, "help-lesson-step"),
    (NONE, Key::PageDown, ON, "help-lesson-step"),
    (NONE, Key::Num0, Command::FitView, "action-reset-view"),
    (NONE, Key::V, Command::Picture, "action-picture"),
    (NONE, Key::Plus, Command::Zoom(ZOOM), "help-zoom"),
    (NONE, Key::Equals, Command::Zoom(ZOOM), "help-zoom"),
    (NONE, Key::Minus, Command::Zoom(1.0 / ZOOM), "help-zoom"),
    (CTRL, Key::Plus, Command::TextStep(1), "help-text"),
    (CTRL, Key::Equals, Command::TextStep(1), "help-text"),
    (CTRL, Key::Minus, Command::TextStep(-1), "help-text"),
    (CTRL, Key::Num0, Command::TextStep(0), "help-text"),
    (CTRL, Key::Z, Command::Undo, "action-undo"),
    (CTRL_SHIFT, Key::Z, Command::Redo, "action-redo"),
    (CTRL, Key::Y, Command::Redo, "action-redo"),
    (NONE, Key::Insert, Command::Add, "help-add"),
    (NONE, Key::Delete, Command::Remove, "help-remove"),
    (NONE, Key::D, Command::DrawNth(0), "action-draw-subject"),
    (NONE, Key::C, Command::DrawNth(1), "action-draw-clip"),
    (NONE, Key::H, Command::DrawNth(2), "action-draw-hole"),
    (NONE, Key::Enter, Command::CloseOutline, "help-draw-close"),
    (NONE, Key::Backspace, Command::TakeBack, "help-draw-back"),
    (CTRL, Key::O, Command::OpenFile, "action-open"),
    (CTRL, Key::S, Command::Save, "action-save"),
    (CTRL, Key::E, Command::Export, "action-export"),
    (CTRL_SHIFT, Key::C, Command::CopyFigure, "action-copy"),
    (CTRL_SHIFT, Key::L, Command::CopyLink, "action-link"),
    (NONE, Key::F6, Command::Course, "help-course"),
    (NONE, Key::F7, Command::Inspector, "help-inspector"),
    (NONE, Key::F8, Command::Free, "action-free"),
    (CTRL, Key::PageUp, Command::NextFree(false), "help-free"),
    (CTRL, Key::PageDown, Command::NextFree(true), "help-free"),
    (CTRL, Key::N, ask(SceneAct::New), "scene-new"),
    (CTRL, Key::D, ask(SceneAct::Copy), "scene-copy"),
    (SHIFT, Key::F2, ask(SceneAct::Rename), "scene-rename"),
    (CTRL, Key::Delete, ask(SceneAct::Delete), "scene-delete"),
    (NONE, Key::F2, Command::TypeChosen, "help-type"),
    (NONE, Key::F5, Command::Present, "action-present"),
    (NONE, Key::P, Command::Present, "action-present"),
    (NONE, Key::N, Command::Notes, "action-notes"),
    (NONE, Key::Escape, Command::Cancel, "help-leave"),
    (NONE, Key::Questionmark, Command::Help, "action-help"),
    (NONE, Key::F1, Command::Help, "action-help"),
    (CTRL, Key::M, Command::Measure(true), "cost-measure"),
    (
        CTRL,
        Key::Enter,
        Command::Compose(Act::Add(None)),
        "compose-add",
    ),
    (NONE, Key::F9, Command::Compose(Act::Try), "compose-try"),
    (
        NONE,
        Key::L,
        Command::Compose(Act::LockFocused),
        "compose-lock-focused",
    ),
];
