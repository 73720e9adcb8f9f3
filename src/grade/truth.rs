//! What is true of a case: its answer, its steps where a program tells any, and what known mistakes make of it.

use std::{cell::OnceCell, collections::HashMap, io, io::Read, rc::Rc};

use rustc_hash::FxBuildHasher;
use serde_json::Value as Json;

use crate::{
    case::{
        CaseLine, CaseLines, Code, Detail, Heading, Id, Mistaken, Refused, Solvable, Solver,
        Solvers, heading, read,
    },
    figure::{Run, Shown},
};

/// A case of many, with what is true of it.
#[derive(Clone)]
pub(super) struct Known {
    pub id: Id,
    /// None where it says none.
    pub submission: Option<Id>,
    /// Counted from 1.
    pub line: usize,
    pub truth: Rc<Truth>,
}

/// The answer; of a case that is refused the code.
pub(super) type Truth = Result<Right, Code>;

/// A case that has an answer.
pub(super) struct Right {
    pub solver: &'static Solver,
    pub problem: Box<dyn Solvable>,
    pub output: Json,
    /// As `trace` writes it.
    pub text: String,
    /// The line of the case: steps are found by reading it again, when they are first asked for.
    case: String,
    steps: OnceCell<Option<Steps>>,
    mistaken: OnceCell<Vec<Mistaken>>,
}

/// What happens, in order.
pub(super) struct Steps {
    pub events: Vec<Json>,
    /// Each kind once.
    pub kinds: Vec<String>,
}

impl Right {
    /// None where they are more than a report takes.
    pub(super) fn steps(&self, solvers: Solvers) -> Option<&Steps> {
        let steps = self.steps.get_or_init(|| {
            let run = self.run(solvers)?;
            let events: Vec<Json> = (1..=run.n_steps())
                .map(|step| run.event_json(step))
                .collect();
            let mut kinds: Vec<String> = Vec::new();
            for kind in events.iter().filter_map(kind_of) {
                if !kinds.iter().any(|known| known == kind) {
                    kinds.push(kind.to_owned());
                }
            }
            Some(Steps { events, kinds })
        });
        steps.as_ref()
    }

    /// None where its steps are more than a report takes.
    fn run(&self, solvers: Solvers) -> Option<Box<dyn Run>> {
        let line = CaseLine::Bytes(self.case.as_bytes());
        Some(read(solvers, line, Detail::Steps).ok()?.problem.run())
    }

    /// Looks at a step, or at the last one.
    pub(super) fn shown<T>(
        &self,
        solvers: Solvers,
        step: Option<usize>,
        look: impl FnOnce(&dyn Shown) -> T,
    ) -> Option<T> {
        let run = self.run(solvers)?;
        Some(run.shown(step.unwrap_or(run.n_steps()), look))
    }

    /// As it was given.
    pub(super) fn case(&self) -> Option<Json> {
        serde_json::from_str(&self.case).ok()
    }

    pub(super) fn mistaken(&self) -> &[Mistaken] {
        self.mistaken.get_or_init(|| {
            let mistakes = self.solver.mistakes.iter();
            mistakes
                .filter_map(|mistake| mistake.answer(self.problem.input()))
                .collect()
        })
    }
}

/// What an event is called.
pub(super) fn kind_of(event: &Json) -> Option<&str> {
    event.get("event")?.as_str()
}

/// Cases of more text than this are not remembered.
const MOST_REMEMBERED: usize = 32 << 20;

/// Cases from a reader, each distinct one solved once as long as they are few.
pub(super) struct Cases<R> {
    lines: CaseLines<R>,
    solvers: Solvers,
    /// By all that a case says but for its heading.
    remembered: HashMap<String, Rc<Truth>, FxBuildHasher>,
    n_bytes: usize,
    /// Read and not yet taken.
    next: Option<Known>,
}

impl<R: Read> Cases<R> {
    pub(super) fn new(solvers: Solvers, cases: R) -> Self {
        Self {
            lines: CaseLines::new(cases),
            solvers,
            remembered: HashMap::default(),
            n_bytes: 0,
            next: None,
        }
    }

    /// The next one, which stays the next.
    pub(super) fn peek(&mut self) -> io::Result<Option<&Known>> {
        if self.next.is_none() {
            self.next = self.read()?;
        }
        Ok(self.next.as_ref())
    }

    pub(super) fn next(&mut self) -> io::Result<Option<Known>> {
        match self.next.take() {
            Some(known) => Ok(Some(known)),
            None => self.read(),
        }
    }

    fn read(&mut self) -> io::Result<Option<Known>> {
        let Some((line, content)) = self.lines.next_line()? else {
            return Ok(None);
        };
        let headed = heading(content);
        let remembered = headed
            .as_ref()
            .and_then(|(_, rest)| self.remembered.get(rest));
        if let (Some(truth), Some((heading, _))) = (remembered, &headed) {
            return Ok(Some(known(heading, line, Rc::clone(truth))));
        }
        let (own, truth) = solved(self.solvers, content);
        let truth = Rc::new(truth);
        if let Some((_, rest)) = headed {
            // What is kept of an answer takes several times the room of its text.
            let n_bytes = rest.len()
                + truth
                    .as_ref()
                    .as_ref()
                    .map_or(0, |right| 8 * right.text.len());
            self.n_bytes += n_bytes;
            if self.n_bytes > MOST_REMEMBERED {
                self.remembered.clear();
                self.n_bytes = n_bytes;
            }
            self.remembered.insert(rest, Rc::clone(&truth));
        }
        Ok(Some(known(&own, line, truth)))
    }
}

fn known(heading: &Heading, line: usize, truth: Rc<Truth>) -> Known {
    let Heading { id, submission } = heading.clone();
    Known {
        id,
        submission: (!submission.is_null()).then_some(submission),
        line,
        truth,
    }
}

fn solved(solvers: Solvers, content: CaseLine<'_>) -> (Heading, Truth) {
    let case = match read(solvers, content, Detail::Answers) {
        Ok(case) => case,
        Err(Refused { heading, refusal }) => return (heading, Err(refusal.code)),
    };
    let mut text = Vec::new();
    let written = case.problem.write_output(&mut text);
    let text = written
        .ok()
        .and_then(|()| String::from_utf8(text).ok())
        .unwrap_or_default();
    let line = match content {
        CaseLine::Bytes(bytes) => String::from_utf8_lossy(bytes).into_owned(),
        CaseLine::TooLong => String::new(),
    };
    let right = Right {
        solver: case.solver,
        problem: case.problem,
        output: serde_json::from_str(&text).unwrap_or(Json::Null),
        text,
        case: line,
        steps: OnceCell::new(),
        mistaken: OnceCell::new(),
    };
    (case.heading, Ok(right))
}
