//! OR and AND of both ends' outcodes, as a row of bits.

use crate::{
    figure::{BitRow, Role},
    text::Message,
};

use super::words::name;

/// What is made of both codes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Operator {
    /// 0 where both ends are inside.
    Or,
    /// Not 0 where both ends lie beyond one side.
    And,
}

impl Operator {
    /// With its own of both results, OR first, once it is known.
    pub fn of<C: Copy>(self, [or, and]: [Option<C>; 2]) -> Option<(Self, C)> {
        let result = match self {
            Self::Or => or,
            Self::And => and,
        };
        result.map(|code| (self, code))
    }

    /// What its result decides.
    pub fn note(self) -> Message {
        Message::new(match self {
            Self::Or => "cs-note-or",
            Self::And => "cs-note-and",
        })
    }

    /// Its result under both codes, in the signal colour where it is this step's.
    pub fn row(self, bits: Vec<bool>, is_now: bool) -> BitRow {
        BitRow {
            name: name(match self {
                Self::Or => "OR",
                Self::And => "AND",
            }),
            bits,
            role: if is_now { Role::Signal } else { Role::Ink },
            link: None,
        }
    }
}
