//! What lies over the window, or beside it: the list of keys, the question which file.

use serde::{Deserialize, Serialize};

use crate::{paint::ThemeKind, text::Lang};

/// A dialog that is open.
#[derive(Clone, PartialEq, Debug)]
pub enum Dialog {
    /// The list of keys.
    Help,
    /// Which file to open.
    Open(Target),
    /// Where to save the scene.
    Save(Target),
    /// Where to export the figure, or those of all steps, and how they look.
    Export(Target, Figures),
}

impl Dialog {
    /// The file that it is about.
    pub const fn target(&self) -> Option<&Target> {
        match self {
            Self::Help => None,
            Self::Open(target) | Self::Save(target) | Self::Export(target, _) => Some(target),
        }
    }

    /// The same, to be changed.
    pub const fn target_mut(&mut self) -> Option<&mut Target> {
        match self {
            Self::Help => None,
            Self::Open(target) | Self::Save(target) | Self::Export(target, _) => Some(target),
        }
    }
}

/// A file to be read or written.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Target {
    /// As it is being typed.
    pub path: String,
    /// Another file stands there: it is replaced when the reader says so again.
    pub replaces: bool,
}

impl Target {
    /// A file that has not been asked about.
    pub const fn new(path: String) -> Self {
        Self {
            path,
            replaces: false,
        }
    }
}

/// What a dialog of the system is opened for.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Question {
    /// Over it.
    pub title: String,
    /// What is suggested; to open a file, the folder it is looked for in counts.
    pub path: String,
    /// Is a file to be opened, or to be written?
    pub opens: bool,
    /// How the names of such files end: `toml`.
    pub endings: &'static [&'static str],
}

/// What came of a dialog of the system.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Answer {
    /// This file; where it is to be written and there was one, the reader has said that it is to be replaced.
    Chosen(String),
    /// None: the dialog was closed.
    Cancelled,
    /// This system has no such dialog.
    NoDialog,
}

/// How exported figures look, and which they are.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct Figures {
    /// Width and height in pixels.
    pub size_px: [u32; 2],
    /// Colours and weights.
    pub theme: ThemeKind,
    /// The language of captions.
    pub lang: Lang,
    /// Every step of the run, or the one that is shown.
    pub all: bool,
}

impl Figures {
    /// The sizes to choose from: a small slide, a slide, a large screen.
    pub const SIZES: [[u32; 2]; 3] = [[1280, 720], [1920, 1080], [3840, 2160]];

    /// A slide of the step that is shown.
    pub const fn slide(theme: ThemeKind, lang: Lang) -> Self {
        Self {
            size_px: Self::SIZES[1],
            theme,
            lang,
            all: false,
        }
    }
}
