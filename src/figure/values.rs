//! Views of the values that an algorithm holds: codes as bits, tables, numbers on axes, a matrix times a vector, and dot
//! products as two vectors from one point.

use crate::text::{Formula, Message, Value};

use super::role::{Link, Role};

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
    pub fn new(role: Role, value: Option<impl Into<Value>>) -> Self {
        let value = value.map(Into::into);
        Self {
            value,
            role,
            strong: false,
        }
    }

    /// Set semibold: among what is in its row, the one that changed.
    pub const fn strong(mut self) -> Self {
        self.strong = true;
        self
    }
}

/// Axes at one scale, 0 in the middle of all of them: what is out is left of it, what is in is right.
#[derive(Clone, PartialEq, Debug)]
pub struct Gauges {
    /// Over it: "One sphere, six planes".
    pub title: Message,
    /// What is said of either side of 0, left and right.
    pub sides: [Message; 2],
    /// A strip either side of 0 that is marked: from −r to r, and what is written at its ends.
    pub band: Option<f64>,
    /// From top to bottom; every row is there from the start, so that nothing moves when it is filled.
    pub rows: Vec<Gauge>,
}

/// One number.
#[derive(Clone, PartialEq, Debug)]
pub struct Gauge {
    /// At the left: "left", "face 6".
    pub name: Value,
    /// Where, once it is known.
    pub value: Option<f64>,
    /// A word at the right, once it is known: "culled".
    pub verdict: Option<Message>,
    /// [`Role::Accent`] kept, [`Role::Discarded`] culled, [`Role::Signal`] this step's.
    pub role: Role,
    /// A bar from 0, or a dot.
    pub is_bar: bool,
    /// What it is about.
    pub link: Option<Link>,
}

/// What leads from one space to the next: every row is there from the start, so that nothing moves when it is filled.
#[derive(Clone, PartialEq, Debug)]
pub struct MatrixProduct {
    /// What it is called: `clip_from_view`.
    pub name: Value,
    /// What it is made of: "near 2, far 10".
    pub notes: Vec<Value>,
    /// Under the vector: its space.
    pub from: Value,
    /// What is done to the vector where there is no matrix: `÷ 5`.
    pub operator: Option<Formula>,
    /// Under the result: its space; none where nothing comes out but an answer.
    pub into: Option<Value>,
    /// From top to bottom.
    pub rows: Vec<MatrixRow>,
}

/// One row of a [`MatrixProduct`].
#[derive(Clone, PartialEq, Debug)]
pub struct MatrixRow {
    /// Of the matrix: none where there is no matrix.
    pub entries: Vec<f64>,
    /// Of the vector.
    pub operand: Option<f64>,
    /// Of the result, once known.
    pub result: Option<f64>,
    /// How it was worked out: `x = 0.625 · 3 = 1.875`.
    pub sum: Option<Formula>,
    /// Is it this step's?
    pub is_current: bool,
    /// What it is about.
    pub link: Option<Link>,
}

/// Dot products with one vector in common, and what they measure along it.
#[derive(Clone, PartialEq, Debug)]
pub struct Products {
    /// From top to bottom.
    pub products: Vec<Product>,
    /// The same in one dimension.
    pub measured: Option<Measured>,
}

/// One dot product.
#[derive(Clone, PartialEq, Debug)]
pub struct Product {
    /// The vector that is projected on: the normal.
    pub onto: Vector,
    /// The vector that is projected.
    pub of: Vector,
    /// What its sign says: "n·D > 0: the line enters".
    pub decision: Message,
    /// The arithmetic: `3·11 + 2·(−3) = 27`.
    pub arithmetic: Formula,
    /// Was it worked out at this step?
    pub is_current: bool,
}

/// A vector with a name, in the coordinates of the world.
#[derive(Clone, PartialEq, Debug)]
pub struct Vector {
    /// `n`, `D`.
    pub name: Value,
    /// Its two coordinates.
    pub to: [f64; 2],
    /// How it is drawn, here and on the stage.
    pub role: Role,
}

/// A bar along the normal: 0 is the border, the inside to its right.
#[derive(Clone, PartialEq, Debug)]
pub struct Measured {
    /// "Measured along n, from the edge".
    pub title: Message,
    /// Over 0.
    pub zero: Value,
    /// Both ends: their names and distances.
    pub ends: [(Value, f64); 2],
    /// Lengths under the bar: from, to, and what is written on it.
    pub spans: Vec<([f64; 2], Value, Role)>,
}
