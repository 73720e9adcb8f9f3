//! Kinds of input, the fields that they stand in, what is told of them, and why a value is refused.

use crate::{
    geom::{Axis, GeomError, SpaceError},
    text::{Diagnostic, Message, Value},
};

use super::got::Got;

/// How many entries a list has.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Dim {
    Exactly(usize),
    /// Any number; a report of every step takes at most so many.
    UpTo(usize),
}

impl Dim {
    pub const ANY: Self = Self::UpTo(usize::MAX);
}

/// What a value looks like, before it is known what it means.
#[derive(Clone, Copy, Debug)]
pub enum Shape {
    Bool,
    Number,
    /// A whole number, from the first to the last.
    Whole(i64, i64),
    Text,
    Word(&'static [&'static str]),
    /// Finite numbers in lists of lists, the outermost list first.
    Numbers(&'static [Dim]),
    /// Whole numbers in the same way, each from the first to the last.
    Wholes(&'static [Dim], i64, i64),
    Table(&'static Table),
    List(&'static Shape),
    OrNull(&'static Shape),
}

impl Shape {
    pub const POINT: Self = Self::Numbers(&[Dim::Exactly(2)]);
    pub const PLACE: Self = Self::Numbers(&[Dim::Exactly(3)]);
    pub const POINTS: Self = Self::Numbers(&[Dim::ANY, Dim::Exactly(2)]);
    pub const COUNT: Self = Self::Whole(0, i64::MAX);
    pub const COUNTS: Self = Self::Wholes(&[Dim::ANY], 0, i64::MAX);
}

/// A table of which only certain fields may be given.
#[derive(Debug)]
pub struct Table {
    pub name_key: &'static str,
    /// In the order in which they are checked.
    pub fields: &'static [Field],
    /// Catalogue key of what is said where a file gives two fields of which one is enough.
    pub both_key: &'static str,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Presence {
    Required,
    /// Exactly one of the fields of this kind.
    Choice,
    Optional,
}

/// A field of a case, of an answer, or of a table in one.
#[derive(Clone, Copy, Debug)]
pub struct Field {
    pub name: &'static str,
    pub need: Presence,
    pub shape: &'static Shape,
    tell: fn(&Got) -> Vec<Given>,
    tell_absent: fn() -> Vec<Given>,
}

impl Field {
    pub const fn new(name: &'static str, need: Presence, shape: &'static Shape) -> Self {
        Self {
            name,
            need,
            shape,
            tell: |_| Vec::new(),
            tell_absent: Vec::new,
        }
    }

    pub const fn required(name: &'static str, shape: &'static Shape) -> Self {
        Self::new(name, Presence::Required, shape)
    }

    pub const fn choice(name: &'static str, shape: &'static Shape) -> Self {
        Self::new(name, Presence::Choice, shape)
    }

    pub const fn optional(name: &'static str, shape: &'static Shape) -> Self {
        Self::new(name, Presence::Optional, shape)
    }

    pub const fn told(self, tell: fn(&Got) -> Vec<Given>) -> Self {
        Self { tell, ..self }
    }

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

    pub const fn expecting(self, expect: &'static str) -> Self {
        Self { expect, ..self }
    }

    pub const fn told(mut self, tell: fn(&Got) -> Vec<Given>) -> Self {
        self.optional = self.optional.told(tell);
        self
    }

    pub const fn told_absent(mut self, tell_absent: fn() -> Vec<Given>) -> Self {
        self.optional.tell_absent = tell_absent;
        self
    }

    pub const fn name(&self) -> &'static str {
        self.optional.name
    }

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

/// One thing that a problem gives: "clip window: −1 ≤ x ≤ 1, −1 ≤ y ≤ 1".
#[derive(Clone, PartialEq, Debug)]
pub struct Given {
    pub name_key: &'static str,
    /// Set one after the other: the first of them, as many as are shown.
    pub values: Vec<Value>,
    pub n_values: usize,
}

/// A polygon's vertices beyond these are not put into words.
const MAX_SHOWN: usize = 16;

impl Given {
    pub fn new(name_key: &'static str, values: impl ExactSizeIterator<Item = Value>) -> Self {
        Self {
            name_key,
            n_values: values.len(),
            values: values.take(MAX_SHOWN).collect(),
        }
    }

    #[must_use]
    pub fn only<const N: usize>(name_key: &'static str, values: [Value; N]) -> Vec<Self> {
        vec![Self::new(name_key, values.into_iter())]
    }
}

/// A place within a value.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum At {
    Whole,
    Entry(usize),
    Field(&'static str),
}

/// Why a value is refused, and where in it.
#[derive(Clone, PartialEq, Debug)]
pub struct Fault {
    pub at: At,
    /// Why; its code is the one that cases are refused by.
    pub what: Diagnostic,
}

impl Fault {
    pub fn new(code: &'static str, message: Message) -> Self {
        Self {
            at: At::Whole,
            what: Diagnostic::new(message).coded(code),
        }
    }

    pub fn at(self, at: At) -> Self {
        Self { at, ..self }
    }
}

impl From<GeomError> for Fault {
    fn from(error: GeomError) -> Self {
        let at = match error {
            GeomError::Degenerate { vertex_idx }
            | GeomError::NotConvex { vertex_idx }
            | GeomError::SelfIntersecting { vertex_idx } => At::Entry(vertex_idx),
            // Edge i starts from vertex i: the place is the first of the two.
            GeomError::EdgesMeet { edges: [i, _] } => At::Entry(i),
            GeomError::MisplacedHole { hole_idx } => At::Entry(hole_idx),
            GeomError::EmptyWindow { axis: Axis::X, .. } => At::Entry(0),
            GeomError::EmptyWindow { axis: Axis::Y, .. } => At::Entry(1),
            // The numbers were read one by one before: this names the place as well as it can.
            GeomError::NotFinite { .. } | GeomError::TooFewVertices => At::Whole,
        };
        let what = error.into();
        Self { at, what }
    }
}

impl From<SpaceError> for Fault {
    fn from(error: SpaceError) -> Self {
        Self {
            at: error.camera_field().map_or(At::Whole, At::Field),
            what: error.into(),
        }
    }
}
