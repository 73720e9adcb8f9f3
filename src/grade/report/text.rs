//! A report for people.

use std::io::{self, Write};

use crate::{
    case::{Id, short},
    text::{Catalog, Message, Value},
};

use super::super::tally::{Report, Wrong};

/// What is wrong, and which known mistake comes to just this.
#[must_use]
pub fn sentence(wrong: &Wrong, catalog: &Catalog) -> String {
    let said = catalog.message(&wrong.message);
    let Some([_, name_key]) = wrong.mistake else {
        return said;
    };
    let mistake = Message::new("grade-mistake").with("mistake", Value::Term(name_key));
    format!("{said} {}", catalog.message(&mistake))
}

/// What a case is called, by its place.
#[must_use]
pub fn title(case: Option<usize>, id: &Id, catalog: &Catalog) -> String {
    let name = id.name().map(|name| short(&name));
    let message = match (case, name) {
        (Some(number), Some(name)) if name != number.to_string() => {
            Message::new("grade-case-named")
                .with("number", number)
                .with("name", name)
        }
        (Some(number), Some(_) | None) => Message::new("grade-case").with("number", number),
        (None, _) => Message::new("grade-no-case"),
    };
    catalog.message(&message)
}

/// How many are right.
#[must_use]
pub fn score(report: &Report, catalog: &Catalog) -> String {
    let message = Message::new("grade-score")
        .with("right", report.n_right)
        .with("cases", report.n_cases);
    catalog.message(&message)
}

/// A paragraph: the score, and a line for each that is wrong.
///
/// # Errors
/// Where it cannot be written.
pub fn write_text(report: &Report, catalog: &Catalog, mut out: impl Write) -> io::Result<()> {
    if let Some(submission) = &report.submission {
        let name = submission.name().unwrap_or_default();
        writeln!(out, "{}", short(&name))?;
    }
    writeln!(out, "{}", score(report, catalog))?;
    for wrong in &report.wrong {
        let title = title(wrong.case, &wrong.id, catalog);
        writeln!(out, "✗ {title}: {}", sentence(wrong, catalog))?;
    }
    if report.n_unlisted > 0 {
        let more = Message::new("grade-unlisted").with("count", report.n_unlisted);
        writeln!(out, "{}", catalog.message(&more))?;
    }
    Ok(())
}
