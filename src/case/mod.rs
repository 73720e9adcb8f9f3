//! Cases: one problem in as a line of JSON, one answer out. The command line and the fuzz target are both
//! this module with a different reader and writer.
//!
//! ```text
//! line ──json──► fields ──Solve::READ──► Solvable ──► answer   as JSON
//!   │               │                        └──────► report   as text or Markdown, for people
//!   └───────────────┴── Refusal: code, path, sentence
//! ```
//!
//! A lab joins with a line in [`Solvers::standard`]: a table of its algorithms, of which each says which fields it
//! takes, each a [`Part`](crate::input::Part) or several, and what input they make ([`Solve`]). Everything else (unknown fields,
//! missing fields, shapes, paths, formats, the schema) is done here, once.
//!
//! *What is reported first*, where a case has several mistakes: the line (length, UTF-8, JSON syntax, that
//! it is an object), a field given twice, `id`, `algorithm`, unknown fields as they come, missing fields
//! and then values in the order in which the algorithm lists them; in a list its length, then its
//! elements from the left, then what they mean together.
//!
//! ```
//! use clipscope::{case::{Detail, Format, Solvers, Style, trace}, text::Lang};
//! let cases = br#"{"algorithm": "cohen-sutherland", "window": [-1,-1,1,1], "segment": [-2,-1,2,1.5]}"#;
//! let mut answers = Vec::new();
//! let style = Style { format: Format::Json, detail: Detail::Answers, lang: Lang::En };
//! trace(Solvers::standard(), &cases[..], &mut answers, style, |_| {}).expect("memory can be written");
//! assert!(answers.starts_with(
//!     br#"{"id":null,"algorithm":"cohen-sutherland","output":{"visible":true,"segment":[-1.0,-0.375,1.0,0.875]}"#
//! ));
//! ```
#![warn(
    missing_docs,
    clippy::missing_errors_doc,
    clippy::must_use_candidate,
    clippy::return_self_not_must_use
)]

mod budget;
mod fields;
mod finite;
mod frustum;
mod line;
mod lines;
mod mistake;
mod polygons;
mod prelude;
mod raw;
mod read;
mod refusal;
mod report;
mod schema;
mod solve;
mod solver;
mod stream;
mod style;
mod surfaces;

pub use budget::{Meter, OverBudget};
pub use fields::Fields;
pub use finite::Numbers;
pub use line::{CaseLine, CaseLines, MAX_LINE_BYTES};
pub use mistake::{Mistake, Mistaken};
pub use raw::Id;
pub use read::{Case, Heading, Refused, heading, read};
pub(crate) use refusal::short;
pub use refusal::{Code, Path, Refusal};
pub use report::{Refusing, Worksheet, worksheet};
pub use solve::{Reading, Solve, Verdict};
pub use solver::{Solvable, Solver, Solvers};
pub use stream::{Tally, TraceError, trace};
pub use style::{Detail, Format, Style};

impl Solvers {
    /// Those of all labs.
    #[must_use]
    pub const fn standard() -> Self {
        static TABLES: [&[Solver]; 4] = [
            &lines::SOLVERS,
            &polygons::SOLVERS,
            &frustum::SOLVERS,
            &surfaces::SOLVERS,
        ];
        Self::new(&TABLES)
    }
}
