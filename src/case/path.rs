//! Places in a case, as refusals name them.

use std::fmt;

/// A place in a case: `segment`, `clip[1][0]`, `frustum.near`.
#[derive(Clone, Copy, Debug)]
pub enum Path<'a> {
    /// A field of the case.
    Field(&'a str),
    /// An element of a list, from 0.
    Index(&'a Path<'a>, usize),
    /// A field of an object inside.
    Member(&'a Path<'a>, &'a str),
}

impl fmt::Display for Path<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Field(name) => f.write_str(name),
            Self::Index(list, i) => write!(f, "{list}[{i}]"),
            Self::Member(object, name) => write!(f, "{object}.{name}"),
        }
    }
}
