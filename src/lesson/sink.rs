//! Collects the mistakes of one file.

use std::{cell::RefCell, ops::Range};

use crate::text::{Diagnostic, Message, nearest};

use super::{
    problem::{Problem, Severity},
    source::Source,
};

/// After so many mistakes in one file the rest are only counted.
const MAX_PROBLEMS: usize = 100;

pub(crate) struct Sink<'s> {
    pub source: &'s Source<'s>,
    found: RefCell<Found>,
}

/// In the order in which they were found.
#[derive(Default)]
struct Found {
    problems: Vec<Problem>,
    n_more: usize,
    n_errors: usize,
}

impl<'s> Sink<'s> {
    /// Reports at once a file that is not UTF-8.
    pub fn new(source: &'s Source<'s>) -> Self {
        let found = RefCell::default();
        let sink = Self { source, found };
        if let Some((at, byte)) = source.bad_byte {
            let message = Message::new("problem-not-utf8").with("byte", format!("0x{byte:02X}"));
            sink.error(at..at + 1, message, [Message::new("expect-utf8")]);
        }
        sink
    }

    pub fn n_errors(&self) -> usize {
        self.found.borrow().n_errors
    }

    /// The known name that a misspelt one is nearest to, as long as somebody will read it.
    pub fn nearest<'n>(
        &self,
        name: &str,
        known: impl IntoIterator<Item = &'n str>,
    ) -> Option<&'n str> {
        let is_full = self.found.borrow().problems.len() >= MAX_PROBLEMS;
        if is_full { None } else { nearest(name, known) }
    }

    /// A mistake that keeps the lesson from being shown, with what else there is to say of it.
    pub fn error(
        &self,
        span: Range<usize>,
        what: impl Into<Diagnostic>,
        notes: impl IntoIterator<Item = Message>,
    ) {
        let mut what = what.into();
        what.notes.extend(notes);
        self.found.borrow_mut().n_errors += 1;
        self.push(Severity::Error, span, what);
    }

    /// A mistake that does not.
    pub fn warning(&self, span: Range<usize>, what: impl Into<Diagnostic>) {
        self.push(Severity::Warning, span, what.into());
    }

    fn push(&self, severity: Severity, span: Range<usize>, what: Diagnostic) {
        let mut found = self.found.borrow_mut();
        if found.problems.len() >= MAX_PROBLEMS {
            found.n_more += 1;
            return;
        }
        found.problems.push(Problem {
            file: self.source.file.clone(),
            place: Some(self.source.place(span)),
            severity,
            what,
        });
    }

    /// Adds what is wrong with another file that this one names.
    pub fn report(&self, problems: Vec<Problem>) {
        let mut found = self.found.borrow_mut();
        let is_error = |problem: &&Problem| problem.severity == Severity::Error;
        found.n_errors += problems.iter().filter(is_error).count();
        let room = MAX_PROBLEMS.saturating_sub(found.problems.len());
        found.n_more += problems.len().saturating_sub(room);
        found.problems.extend(problems.into_iter().take(room));
    }

    /// Adds the problems of another sink for the same file that `keep` wants, by their codes.
    pub fn take_from(&self, other: Self, keep: impl Fn(&str) -> bool) {
        let known = &mut self.found.borrow_mut().problems;
        let others = other.found.into_inner().problems;
        for problem in others.into_iter().filter(|p| keep(p.code())) {
            let Some(place) = &problem.place else {
                continue;
            };
            let is_known = |p: &Problem| p.place.as_ref().is_some_and(|p| p.line == place.line);
            if !known.iter().any(is_known) && known.len() < MAX_PROBLEMS {
                known.push(problem);
            }
        }
    }

    /// All of them, from the top of the file to its end.
    pub fn into_problems(self) -> Vec<Problem> {
        let file = &self.source.file;
        let mut found = self.found.into_inner();
        // Those of files that this one names come after its own.
        found.problems.sort_by_key(|problem| {
            let place = problem.place.as_ref();
            let place = place.map(|place| (place.line, place.column));
            (problem.file != *file, place)
        });
        // What a scene has from another one was said of that already.
        found.problems.dedup();
        if found.n_more > 0 {
            let message = Message::new("problem-more").with("count", found.n_more);
            found.problems.push(Problem {
                file: file.clone(),
                place: None,
                severity: if found.n_errors > 0 {
                    Severity::Error
                } else {
                    Severity::Warning
                },
                what: message.into(),
            });
        }
        found.problems
    }
}
