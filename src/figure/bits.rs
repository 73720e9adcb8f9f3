//! Codes as bits, one over the other.

use crate::text::{Message, Value};

use super::{Link, Role};

/// Codes over each other, and what a bitwise operation makes of them.
#[derive(Clone, PartialEq, Debug)]
pub struct Bits {
    /// Over the columns: the names of the sides, in the order in which bits are written.
    pub columns: Vec<Value>,
    /// The codes, from top to bottom.
    pub rows: Vec<BitRow>,
    /// Under a line: what comes of them, once it is asked for.
    pub result: Option<BitRow>,
    /// The column that decides at this step: boxed through all rows.
    pub deciding: Option<usize>,
    /// A sentence under the rows.
    pub note: Option<Message>,
}

/// One code.
#[derive(Clone, PartialEq, Debug)]
pub struct BitRow {
    /// `P₁`, `AND`.
    pub name: Value,
    /// One a column, empty as long as they are not known.
    pub bits: Vec<bool>,
    /// [`Role::Signal`] where it was found at this step, else [`Role::Ink`].
    pub role: Role,
    /// What it is about.
    pub link: Option<Link>,
}
