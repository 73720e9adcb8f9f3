//! From two streams to reports: of one program, or of each submission that stands in them.

use std::{
    collections::VecDeque,
    fmt,
    io::{self, Read},
};

use crate::case::{CaseLines, Id, Solvers};

use super::{
    answer::Answer,
    compare::Tolerance,
    join::join,
    judge::Judge,
    tally::{Report, Tally},
    truth::{Cases, Known},
};

/// How answers are compared.
#[derive(Clone, Copy, Debug, Default)]
pub struct Options {
    /// How much a number may be off.
    pub tolerance: Tolerance,
    /// Does every answer say whose it is, so that no answer means no submission?
    pub of_many: bool,
}

/// Why grading broke off.
#[derive(Debug)]
pub enum GradeError {
    /// The cases could not be read.
    Cases(io::Error),
    /// The answers could not be read.
    Answers(io::Error),
    /// A report could not be written.
    Report(io::Error),
}

impl fmt::Display for GradeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Cases(error) => write!(f, "reading cases: {error}"),
            Self::Answers(error) => write!(f, "reading answers: {error}"),
            Self::Report(error) => write!(f, "writing a report: {error}"),
        }
    }
}

impl std::error::Error for GradeError {}

/// Compares answers with those that `solvers` give, and reports of each submission when its last answer has come; of the only one,
/// where answers do not say whose they are.
///
/// # Errors
/// [`GradeError`] where reading or reporting fails.
pub fn grade(
    solvers: Solvers,
    cases: impl Read,
    answers: impl Read,
    options: Options,
    mut report: impl FnMut(&Report) -> io::Result<()>,
) -> Result<(), GradeError> {
    let judge = Judge {
        solvers,
        tolerance: options.tolerance,
    };
    let mut cases = Cases::new(solvers, cases);
    let mut answers = Answers::new(answers);
    let first = answers.first_submission().map_err(GradeError::Answers)?;
    if !options.of_many && first.is_none() {
        let mut tally = Tally::new(judge);
        let mut next_answer = || answers.next().map_err(GradeError::Answers);
        join(
            &mut tally,
            &mut || cases.next().map_err(GradeError::Cases),
            &mut next_answer,
        )?;
        return report(&tally.finish(None)).map_err(GradeError::Report);
    }
    let common = leading(&mut cases).map_err(GradeError::Cases)?;
    let mut many = Many {
        judge,
        common,
        cases,
        ahead: VecDeque::new(),
    };
    while let Some(submission) = answers.peek().map_err(GradeError::Answers)? {
        let found = many.own_cases(&submission).map_err(GradeError::Cases)?;
        for (id, own) in found.passed {
            report(&many.silent(id, own)).map_err(GradeError::Report)?;
        }
        let graded = many.graded(submission, found.own, &mut answers)?;
        report(&graded).map_err(GradeError::Report)?;
    }
    while let Some((id, own)) = many.next_group().map_err(GradeError::Cases)? {
        report(&many.silent(id, own)).map_err(GradeError::Report)?;
    }
    Ok(())
}

/// The cases before the first that says whose it is: those of everybody.
fn leading<R: Read>(cases: &mut Cases<R>) -> io::Result<Vec<Known>> {
    let mut common = Vec::new();
    while cases
        .peek()?
        .is_some_and(|known| known.submission.is_none())
    {
        common.extend(cases.next()?);
    }
    Ok(common)
}

/// So many submissions are looked at in search of one: the answers come in the order of the cases.
const MOST_AHEAD: usize = 1_000;

type Group = (Id, Vec<Known>);

/// Many submissions, one after the other.
struct Many<R> {
    judge: Judge,
    common: Vec<Known>,
    cases: Cases<R>,
    /// Read in search of one that came later, or nowhere.
    ahead: VecDeque<Group>,
}

/// A submission's own cases, and the submissions before it, which have no answers.
#[derive(Default)]
struct Found {
    passed: Vec<Group>,
    own: Vec<Known>,
}

