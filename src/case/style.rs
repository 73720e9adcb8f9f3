//! What is written of each case, and how.

use crate::text::Lang;

/// What is written for each case.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Format {
    /// One answer a line.
    Json,
    /// Tables for a terminal.
    Text,
    /// An answer key to hand out.
    Markdown,
    /// The same page with blanks in place of what is found out.
    Worksheet,
}

/// How much of each case is written.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Detail {
    /// Every step.
    Steps,
    /// The answer and its cost.
    Answers,
}

impl Detail {
    /// A report of more steps, or of more pixels, is refused: each step is told with the picture so far.
    pub const MOST_STEPS: usize = 65_536;

    /// What a report would make too long is limited to `most`; an answer alone takes as much as a line holds.
    #[must_use]
    pub const fn limit(self, most: usize) -> usize {
        match self {
            Self::Steps => most,
            Self::Answers => usize::MAX,
        }
    }
}

/// How answers are written.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Style {
    /// For whom.
    pub format: Format,
    /// How much.
    pub detail: Detail,
    /// In which language; JSON is the same in all of them.
    pub lang: Lang,
}
