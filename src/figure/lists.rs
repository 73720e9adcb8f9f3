//! Vertex lists beside each other, and what links them.

use crate::text::Value;

use super::{Link, Role};

/// Lists side by side, from left to right.
#[derive(Clone, PartialEq, Debug)]
pub struct Lists {
    /// At least one.
    pub lists: Vec<List>,
    /// Between entries of neighbouring lists.
    pub links: Vec<ListLink>,
}

/// One list, from top to bottom.
#[derive(Clone, PartialEq, Debug)]
pub struct List {
    /// Over it: "Subject list".
    pub title: Value,
    /// All of them, however many: a view folds what it has no room for, and says so.
    pub entries: Vec<ListEntry>,
    /// Does the last lead back to the first?
    pub is_ring: bool,
    /// The entry that must be seen: where the step is.
    pub focus: Option<usize>,
}

/// One entry.
#[derive(Clone, PartialEq, Debug)]
pub struct ListEntry {
    /// `S₃`, `I₁`.
    pub name: Value,
    /// What is said of it: its place, a distance, a word.
    pub detail: Option<Value>,
    /// The mark that the same thing has in the drawing.
    pub marker: Option<Marker>,
    /// [`Role::Signal`] for this step's, [`Role::Accent`] for what has been walked or kept, [`Role::Discarded`] for
    /// what is dropped, [`Role::Ink`] for what counts, else [`Role::Soft`].
    pub role: Role,
    /// What it is about.
    pub link: Option<Link>,
}

/// The mark before an entry, as in the drawing.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Marker {
    /// Filled: entering, inside, convex.
    Dot,
    /// Hollow: leaving, outside, reflex.
    Ring,
}

/// From an entry to one of another list: each `[list, entry]`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ListLink {
    /// Where it begins.
    pub from: [usize; 2],
    /// Where it ends.
    pub to: [usize; 2],
    /// [`Role::Signal`] for the one that is taken now: a thick arrow; else a dashed hairline.
    pub role: Role,
}

impl ListEntry {
    /// An entry of little weight.
    #[must_use]
    pub fn new(name: impl Into<Value>) -> Self {
        Self {
            name: name.into(),
            detail: None,
            marker: None,
            role: Role::Soft,
            link: None,
        }
    }
}
