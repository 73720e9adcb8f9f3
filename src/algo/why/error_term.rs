//! Why Bresenham's e is what it is. From column to column the line moves b/a of a pixel aside, and the midpoint between two pixels is at 1/2. Both
//! become whole numbers if they are measured in parts of 2a to a pixel: 2b a column, and a. e is the line less the midpoint, so it
//! grows by 2b a column, and falls by 2a where the midpoint moves on by a pixel. *Cost*: a multiplication a column, which is what the
//! algorithm then does without.

use serde::Serialize;

use crate::{
    algo::pipeline::BresenhamInput,
    trace::{Real, Told},
};

use super::Proof;

/// The proof; see the module.
#[derive(Clone, Copy, Debug)]
pub struct ErrorTerm;

/// What is shown, in order.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum ErrorTermFact {
    /// So many parts a pixel has: 2a. If it is 0 the line is one pixel, and this is the end.
    Parts,
    /// So many the line moves aside in a column: 2b.
    Line,
    /// So many the first midpoint is aside: a.
    Midpoint,
    /// e of a column: the line less the midpoint.
    Error {
        /// From 1, after the first pixel.
        column: usize,
    },
}

/// Pixels of which two are chosen between.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ErrorTermInput {
    /// Both ends; none where nothing of the line is visible.
    pub ends: Option<BresenhamInput>,
}

impl ErrorTermInput {
    /// Columns that are shown.
    pub const MOST_COLUMNS: usize = 6;

    /// a and b: the longer and the shorter side.
    #[must_use]
    pub fn sides(&self) -> [f64; 2] {
        let [x, y] = self.ends.map_or([0; 2], |ends| ends.distances());
        [x.max(y) as f64, x.min(y) as f64]
    }

    /// The rows of the pixels that are taken, from the first: so far aside.
    #[must_use]
    pub fn rows(&self) -> Vec<f64> {
        let [a, b] = self.sides();
        let n_columns = (a as usize).min(Self::MOST_COLUMNS);
        let mut rows = vec![0.0];
        for column in 1..=n_columns {
            let row: f64 = rows[column - 1];
            let is_beyond = 2.0 * b * column as f64 - 2.0 * a * row - a > 0.0;
            rows.push(if is_beyond { row + 1.0 } else { row });
        }
        rows
    }
}

impl Proof for ErrorTerm {
    type Input = ErrorTermInput;
    type Fact = ErrorTermFact;

    fn prove<R: Real, S>(
        input: &ErrorTermInput,
        show: &mut impl FnMut(ErrorTermFact, R) -> Told<S>,
    ) -> Told<S> {
        let [a, b] = input.sides().map(R::new);
        let (two_a, two_b) = (a + a, b + b);
        show(ErrorTermFact::Parts, two_a)?;
        if two_a == R::new(0.0) {
            return Told::Continue(());
        }
        show(ErrorTermFact::Line, two_b)?;
        show(ErrorTermFact::Midpoint, a)?;
        for (column, pair) in (1..).zip(input.rows().windows(2)) {
            let line = two_b * R::new(f64::from(column as u32));
            let midpoint = two_a * R::new(pair[0]) + a;
            show(ErrorTermFact::Error { column }, line - midpoint)?;
        }
        Told::Continue(())
    }

    fn max_facts(_: &ErrorTermInput) -> usize {
        ErrorTermInput::MOST_COLUMNS + 3
    }
}
