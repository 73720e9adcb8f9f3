//! A report as a line of JSON.

use std::io::{self, Write};

use serde::Serialize;
use serde_json::Value as Json;

use crate::{case::Id, text::Catalog};

use super::{
    super::tally::{Report, Wrong},
    text::sentence,
};

/// Of the format, not of the program.
pub const VERSION: u32 = 1;

#[derive(Serialize)]
struct Line<'a> {
    version: u32,
    #[serde(skip_serializing_if = "Option::is_none")]
    submission: Option<&'a Id>,
    cases: usize,
    right: usize,
    wrong: Vec<WrongLine<'a>>,
    /// How many more are wrong than are listed.
    #[serde(skip_serializing_if = "is_zero")]
    unlisted: usize,
}

#[derive(Serialize)]
struct WrongLine<'a> {
    id: &'a Id,
    line: usize,
    kind: &'static str,
    step: Option<usize>,
    said: &'a Json,
    #[serde(rename = "true")]
    truth: &'a Json,
    mistake: Option<&'static str>,
    message: String,
}

impl<'a> WrongLine<'a> {
    fn of(wrong: &'a Wrong, catalog: &Catalog) -> Self {
        Self {
            id: &wrong.id,
            line: wrong.line,
            kind: wrong.kind.id(),
            step: wrong.step,
            said: &wrong.said,
            truth: &wrong.truth,
            mistake: wrong.mistake.map(|[id, _]| id),
            message: sentence(wrong, catalog),
        }
    }
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "as serde asks")]
const fn is_zero(n: &usize) -> bool {
    *n == 0
}

/// One line, with its end.
///
/// # Errors
/// Where it cannot be written.
pub fn write_json(report: &Report, catalog: &Catalog, mut out: impl Write) -> io::Result<()> {
    let line = |wrong| WrongLine::of(wrong, catalog);
    let wrong = report.wrong.iter().map(line).collect();
    let line = Line {
        version: VERSION,
        submission: report.submission.as_ref(),
        cases: report.n_cases,
        right: report.n_right,
        wrong,
        unlisted: report.n_unlisted,
    };
    serde_json::to_writer(&mut out, &line)?;
    out.write_all(b"\n")
}
