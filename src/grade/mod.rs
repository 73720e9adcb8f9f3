//! Grading: the answers of a program, which may be written in any language, against the true ones.
//!
//! ```text
//! CASES ──► truth ──┐
//!                   ├─ join, by id or by order ──► judge ──► tally ──► Report ──► JSON, text, JUnit, …
//! ANSWERS ─► answer ┘
//! ```
//!
//! Both streams are read in step and once, and only what has no other half waits. An answer is right where its `output` is, and the
//! events that it tells: of the kinds that its program ever tells, in their order. See [`grade`].
//!
//! ```
//! use clipscope::{case::Solvers, grade::{Options, grade}};
//! let cases = br#"{"id": 1, "algorithm": "cohen-sutherland", "window": [-1,-1,1,1], "segment": [-2,-1,2,1.5]}"#;
//! let answers = br#"{"id": 1, "output": {"visible": true, "segment": [-1, -0.375, 1, 0.875]}}"#;
//! let mut n_right = 0;
//! grade(Solvers::standard(), &cases[..], &answers[..], Options::default(), |report| {
//!     n_right += report.n_right;
//!     Ok(())
//! })
//! .expect("memory can be read");
//! assert_eq!(n_right, 1);
//! ```

mod answer;
mod compare;
mod fault;
mod join;
mod judge;
mod merge;
mod report;
mod rings;
mod scenery;
mod submissions;
mod tally;
mod truth;
mod whole;

pub use compare::Tolerance;
pub use fault::Kind;
pub use merge::{Totals, merge};
pub use report::{
    Picture, gradescope, prairielearn, score, sentence, title, write_json, write_junit, write_text,
};
pub use scenery::Scenery;
pub use submissions::{GradeError, Options, grade};
pub use tally::{Report, Wrong};
