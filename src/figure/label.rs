//! Text beside a mark.

use crate::text::Value;

/// Text beside a mark. The painter finds a place near the anchor where it covers nothing.
#[derive(Clone, PartialEq, Debug)]
pub struct Label {
    /// What it says.
    pub text: Value,
    /// Set in the monospaced face: codes and numbers.
    pub mono: bool,
    /// The one thing that matters here: semibold.
    pub strong: bool,
    /// The direction, in the world, in which it has to stand off its mark; for an inequality, where it holds.
    pub toward: Option<[f64; 2]>,
    /// The character, by its index, that is this step's: drawn in the signal's colour, as one bit of a code.
    pub lit: Option<usize>,
}

impl Label {
    pub(super) fn new(text: impl Into<Value>, mono: bool) -> Self {
        Self {
            text: text.into(),
            mono,
            strong: false,
            toward: None,
            lit: None,
        }
    }
}
