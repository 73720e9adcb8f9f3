//! What has come to one place, in order, and what was held there in between.

use crate::text::Value;

use super::{CellStage, Link, Role};

/// Comparisons in order of arrival, each with what stood there before it.
#[derive(Clone, PartialEq, Debug)]
pub struct Story {
    /// Over it: whose story.
    pub title: Value,
    /// All of them, from the start: what is to come is pale.
    pub cards: Vec<StoryCard>,
    /// What was held at first, and as it is written: it need not be finite.
    pub opening: (f64, Value),
    /// Over the stairs: what is held.
    pub held: Value,
    /// Beside the axis, at its lower end: towards what wins.
    pub down: Value,
    /// Do larger numbers win?
    pub is_reversed: bool,
}

/// One that has come.
#[derive(Clone, PartialEq, Debug)]
pub struct StoryCard {
    /// What it is called.
    pub name: Value,
    /// Its tone in the picture: whose, and how dark from 0 to 1.
    pub tone: (Role, f64),
    /// What it brings, and as it is written.
    pub new: (f64, Value),
    /// `< 0.7846`: how that compares to what stands there.
    pub against: Value,
    /// What becomes of it.
    pub fate: StoryFate,
    /// The same in a word.
    pub word: Value,
    /// How far the run has come.
    pub stage: CellStage,
    /// What it is about.
    pub link: Option<Link>,
}

/// What becomes of a [`StoryCard`].
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum StoryFate {
    /// It is held from now on.
    Kept,
    /// It is not.
    Lost,
    /// It is not, though it is as good as what is held.
    Tie,
}
