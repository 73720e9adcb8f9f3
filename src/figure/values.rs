//! Views of the values that an algorithm holds: bits, tables, axes, a matrix times a vector, dot products, vertex lists.

use std::ops::Range;

use crate::{
    text::{Formula, Message, Value},
    trace::Counts,
};

use super::role::{Link, Role};

#[derive(Clone, PartialEq, Debug)]
pub struct Bits {
    /// Over the columns: the names of the sides, in the order in which bits are written.
    pub columns: Vec<Value>,
    /// What each column is about; empty where that is nothing that is drawn.
    pub links: Vec<Link>,
    pub rows: Vec<BitRow>,
    pub result: Option<BitRow>,
    pub deciding: Option<usize>,
    pub note: Option<Message>,
}

#[derive(Clone, PartialEq, Debug)]
pub struct BitRow {
    pub name: Value,
    /// One a column, empty as long as they are not known.
    pub bits: Vec<bool>,
    /// [`Role::Signal`] where it was found at this step, else [`Role::Ink`].
    pub role: Role,
    pub link: Option<Link>,
}

/// What methods cost on one input: of two, bars stand back to back.
#[derive(Clone, PartialEq, Debug)]
pub struct Costs {
    pub names: Vec<Value>,
    /// One a method.
    pub counts: Vec<Counts>,
}

#[derive(Clone, PartialEq, Debug)]
pub struct Table {
    pub header: Vec<Formula>,
    pub rows: Vec<TableRow>,
    pub notes: Vec<TableNote>,
}

#[derive(Clone, PartialEq, Debug)]
pub struct TableRow {
    pub name: Value,
    pub cells: Vec<Cell>,
    pub is_current: bool,
    pub link: Option<Link>,
}

#[derive(Clone, PartialEq, Debug)]
pub struct Cell {
    pub value: Option<Value>,
    /// [`Role::Signal`] where worked out at this step, [`Role::Ink`] in this row, [`Role::Soft`] in the row above.
    pub role: Role,
    /// A bound that this row has moved: semibold.
    pub strong: bool,
}

#[derive(Clone, PartialEq, Debug)]
pub struct TableNote {
    pub text: Message,
    pub applies: bool,
}

impl Cell {
    pub fn new(role: Role, value: Option<impl Into<Value>>) -> Self {
        let value = value.map(Into::into);
        Self {
            value,
            role,
            strong: false,
        }
    }

    pub const fn strong(mut self) -> Self {
        self.strong = true;
        self
    }
}

/// Axes at one scale, 0 in the middle of all of them: what is out is left of it, what is in is right.
#[derive(Clone, PartialEq, Debug)]
pub struct Gauges {
    pub title: Message,
    pub sides: [Message; 2],
    /// A strip either side of 0 that is marked: from −r to r, and what is written at its ends.
    pub band: Option<f64>,
    pub rows: Vec<Gauge>,
}

#[derive(Clone, PartialEq, Debug)]
pub struct Gauge {
    pub name: Value,
    pub value: Option<f64>,
    pub verdict: Option<Message>,
    pub role: Role,
    pub is_bar: bool,
    pub link: Option<Link>,
}

#[derive(Clone, PartialEq, Debug)]
pub struct MatrixProduct {
    pub name: Value,
    pub notes: Vec<Value>,
    pub from: Value,
    /// What is done to the vector where there is no matrix: `÷ 5`.
    pub operator: Option<Formula>,
    /// Under the result: its space; none where nothing comes out but an answer.
    pub into: Option<Value>,
    pub rows: Vec<MatrixRow>,
}

#[derive(Clone, PartialEq, Debug)]
pub struct MatrixRow {
    pub entries: Vec<f64>,
    pub operand: Option<f64>,
    pub result: Option<f64>,
    pub sum: Option<Formula>,
    pub is_current: bool,
    pub link: Option<Link>,
}

#[derive(Clone, PartialEq, Debug)]
pub struct Products {
    pub products: Vec<Product>,
    pub measured: Option<Measured>,
}

#[derive(Clone, PartialEq, Debug)]
pub struct Product {
    pub onto: Vector,
    pub of: Vector,
    pub decision: Message,
    pub arithmetic: Formula,
    pub is_current: bool,
}

#[derive(Clone, PartialEq, Debug)]
pub struct Vector {
    pub name: Value,
    pub to: [f64; 2],
    pub role: Role,
}

