//! Views of several small pictures or cards in a row: drawings at one scale, screens, spaces, what is left after each test,
//! and what has come to one place.

use crate::text::{Message, Value};

use super::{
    mark::Mark,
    role::{Link, Role},
    space::Space,
};

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

/// Screens from top to bottom. Each shows the square from −1 to 1, and as much beside it as all of them do.
#[derive(Clone, PartialEq, Debug)]
pub struct Screens {
    /// At least one.
    pub screens: Vec<Screen>,
}

/// One of them.
#[derive(Clone, PartialEq, Debug)]
pub struct Screen {
    /// Over it: "Clip first".
    pub title: Value,
    /// After the title: what is seen there.
    pub note: Message,
    /// Of the note.
    pub role: Role,
    /// After the divide.
    pub marks: Vec<Mark>,
}

impl Screens {
    /// What is seen of the plane of the screen.
    pub const SEEN: [[f64; 2]; 2] = [[-2.5, -1.3], [2.5, 1.3]];
}

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
