//! Kinds of input, and the fields that they stand in.

use super::{fault::Fault, given::Given, got::Got};

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

/// Must a field be there?
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Presence {
    /// Always.
    Required,
    /// Exactly one of the fields of this kind.
    Choice,
    /// It may be left out.
    Optional,
}

/// A field of a case, of an answer, or of a table in one.
#[derive(Clone, Copy, Debug)]
pub struct Field {
    /// As files spell it.
    pub name: &'static str,
    /// Must it be there?
    pub need: Presence,
    /// What its value looks like.
    pub shape: &'static Shape,
    /// What is told of its value.
    tell: fn(&Got) -> Vec<Given>,
    /// What is told where it is left out.
    tell_absent: fn() -> Vec<Given>,
}

impl Field {
    /// A field of which nothing is told.
    pub const fn new(name: &'static str, need: Presence, shape: &'static Shape) -> Self {
        Self {
            name,
            need,
            shape,
            tell: |_| Vec::new(),
            tell_absent: Vec::new,
        }
    }

    /// One that must be there.
    pub const fn required(name: &'static str, shape: &'static Shape) -> Self {
        Self::new(name, Presence::Required, shape)
    }

    /// One of several of which exactly one must be there.
    pub const fn choice(name: &'static str, shape: &'static Shape) -> Self {
        Self::new(name, Presence::Choice, shape)
    }

    /// One that may be left out.
    pub const fn optional(name: &'static str, shape: &'static Shape) -> Self {
        Self::new(name, Presence::Optional, shape)
    }

    /// The same, with what is told of its value.
    pub const fn told(self, tell: fn(&Got) -> Vec<Given>) -> Self {
        Self { tell, ..self }
    }

    /// What is told of this value, or of its absence.
    pub fn given(&self, got: Option<&Got>) -> Vec<Given> {
        got.map_or_else(self.tell_absent, self.tell)
    }
}

/// A kind of input: how it is spelt, what it means and what is told of it.
#[derive(Clone, Copy, Debug)]
pub struct Part<T> {
    /// Its field, which may be left out.
    pub optional: Field,
    /// What a value of its shape means.
    pub make: fn(&Got) -> Result<T, Fault>,
    /// Catalogue key of what was expected, as a mistake in a lesson file is told.
    pub expect: &'static str,
}

impl<T> Part<T> {
    /// One of which nothing is told.
    pub const fn new(
        name: &'static str,
        shape: &'static Shape,
        make: fn(&Got) -> Result<T, Fault>,
    ) -> Self {
        Self {
            optional: Field::optional(name, shape),
            make,
            expect: "expect-number",
        }
    }

    /// The same, with what a mistake in a lesson file says was expected.
    pub const fn expecting(self, expect: &'static str) -> Self {
        Self { expect, ..self }
    }

    /// The same, with what is told of it.
    pub const fn told(mut self, tell: fn(&Got) -> Vec<Given>) -> Self {
        self.optional = self.optional.told(tell);
        self
    }

    /// The same, with what is told where it is left out.
    pub const fn told_absent(mut self, tell_absent: fn() -> Vec<Given>) -> Self {
        self.optional.tell_absent = tell_absent;
        self
    }

    /// As files spell its field.
    pub const fn name(&self) -> &'static str {
        self.optional.name
    }

    /// Its field, which must be there.
    pub const fn required(&self) -> Field {
        let need = Presence::Required;
        Field {
            need,
            ..self.optional
        }
    }

    /// Its field, or another one in its place.
    pub const fn choice(&self) -> Field {
        let need = Presence::Choice;
        Field {
            need,
            ..self.optional
        }
    }
}
