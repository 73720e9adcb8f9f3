//! Collects the mistakes of one file.

use std::ops::Range;

use crate::text::{Diagnostic, Message};

use super::{
    nearest::nearest,
    problem::{Problem, Severity},
    source::Source,
};

/// After so many mistakes in one file the rest are only counted.
const MAX_PROBLEMS: usize = 100;

/// The mistakes of one file, in the order in which they were found.
pub(crate) struct Sink<'s> {
    source: &'s Source<'s>,
    problems: Vec<Problem>,
    n_more: usize,
    n_errors: usize,
}

impl<'s> Sink<'s> {
    /// Reports at once a file that is not UTF-8.
    pub fn new(source: &'s Source<'s>) -> Self {
        let mut sink = Self {
            source,
            problems: Vec::new(),
            n_more: 0,
            n_errors: 0,
        };
        if let Some((at, byte)) = source.bad_byte {
            let message = Message::new("problem-not-utf8").with("byte", format!("0x{byte:02X}"));
            sink.error(at..at + 1, message, [Message::new("expect-utf8")]);
        }
        sink
    }

    pub const fn source(&self) -> &'s Source<'s> {
        self.source
    }

    pub const fn n_errors(&self) -> usize {
        self.n_errors
    }

    /// The known name that a misspelt one is nearest to, as long as somebody will read it.
    pub fn nearest<'n>(
        &self,
        name: &str,
        known: impl IntoIterator<Item = &'n str>,
    ) -> Option<&'n str> {
        let is_full = self.problems.len() >= MAX_PROBLEMS;
        if is_full { None } else { nearest(name, known) }
    }

    /// A mistake that keeps the lesson from being shown.
    pub fn error(
        &mut self,
        span: Range<usize>,
        message: Message,
        notes: impl IntoIterator<Item = Message>,
    ) {
        self.refuse(span, Diagnostic::new(message), notes);
    }

    /// A typed error, with what else there is to say of it.
    pub fn refuse(
        &mut self,
        span: Range<usize>,
        error: impl Into<Diagnostic>,
        notes: impl IntoIterator<Item = Message>,
    ) {
        self.n_errors += 1;
        self.push(Severity::Error, span, error.into(), notes);
    }

    /// A mistake that does not.
    pub fn warning(
        &mut self,
        span: Range<usize>,
        message: Message,
        notes: impl IntoIterator<Item = Message>,
    ) {
        self.push(Severity::Warning, span, Diagnostic::new(message), notes);
    }

    fn push(
        &mut self,
        severity: Severity,
        span: Range<usize>,
        mut what: Diagnostic,
        notes: impl IntoIterator<Item = Message>,
    ) {
        if self.problems.len() >= MAX_PROBLEMS {
            self.n_more += 1;
            return;
        }
        what.notes.extend(notes);
        self.problems.push(Problem {
            file: self.source.file.clone(),
            place: Some(self.source.place(span)),
            severity,
            what,
        });
    }

    /// Adds what is wrong with another file that this one names.
    pub fn report(&mut self, problems: Vec<Problem>) {
        let is_error = |problem: &&Problem| problem.severity == Severity::Error;
        self.n_errors += problems.iter().filter(is_error).count();
        let room = MAX_PROBLEMS.saturating_sub(self.problems.len());
        self.n_more += problems.len().saturating_sub(room);
        self.problems.extend(problems.into_iter().take(room));
    }

    /// Adds the problems of another sink for the same file that `keep` wants, by their codes.
    pub fn take_from(&mut self, other: Self, keep: impl Fn(&str) -> bool) {
        for problem in other.problems.into_iter().filter(|p| keep(p.code())) {
            let Some(place) = &problem.place else {
                continue;
            };
            let is_known = |p: &Problem| p.place.as_ref().is_some_and(|p| p.line == place.line);
            if !self.problems.iter().any(is_known) && self.problems.len() < MAX_PROBLEMS {
                self.problems.push(problem);
            }
        }
    }

    /// All of them, from the top of the file to its end.
    pub fn into_problems(self) -> Vec<Problem> {
        let mut problems = self.problems;
        // Those of files that this one names come after its own.
        problems.sort_by_key(|problem| {
            let place = problem.place.as_ref();
            let place = place.map(|place| (place.line, place.column));
            (problem.file != self.source.file, place)
        });
        if self.n_more > 0 {
            problems.push(Problem {
                file: self.source.file.clone(),
                place: None,
                severity: if self.n_errors > 0 {
                    Severity::Error
                } else {
                    Severity::Warning
                },
                what: Message::new("problem-more")
                    .with("count", self.n_more)
                    .into(),
            });
        }
        problems
    }
}

/// A name from a file as a message quotes it: not longer than a line.
pub(in crate::lesson) fn clipped(name: &str) -> String {
    const MAX_CHARS: usize = 60;
    match name.char_indices().nth(MAX_CHARS) {
        Some((end, _)) => format!("{}…", &name[..end]),
        None => name.to_owned(),
    }
}
