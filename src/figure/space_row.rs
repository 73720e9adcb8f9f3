//! Small pictures in a row, each of another space, and what leads from one to the next.

use crate::text::Value;

use super::{Link, Space};

/// Spaces from left to right; they keep their places.
#[derive(Clone, PartialEq, Debug)]
pub struct SpaceRow {
    /// At least one.
    pub cells: Vec<SpaceCell>,
    /// What leads from each to the next: one less than there are cells.
    pub arrows: Vec<Value>,
    /// The arrow that is at work.
    pub at_work: Option<usize>,
}

/// One space of a [`SpaceRow`].
#[derive(Clone, PartialEq, Debug)]
pub struct SpaceCell {
    /// Over it: "clip".
    pub name: Value,
    /// Its picture.
    pub space: Space,
    /// Under it, once known: where in it the vertex is.
    pub place: Option<Value>,
    /// How far the run has come.
    pub stage: CellStage,
    /// What it is about.
    pub link: Option<Link>,
}

/// How far a run has come with a [`SpaceCell`].
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum CellStage {
    /// Behind it.
    Done,
    /// The step is in it.
    Current,
    /// Pale: still to come.
    ToCome,
}
