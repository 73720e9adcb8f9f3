//! From a line to a problem, and to its answer as a line of JSON.

use std::io::{self, Write};

use serde::Serialize;

use crate::{labs::telling::Each, text::nearest};

use super::{
    CaseLine, Fields, Id, MAX_LINE_BYTES, Solvable, Solver, Solvers,
    fields::missing,
    prelude::*,
    raw::{Node, Pairs, not_a},
};

/// What a case, or an answer, is called.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Heading {
    /// What it calls itself; null where it does not.
    pub id: Id,
    /// Of many that are in one stream the one that it belongs to; null where it says none.
    pub submission: Id,
}

/// A case that can be solved.
pub struct Case {
    /// What it calls itself, and whose it is.
    pub heading: Heading,
    /// By which algorithm.
    pub solver: &'static Solver,
    /// What to solve.
    pub problem: Box<dyn Solvable>,
}

/// A case that cannot.
#[derive(Clone, PartialEq, Debug)]
pub struct Refused {
    /// Null where they could not be read.
    pub heading: Heading,
    /// Why.
    pub refusal: Refusal,
}

/// Reads one case for one of `solvers`, of which so much is to be written.
///
/// # Errors
/// The first mistake, in the order that the [module](super) states.
pub fn read(solvers: Solvers, line: CaseLine<'_>, detail: Detail) -> Result<Case, Refused> {
    let mut heading = Heading::default();
    match read_into(solvers, line, detail, &mut heading) {
        Ok((solver, problem)) => Ok(Case {
            heading,
            solver,
            problem,
        }),
        Err(refusal) => Err(Refused { heading, refusal }),
    }
}

fn read_into(
    solvers: Solvers,
    line: CaseLine<'_>,
    detail: Detail,
    heading: &mut Heading,
) -> Result<(&'static Solver, Box<dyn Solvable>), Refusal> {
    let pairs = pairs(text(line)?)?;
    let mut unread = Ok(());
    let Heading { id, submission } = heading;
    for (name, own) in [("id", id), ("submission", submission)] {
        match pairs.get(name).map(|raw| Id::read(name, raw)) {
            Some(Ok(read)) => *own = read,
            Some(Err(refusal)) => unread = unread.and(Err(refusal)),
            None => {}
        }
    }
    pairs.check_once(Path::Field)?;
    unread?;
    let (solver, fields) = fields(solvers, &pairs, detail)?;
    Ok((solver, (solver.read)(&fields)?))
}

/// What a case is called, and what else it says: two cases that say the same have the same answer. `None` where it is no
/// object.
#[must_use]
pub fn heading(line: CaseLine<'_>) -> Option<(Heading, String)> {
    let pairs = text(line).and_then(pairs).ok()?;
    let (mut heading, mut rest) = (Heading::default(), String::new());
    for (name, raw) in &pairs.0 {
        match name.as_str() {
            "id" => heading.id = Id::read(name, raw).ok()?,
            "submission" => heading.submission = Id::read(name, raw).ok()?,
            _ => {
                for part in [name, "\0", raw.get(), "\0"] {
                    rest.push_str(part);
                }
            }
        }
    }
    let is_repeated = pairs.check_once(Path::Field).is_err();
    (!is_repeated).then_some((heading, rest))
}

/// What a case gives, for people; nothing of one that is refused.
pub(super) fn told(solvers: Solvers, line: CaseLine<'_>, detail: Detail) -> Vec<Given> {
    let pairs = text(line).and_then(pairs);
    let told = pairs.and_then(|pairs| Ok(fields(solvers, &pairs, detail)?.1.told()));
    told.unwrap_or_default()
}

fn fields<'a>(
    solvers: Solvers,
    pairs: &Pairs<'a>,
    detail: Detail,
) -> Result<(&'static Solver, Fields<'a>), Refusal> {
    let solver = algorithm(solvers, pairs.get("algorithm"))?;
    let fields = Fields::check(solver.card.name_key, solver.fields, pairs, detail)?;
    Ok((solver, fields))
}

