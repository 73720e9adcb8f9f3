//! Whose planes a tree is built of, and how large it may become.

/// Whose plane is taken.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum BspChoice {
    /// That of the first in the list.
    #[default]
    First,
    /// Of the first few, that which cuts the fewest.
    FewestCuts,
}

impl BspChoice {
    /// So many are compared.
    pub const MOST_CANDIDATES: usize = 8;
}

/// It would come to too many pieces, or to too many questions.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct BspTooLarge;

impl BspTooLarge {
    /// So many pieces are taken.
    pub const MOST_PIECES: usize = 65_536;
    /// So many pieces are asked on which side of a plane they lie.
    pub const MOST_QUESTIONS: usize = 4_000_000;
}
