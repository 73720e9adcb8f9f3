//! What is drawn of an answer that is wrong.

use serde_json::Value as Json;

/// All that was said, however long it is, all that is true, and where they differ.
pub(super) struct Whole {
    pub said: Json,
    pub truth: Json,
    /// Such as `segment[2]`; empty where nothing is named.
    pub path: String,
    /// What is true there, and what was said; null where there is nothing.
    pub parts: [Json; 2],
    /// Of the true run, from 1; none of an output.
    pub step: Option<usize>,
}

impl Whole {
    /// The name that its path begins with.
    pub(super) fn field(&self) -> &str {
        let end = self.path.find(['[', '.']).unwrap_or(self.path.len());
        &self.path[..end]
    }

    /// The first number of its path: which of a list differs.
    pub(super) fn nth(&self) -> Option<usize> {
        let (_, rest) = self.path.split_once('[')?;
        rest.split_once(']')?.0.parse().ok()
    }

    pub(super) const fn each(&self) -> [(&Json, bool); 2] {
        [(&self.truth, true), (&self.said, false)]
    }
}
