//! Small drawings beside each other, at one scale: so that only what they show differs.

use crate::text::Value;

use super::{Link, Mark};

/// A row of small drawings of the plane.
#[derive(Clone, PartialEq, Debug)]
pub struct Multiples {
    /// From left to right; every one is there from the start, so that nothing moves.
    pub drawings: Vec<SmallDrawing>,
    /// What each of them shows, from and to: the same for all.
    pub bounds: [[f64; 2]; 2],
}

/// One of them.
#[derive(Clone, PartialEq, Debug)]
pub struct SmallDrawing {
    /// At the left over it.
    pub title: Value,
    /// At the right over it: `5 → 6`.
    pub note: Option<Value>,
    /// What it shows; without labels.
    pub marks: Vec<Mark>,
    /// Is it this step's? It has a frame.
    pub is_current: bool,
    /// Has the run not come here yet? Its words are pale, its marks have weights of their own.
    pub is_to_come: bool,
    /// What it is about.
    pub link: Option<Link>,
}
