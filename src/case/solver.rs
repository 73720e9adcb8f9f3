//! How an algorithm joins, and what it makes of a case.

use std::{convert::Infallible, io};

use serde::Serialize;

use crate::{
    figure::Run,
    labs::{Answer, MethodCard, recorded::Recorded, telling::Telling},
    trace::{Counted, Listening, Method, Told, held_after, silent},
};

use super::{Fields, finite::Numbers, prelude::*};

/// Makes an algorithm's input of checked fields, or refuses the first whose value means nothing.
pub type Reading<A> = fn(&Fields<'_>) -> Result<<A as Method>::Input, Refusal>;
/// Tells an algorithm's answer in one sentence.
pub type Verdict<A> = fn(&<A as Method>::Output) -> Message;

/// An algorithm that a case can name: what it reads, and how its answer is told.
pub trait Solve: Telling {
    /// What a case gives besides `id` and `algorithm`, in the order in which it is checked.
    const FIELDS: &'static [Field];
    /// What the answer's `output` holds.
    const OUTPUT: &'static [Field];
    /// The field by which a case is refused whose report would have more steps than [`Detail::MOST_STEPS`]; `None` where
    /// the limits on the fields' sizes are enough.
    const LONG_BY: Option<&'static str> = None;
    /// What the numbers of its answer and of its events may be.
    const NUMBERS: Numbers = Numbers::Finite;
    /// Its input.
    const READ: Reading<Self>;
    /// Its answer in one sentence.
    const VERDICT: Verdict<Self>;

    /// The answer's `output`, from that of its run.
    fn told(_input: &Self::Input, output: &Self::Output) -> impl Serialize {
        output.told()
    }
}

/// An algorithm that a case can name, with its type erased.
pub struct Solver {
    /// Its names and its source.
    pub card: MethodCard,
    /// [`Solve::FIELDS`].
    pub fields: &'static [Field],
    /// [`Solve::OUTPUT`].
    pub output: &'static [Field],
    /// [`Solve::NUMBERS`].
    pub numbers: Numbers,
    pub(super) read: ReadProblem,
}

type ReadProblem = fn(&Fields<'_>) -> Result<Box<dyn Solvable>, Refusal>;

impl Solver {
    /// By this algorithm.
    #[must_use]
    pub const fn of<A: Solve>() -> Self {
        Self {
            card: MethodCard::of::<A>(),
            fields: A::FIELDS,
            output: A::OUTPUT,
            numbers: A::NUMBERS,
            read: read_problem::<A>,
        }
    }
}

/// The solvers that cases can name: tables, one a lab.
#[derive(Clone, Copy)]
pub struct Solvers(&'static [&'static [Solver]]);

impl Solvers {
    /// These, in the order in which they are taught.
    #[must_use]
    pub const fn new(tables: &'static [&'static [Solver]]) -> Self {
        Self(tables)
    }

    /// In order.
    pub fn iter(self) -> impl Iterator<Item = &'static Solver> {
        self.0.iter().copied().flatten()
    }

    /// The one of this name.
    #[must_use]
    pub fn by_id(self, id: &str) -> Option<&'static Solver> {
        self.iter().find(|solver| solver.card.id == id)
    }
}

/// A case that has been solved.
pub trait Solvable {
    /// The answer's `output` as a program would ask for it: nothing counted, nothing recorded.
    fn output(&self) -> Json;
    /// Writes the answer's `output`, number by number.
    ///
    /// # Errors
    /// Where it cannot be written.
    fn write_output(&self, out: &mut dyn io::Write) -> serde_json::Result<()>;
    /// The answer's cost.
    fn counts(&self) -> Counts;
    /// Every step.
    fn run(&self) -> Box<dyn Run>;
    /// The answer in one sentence.
    fn verdict(&self) -> Message;
}

pub(super) fn read_problem<A: Solve>(fields: &Fields<'_>) -> Result<Box<dyn Solvable>, Refusal> {
    let input = A::READ(fields)?;
    if let Some(field) = A::LONG_BY {
        check_steps::<A>(&input, field, fields.detail())?;
    }
    let (held, counts) = Counts::of(|| held_after::<A, Counted>(&input));
    let output = A::output(held);
    if !fields.is_moderate() {
        check_range::<A>(&input, &output, fields)?;
    }
    Ok(Box::new(Solved::<A> {
        input,
        output,
        counts,
    }))
}

/// Refuses a report of too many steps.
fn check_steps<A: Solve>(
    input: &A::Input,
    field: &'static str,
    detail: Detail,
) -> Result<(), Refusal> {
    let most = detail.limit(Detail::MOST_STEPS);
    // The bound may be far above what there will be.
    if A::max_events(input) <= most {
        return Ok(());
    }
    let mut n_steps = 0;
    let mut counting = Listening(|_: &A::Held, _| {
        n_steps += 1;
        Told::<Infallible>::Continue(())
    });
    let Told::Continue(()) = A::run::<f64, _>(input, &mut A::begin(input), &mut counting);
    if n_steps <= most {
        return Ok(());
    }
    let problem = Message::new("case-too-many-steps")
        .with("found", n_steps)
        .with("max", most);
    Err(Refusal::at(Code::TooLarge, &Path::Field(field), problem))
}

/// Refuses what has a number in its answer, or in a step that is told, which would be larger than any.
#[cold]
fn check_range<A: Solve>(
    input: &A::Input,
    output: &A::Output,
    fields: &Fields<'_>,
) -> Result<(), Refusal> {
    if !A::NUMBERS.have_all_of(&A::told(input, output)) {
        return Err(fields.beyond_range("case-beyond-range"));
    }
    if fields.detail() == Detail::Answers {
        return Ok(());
    }
    let mut looking = Listening(|_: &A::Held, event| {
        if A::NUMBERS.have_all_of(&event) {
            Told::Continue(())
        } else {
            Told::Break(())
        }
    });
    let told = A::run::<f64, _>(input, &mut A::begin(input), &mut looking);
    match told {
        Told::Continue(()) => Ok(()),
        Told::Break(()) => Err(fields.beyond_range("case-step-beyond-range")),
    }
}

struct Solved<A: Solve> {
    input: A::Input,
    output: A::Output,
    counts: Counts,
}

impl<A: Solve> Solvable for Solved<A> {
    fn output(&self) -> Json {
        json!(A::told(&self.input, &silent::<A>(&self.input)))
    }

    fn write_output(&self, out: &mut dyn io::Write) -> serde_json::Result<()> {
        serde_json::to_writer(out, &A::told(&self.input, &self.output))
    }

    fn counts(&self) -> Counts {
        self.counts
    }

    fn run(&self) -> Box<dyn Run> {
        Box::new(Recorded::<A>::new(self.input.clone(), None))
    }

    fn verdict(&self) -> Message {
        A::VERDICT(&self.output)
    }
}
