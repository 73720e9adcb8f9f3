//! A table of what an algorithm has worked out, row by row.

use crate::text::{Formula, Message, Value};

use super::{Link, Role};

/// Rows and columns of values; every row is there from the start, so that nothing moves when it is filled.
#[derive(Clone, PartialEq, Debug)]
pub struct Table {
    /// Over the columns, the names' one first.
    pub header: Vec<Formula>,
    /// From top to bottom.
    pub rows: Vec<TableRow>,
    /// Rules under the table, those that apply at this step in ink.
    pub notes: Vec<TableNote>,
}

/// One row.
#[derive(Clone, PartialEq, Debug)]
pub struct TableRow {
    /// In the first column.
    pub name: Value,
    /// In the others.
    pub cells: Vec<Cell>,
    /// Is it this step's?
    pub is_current: bool,
    /// What it is about.
    pub link: Option<Link>,
}

/// One value, empty as long as it is not known.
#[derive(Clone, PartialEq, Debug)]
pub struct Cell {
    /// A number, a word.
    pub value: Option<Value>,
    /// [`Role::Signal`] where it was worked out at this step, [`Role::Ink`] where it was in this row,
    /// [`Role::Soft`] where it is what it was in the row above.
    pub role: Role,
    /// A bound that this row has moved: semibold.
    pub strong: bool,
}

/// A rule under a table: `p < 0 enters: u_min = max(u_min, r)`.
#[derive(Clone, PartialEq, Debug)]
pub struct TableNote {
    /// What it says.
    pub text: Message,
    /// Does it apply at this step?
    pub applies: bool,
}

impl Cell {
    /// A value that is there, or is not yet.
    #[must_use]
    pub fn new(role: Role, value: Option<impl Into<Value>>) -> Self {
        let value = value.map(Into::into);
        Self {
            value,
            role,
            strong: false,
        }
    }

    /// Set semibold: among what is in its row, the one that changed.
    #[must_use]
    pub const fn strong(mut self) -> Self {
        self.strong = true;
        self
    }
}
