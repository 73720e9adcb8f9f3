//! What values look like.

use super::Field;

/// How many entries a list has.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Dim {
    /// Exactly so many.
    Exactly(usize),
    /// Any number; a report of every step takes at most so many.
    UpTo(usize),
}

impl Dim {
    /// Any number, in a report too.
    pub const ANY: Self = Self::UpTo(usize::MAX);
}

/// What a value looks like, before it is known what it means.
#[derive(Clone, Copy, Debug)]
pub enum Shape {
    /// True or false.
    Bool,
    /// A finite number.
    Number,
    /// A whole number, from the first to the last.
    Whole(i64, i64),
    /// A text.
    Text,
    /// One of these words.
    Word(&'static [&'static str]),
    /// Finite numbers in lists of lists, the outermost list first.
    Numbers(&'static [Dim]),
    /// Whole numbers in the same way, each from the first to the last.
    Wholes(&'static [Dim], i64, i64),
    /// A table of fields.
    Table(&'static Table),
    /// A list of any length.
    List(&'static Shape),
    /// This, or null.
    OrNull(&'static Shape),
}

impl Shape {
    /// A point of the plane, or a place in a texture.
    pub const POINT: Self = Self::Numbers(&[Dim::Exactly(2)]);
    /// A place in space.
    pub const PLACE: Self = Self::Numbers(&[Dim::Exactly(3)]);
    /// Points of the plane.
    pub const POINTS: Self = Self::Numbers(&[Dim::ANY, Dim::Exactly(2)]);
    /// A whole number that counts, from 0.
    pub const COUNT: Self = Self::Whole(0, i64::MAX);
    /// Numbers that count, from 0.
    pub const COUNTS: Self = Self::Wholes(&[Dim::ANY], 0, i64::MAX);
}

/// A table of which only certain fields may be given.
#[derive(Debug)]
pub struct Table {
    /// Catalogue key of its name.
    pub name_key: &'static str,
    /// In the order in which they are checked.
    pub fields: &'static [Field],
    /// Catalogue key of what is said where a file gives two fields of which one is enough.
    pub both_key: &'static str,
}
