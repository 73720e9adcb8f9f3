//! What lies over the window: the list of keys, the question where to save, messages.

use serde::{Deserialize, Serialize};

use crate::{paint::ThemeKind, text::Lang};

/// A dialog that is open.
#[derive(Clone, PartialEq, Debug)]
pub enum Dialog {
    /// The list of keys.
    Help,
    /// Where to save the scene.
    Save(Target),
    /// Where to export the figure, or those of all steps, and how they look.
    Export(Target, Figures),
}

/// A file to be written.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Target {
    /// As it is being typed.
    pub path: String,
    /// Another file stands there: it is replaced when the reader says so again.
    pub replaces: bool,
}

impl Target {
    /// A file that has not been asked about.
    #[must_use]
    pub const fn new(path: String) -> Self {
        Self {
            path,
            replaces: false,
        }
    }
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
    #[must_use]
    pub const fn slide(theme: ThemeKind, lang: Lang) -> Self {
        Self {
            size_px: Self::SIZES[1],
            theme,
            lang,
            all: false,
        }
    }
}
