//! Why a value of the right shape is refused.

use crate::{
    geom::{Axis, GeomError, SpaceError},
    text::{Diagnostic, Message},
};

/// A place within a value.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum At {
    /// The value as a whole.
    Whole,
    /// An entry of the list, from 0.
    Entry(usize),
    /// A field of the table.
    Field(&'static str),
}

/// Why a value is refused, and where in it.
#[derive(Clone, PartialEq, Debug)]
pub struct Fault {
    /// Where.
    pub at: At,
    /// Why; its code is the one that cases are refused by.
    pub what: Diagnostic,
}

impl Fault {
    /// Of a value as a whole, by this code.
    pub fn new(code: &'static str, message: Message) -> Self {
        Self {
            at: At::Whole,
            what: Diagnostic::new(message).coded(code),
        }
    }

    /// The same elsewhere in the value.
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
