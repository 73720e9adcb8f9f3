//! Totals of reports that have been written as JSON, one a line.

use std::{
    collections::BTreeMap,
    io::{self, Read},
};

use serde::{Deserialize, Serialize};

use crate::case::{CaseLine, CaseLines};

/// Sums over reports. It is read as it is written, so that totals can be summed up as well.
#[derive(Clone, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Totals {
    version: u32,
    /// How many reports.
    pub submissions: usize,
    /// In how many of them every case is right, and nothing else is wrong.
    pub all_right: usize,
    /// In all of them.
    pub cases: usize,
    /// In all of them.
    pub right: usize,
    /// How often each kind of mistake is listed.
    pub kinds: BTreeMap<String, usize>,
    /// How often each known mistake is.
    pub mistakes: BTreeMap<String, usize>,
}

/// A report, as far as it is summed up.
#[derive(Deserialize)]
struct Line {
    version: u32,
    cases: usize,
    right: usize,
    wrong: Vec<WrongLine>,
}

#[derive(Deserialize)]
struct WrongLine {
    kind: String,
    mistake: Option<String>,
}

#[derive(Deserialize)]
#[serde(untagged)]
enum Either {
    Totals(Totals),
    Report(Line),
}

impl Totals {
    /// Of nothing yet.
    #[must_use]
    pub fn new() -> Self {
        Self {
            version: super::report::VERSION,
            ..Self::default()
        }
    }

    fn add(&mut self, other: Self) {
        self.submissions += other.submissions;
        self.all_right += other.all_right;
        self.cases += other.cases;
        self.right += other.right;
        for (sums, others) in [
            (&mut self.kinds, other.kinds),
            (&mut self.mistakes, other.mistakes),
        ] {
            for (name, n) in others {
                *sums.entry(name).or_default() += n;
            }
        }
    }
}

impl From<Line> for Totals {
    fn from(line: Line) -> Self {
        let mut totals = Self {
            version: line.version,
            submissions: 1,
            all_right: usize::from(line.wrong.is_empty() && line.right == line.cases),
            cases: line.cases,
            right: line.right,
            ..Self::default()
        };
        for wrong in line.wrong {
            *totals.kinds.entry(wrong.kind).or_default() += 1;
            if let Some(mistake) = wrong.mistake {
                *totals.mistakes.entry(mistake).or_default() += 1;
            }
        }
        totals
    }
}

/// Adds all lines of a reader; `on_refusal` hears of those that are no report.
///
/// # Errors
/// Where the reader fails.
pub fn merge(
    totals: &mut Totals,
    reports: impl Read,
    mut on_refusal: impl FnMut(usize),
) -> io::Result<()> {
    let mut lines = CaseLines::new(reports);
    while let Some((line, content)) = lines.next_line()? {
        let read = match content {
            CaseLine::Bytes(bytes) => serde_json::from_slice(bytes).ok(),
            CaseLine::TooLong => None,
        };
        match read {
            Some(Either::Totals(other)) if other.version == totals.version => totals.add(other),
            Some(Either::Report(report)) if report.version == totals.version => {
                totals.add(report.into());
            }
            Some(Either::Totals(_) | Either::Report(_)) | None => on_refusal(line),
        }
    }
    Ok(())
}
