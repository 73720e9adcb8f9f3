//! Cases: one problem in as a line of JSON, one answer out. The command line and the fuzz target are both
//! this module with a different reader and writer.
//!
//! ```text
//! line ──json──► fields ──Solver::read──► Problem ──► answer   as JSON
//!   │               │                        └──────► report   as text or Markdown, for people
//!   └───────────────┴── Refusal: code, path, sentence
//! ```
//!
//! A lab joins by adding its algorithms to [`solvers`]: each says which fields it takes and turns them into
//! a [`Problem`]. Everything else (unknown fields, missing fields, paths, formats) is done here, once.
//!
//! *What is reported first*, where a case has several mistakes: the line (length, UTF-8, JSON syntax, that
//! it is an object), a field given twice, `id`, `algorithm`, unknown fields as they come, missing fields
//! and then values in the order in which the algorithm lists them; in a list its length, then its
//! elements from the left, then what they mean together.
//!
//! ```
//! use clipscope::{case::{Detail, Format, Style, trace}, text::Lang};
//! let cases = br#"{"algorithm": "cohen-sutherland", "window": [-1,-1,1,1], "segment": [-2,-1,2,1.5]}"#;
//! let mut answers = Vec::new();
//! let style = Style { format: Format::Json, detail: Detail::Answers, lang: Lang::En };
//! trace(&cases[..], &mut answers, style, |_| {}).expect("memory can be written");
//! assert!(answers.starts_with(
//!     br#"{"id":null,"algorithm":"cohen-sutherland","output":{"visible":true,"segment":[-1.0,-0.375,1.0,0.875]}"#
//! ));
//! ```

mod answer;
mod fields;
mod lines;
mod parts;
mod polygons;
mod raw;
mod read;
mod refusal;
mod report;
mod solver;
mod stream;

pub use fields::{Field, Fields, Need};
pub use raw::{Id, Node, Path};
pub use read::{Case, Refused, read};
pub use refusal::{Code, Refusal};
pub use solver::{Given, Problem, Solver, solver, solvers};
pub use stream::{
    Detail, Format, Line, Lines, MAX_LINE_BYTES, Refusing, Style, Tally, TraceError, trace,
};