impl<R: Read> Many<R> {
    fn own_cases(&mut self, submission: &Id) -> io::Result<Found> {
        let mut place = self.ahead.iter().position(|(id, _)| id == submission);
        while place.is_none() && self.ahead.len() < MOST_AHEAD {
            let Some(group) = self.read_group()? else {
                break;
            };
            if group.0 == *submission {
                place = Some(self.ahead.len());
            }
            self.ahead.push_back(group);
        }
        let Some(place) = place else {
            return Ok(Found::default());
        };
        let passed = self.ahead.drain(..place).collect();
        let own = self.ahead.pop_front().map(|(_, own)| own);
        Ok(Found {
            passed,
            own: own.unwrap_or_default(),
        })
    }

    fn next_group(&mut self) -> io::Result<Option<Group>> {
        match self.ahead.pop_front() {
            Some(group) => Ok(Some(group)),
            None => self.read_group(),
        }
    }

    /// Lines are counted from its first, so that they are the same in every shard.
    fn read_group(&mut self) -> io::Result<Option<Group>> {
        let Some(first) = self.cases.next()? else {
            return Ok(None);
        };
        let (id, before) = (first.submission.clone().unwrap_or_default(), first.line - 1);
        let mut own = vec![first];
        let is_own = |known: &Known| known.submission.as_ref().is_none_or(|other| *other == id);
        while self.cases.peek()?.is_some_and(is_own) {
            own.extend(self.cases.next()?);
        }
        for known in &mut own {
            known.line -= before;
        }
        Ok(Some((id, own)))
    }

    fn graded<A: Read>(
        &self,
        submission: Id,
        own: Vec<Known>,
        answers: &mut Answers<A>,
    ) -> Result<Report, GradeError> {
        let mut tally = Tally::new(self.judge);
        let mut cases = self.common.iter().cloned().chain(own);
        let before = answers.line_before();
        let mut next_answer = || {
            let answer = answers.next_of(&submission).map_err(GradeError::Answers)?;
            Ok(answer.map(|mut answer| {
                answer.line -= before;
                answer
            }))
        };
        join(&mut tally, &mut || Ok(cases.next()), &mut next_answer)?;
        Ok(tally.finish(Some(submission)))
    }

    fn silent(&self, submission: Id, own: Vec<Known>) -> Report {
        let mut tally = Tally::new(self.judge);
        for known in self.common.iter().cloned().chain(own) {
            let place = tally.begin(&known);
            tally.missing(place, known);
        }
        tally.finish(Some(submission))
    }
}

/// Lines before the first that says whose it is: more are taken for all there is.
const MOST_NOISE: usize = 1_000;

struct Answers<R> {
    lines: CaseLines<R>,
    /// Read and not yet taken.
    next: VecDeque<Answer>,
}

impl<R: Read> Answers<R> {
    fn new(answers: R) -> Self {
        Self {
            lines: CaseLines::new(answers),
            next: VecDeque::new(),
        }
    }

    fn read(&mut self) -> io::Result<Option<Answer>> {
        let line = self.lines.next_line()?;
        Ok(line.map(|(line, content)| Answer::read(line, content)))
    }

    /// Whose the first answer is that can be read.
    fn first_submission(&mut self) -> io::Result<Option<Id>> {
        while self.next.len() < MOST_NOISE {
            let Some(answer) = self.read()? else {
                break;
            };
            let (submission, is_noise) = (answer.submission.clone(), answer.is_noise());
            self.next.push_back(answer);
            if submission.is_some() || !is_noise {
                return Ok(submission);
            }
        }
        Ok(None)
    }

    fn next(&mut self) -> io::Result<Option<Answer>> {
        match self.next.pop_front() {
            Some(answer) => Ok(Some(answer)),
            None => self.read(),
        }
    }

    /// Whose the next answers are: lines that do not say it belong to those after them at the beginning, and later to those before.
    fn peek(&mut self) -> io::Result<Option<Id>> {
        if self.next.is_empty() {
            let read = self.read()?;
            self.next.extend(read);
        }
        let said = self
            .next
            .iter()
            .find_map(|answer| answer.submission.clone());
        let is_there = !self.next.is_empty();
        Ok(is_there.then(|| said.unwrap_or_default()))
    }

    fn line_before(&self) -> usize {
        self.next.front().map_or(0, |answer| answer.line - 1)
    }

    fn next_of(&mut self, submission: &Id) -> io::Result<Option<Answer>> {
        let next = self.next()?;
        if let Some(answer) = &next
            && answer
                .submission
                .as_ref()
                .is_some_and(|other| other != submission)
        {
            self.next.extend(next);
            return Ok(None);
        }
        Ok(next)
    }
}
