//! How much is left after each of several tests: a band that narrows from gate to gate.

use crate::text::Message;

/// A band from left to right, as high as there is left to do.
#[derive(Clone, PartialEq, Debug)]
pub struct Ribbon {
    /// The parts, with a gate between each two.
    pub stages: Vec<RibbonStage>,
    /// The stage whose gate is at work: the one in front of it.
    pub at_work: Option<usize>,
    /// The most that any stage of the whole run holds: the scale of all heights.
    pub most: usize,
}

/// What is left after a gate.
#[derive(Clone, PartialEq, Debug)]
pub struct RibbonStage {
    /// "in the scene", "after the spheres".
    pub title: Message,
    /// The counts in words: "10 objects  322 triangles".
    pub counts: Message,
    /// Its height.
    pub amount: usize,
    /// What the gate has taken away, or added: written at it, `−166`, once it is known.
    pub change: Option<i64>,
    /// Has the run not come here yet? Its counts are not told.
    pub is_to_come: bool,
}