fn text(line: CaseLine<'_>) -> Result<&str, Refusal> {
    match line {
        CaseLine::TooLong => {
            let max = MAX_LINE_BYTES >> 20;
            let problem = Message::new("case-line-too-long").with("max", max);
            Err(Refusal::whole(Code::TooLarge, problem))
        }
        CaseLine::Bytes(bytes) => std::str::from_utf8(bytes).map_err(|error| {
            let problem = Message::new("case-not-utf8").with("byte", error.valid_up_to() + 1);
            Refusal::whole(Code::BadJson, problem)
        }),
    }
}

fn pairs(text: &str) -> Result<Pairs<'_>, Refusal> {
    let bad_json = |error: &serde_json::Error| {
        let problem = Message::new("case-bad-json").with("column", error.column());
        Refusal::whole(Code::BadJson, problem)
    };
    let error = match serde_json::from_str(text) {
        Ok(pairs) => return Ok(pairs),
        Err(error) => error,
    };
    if !error.is_data() {
        return Err(bad_json(&error));
    }
    // Valid up to here, but not an object; the rest may still be no JSON at all.
    let whole: &RawValue = serde_json::from_str(text).map_err(|error| bad_json(&error))?;
    Err(Refusal::whole(Code::WrongType, not_a("json-object", whole)))
}

fn algorithm(solvers: Solvers, raw: Option<&RawValue>) -> Result<&'static Solver, Refusal> {
    let path = Path::Field("algorithm");
    let raw = raw.ok_or_else(|| missing(&path))?;
    let name = Node { path, raw }.text()?;
    solvers.by_id(&name).ok_or_else(|| {
        let known: Vec<&str> = solvers.iter().map(|solver| solver.card.id).collect();
        let problem = match nearest(&name, known.iter().copied()) {
            Some(meant) => Message::new("case-meant-algorithm").with("meant", meant.to_owned()),
            None => Message::new("case-unknown-algorithm"),
        };
        let problem = problem.with("name", short(&name));
        let problem = problem.with("expected", known.join(", "));
        Refusal::at(Code::UnknownAlgorithm, &path, problem)
    })
}

#[derive(Serialize)]
struct RefusedAnswer<'a> {
    id: &'a Id,
    #[serde(skip_serializing_if = "Id::is_null")]
    submission: &'a Id,
    /// Of the input, counted from 1.
    line: usize,
    error: Json,
}

impl Case {
    /// Its answer, without a line break. A raster is written as it is read off, and so are steps: neither is held as text.
    pub(super) fn write_json(&self, detail: Detail, out: &mut impl Write) -> io::Result<()> {
        let (id, algorithm) = (self.heading.id.json(), self.solver.card.id);
        write!(out, r#"{{"id":{id},"#)?;
        if !self.heading.submission.is_null() {
            write!(out, r#""submission":{},"#, self.heading.submission.json())?;
        }
        write!(out, r#""algorithm":"{algorithm}","output":"#)?;
        self.problem.write_output(out)?;
        out.write_all(br#","counts":"#)?;
        serde_json::to_writer(&mut *out, &self.problem.counts())?;
        if detail == Detail::Steps {
            let run = self.problem.run();
            let events = Each(|| (1..=run.n_steps()).map(|step| run.event_json(step)));
            out.write_all(br#","events":"#)?;
            serde_json::to_writer(&mut *out, &events)?;
        }
        out.write_all(b"}")
    }
}

impl Refused {
    /// Its answer, without a line break.
    pub(super) fn write_json(&self, line: usize, out: impl Write) -> serde_json::Result<()> {
        let Refusal { code, field, .. } = &self.refusal;
        let error = json!({ "code": code.id(), "field": field, "message": self.refusal.message() });
        let Heading { id, submission } = &self.heading;
        let answer = RefusedAnswer {
            id,
            submission,
            line,
            error,
        };
        serde_json::to_writer(out, &answer)
    }
}
