//! A matrix times a vector, row by row; or what else leads from the coordinates of one space to those of the next.

use crate::text::{Formula, Value};

use super::Link;

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