/// A bar along the normal: 0 is the border, the inside to its right.
#[derive(Clone, PartialEq, Debug)]
pub struct Measured {
    pub title: Message,
    pub zero: Value,
    pub ends: [(Value, f64); 2],
    pub spans: Vec<([f64; 2], Value, Role)>,
}

#[derive(Clone, PartialEq, Debug)]
pub struct Lists {
    pub lists: Vec<ListColumn>,
    pub links: Vec<ListLink>,
    pub legend: Vec<(ItemMarker, Value)>,
}

#[derive(Clone, PartialEq, Debug)]
pub struct ListColumn {
    pub title: Value,
    pub columns: Vec<Value>,
    /// All of a short list, of a long one those about the focus; a view folds what it has no room for.
    pub entries: Vec<ListRow>,
    pub n_before: usize,
    pub n_after: usize,
    pub is_ring: bool,
    /// Entries with which another ring begins, as a polygon's hole does: each ring leads back to its own first entry.
    pub breaks: Vec<usize>,
    pub focus: Option<usize>,
}

impl ListColumn {
    const MOST: usize = 40;

    pub const fn new(title: Value, entries: Vec<ListRow>) -> Self {
        Self {
            title,
            columns: Vec::new(),
            entries,
            n_before: 0,
            n_after: 0,
            is_ring: false,
            breaks: Vec::new(),
            focus: None,
        }
    }

    pub fn about(
        title: Value,
        len: usize,
        focus: Option<usize>,
        entry: impl FnMut(usize) -> ListRow,
    ) -> Self {
        let reach = Self::reach(len, focus);
        Self {
            n_before: reach.start,
            n_after: len - reach.end,
            focus: focus.map(|at| at - reach.start),
            ..Self::new(title, reach.map(entry).collect())
        }
    }

    /// Where the `nth` of the whole list stands among the entries, if it is given.
    pub fn entry_of(&self, nth: usize) -> Option<usize> {
        let entry = nth.checked_sub(self.n_before)?;
        (entry < self.entries.len()).then_some(entry)
    }

    pub fn reach(len: usize, focus: Option<usize>) -> Range<usize> {
        Self::reach_of(Self::MOST, len, focus)
    }

    /// Of so many in all, at `most` so many about the one in focus.
    pub fn reach_of(most: usize, len: usize, focus: Option<usize>) -> Range<usize> {
        let first = focus.unwrap_or(0).saturating_sub(most / 2);
        let first = first.min(len.saturating_sub(most));
        first..len.min(first + most)
    }
}

#[derive(Clone, PartialEq, Debug)]
pub struct ListRow {
    pub name: Value,
    pub details: Vec<Option<Value>>,
    pub marker: Option<ItemMarker>,
    /// [`Role::Signal`] for this step's, [`Role::Accent`] for what has been walked or kept so far, [`Role::Accepted`]
    /// for what is in the answer, [`Role::Discarded`] for what is dropped, [`Role::Ink`] for what counts,
    /// [`Role::Faint`] for what is still to come, else [`Role::Soft`].
    pub role: Role,
    pub link: Option<Link>,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ItemMarker {
    Dot,
    Ring,
    /// Partly so: a part is inside.
    HalfDot,
    /// Not so: it does not count.
    Cross,
    CrossedRing,
}

impl ItemMarker {
    pub const fn dot_or_ring(is_dot: bool) -> Self {
        if is_dot { Self::Dot } else { Self::Ring }
    }
}

/// From an entry to one of another list: each `[list, entry]`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ListLink {
    pub from: [usize; 2],
    pub to: [usize; 2],
    /// [`Role::Signal`] for the one that is taken now: a thick arrow; else a dashed hairline.
    pub role: Role,
}

impl ListLink {
    /// From an entry of the first list to one of the second.
    pub const fn between(from: usize, to: usize, role: Role) -> Self {
        let (from, to) = ([0, from], [1, to]);
        Self { from, to, role }
    }
}

impl ListRow {
    pub fn new(name: impl Into<Value>) -> Self {
        Self {
            name: name.into(),
            details: Vec::new(),
            marker: None,
            role: Role::Soft,
            link: None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_list_is_given_about_its_focus() {
        assert_eq!(ListColumn::reach(7, Some(6)), 0..7, "all of a short one");
        assert_eq!(ListColumn::reach(100, None), 0..40);
        assert_eq!(ListColumn::reach(100, Some(50)), 30..70);
        assert_eq!(ListColumn::reach(100, Some(99)), 60..100);
    }
}
