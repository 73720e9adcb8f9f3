//! How an algorithm joins, and what it makes of a case.

use std::{any::Any, io};

use crate::{
    figure::Run,
    labs::{MethodCard, recorded::Recorded},
    trace::{Counted, Told, silent, told},
};

use super::{
    Fields, Mistake,
    budget::Meter,
    finite::Numbers,
    prelude::*,
    solve::{Solve, metered},
};

/// An algorithm that a case can name, with its type erased.
pub struct Solver {
    /// Its names and its source.
    pub card: MethodCard,
    /// [`Solve::FIELDS`].
    pub fields: &'static [Field],
    /// [`Solve::OUTPUT`].
    pub output: &'static [Field],
    /// [`Solve::SYMBOLS_KEY`].
    pub symbols_key: Option<&'static str>,
    /// [`Solve::BUDGET`].
    pub budget: u64,
    /// [`Solve::NUMBERS`].
    pub numbers: Numbers,
    /// What is known to be got wrong in it.
    pub mistakes: &'static [Mistake],
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
            symbols_key: A::SYMBOLS_KEY,
            budget: A::BUDGET,
            numbers: A::NUMBERS,
            mistakes: &[],
            read: read_problem::<A>,
        }
    }

    pub(super) const fn knowing(self, mistakes: &'static [Mistake]) -> Self {
        Self { mistakes, ..self }
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
    /// Is another value of a field of `output` as right as this one, though not the same?
    fn admits(&self, field: &str, said: &Json) -> bool;
    /// What is solved, as the algorithm reads it.
    fn input(&self) -> &dyn Any;
}

pub(super) fn read_problem<A: Solve>(fields: &Fields<'_>) -> Result<Box<dyn Solvable>, Refusal> {
    let input = A::READ(fields)?;
    let mut meter = Meter::new(A::BUDGET);
    let (made, counts) = Counts::of(|| match fields.detail() {
        Detail::Answers => {
            A::answer_alone::<Counted>(&input, &mut meter).map_continue(|output| (output, 0))
        }
        Detail::Steps => metered::<A, Counted>(&input, &mut meter)
            .map_continue(|(held, n_steps)| (A::output(held), n_steps)),
    });
    let Told::Continue((output, n_steps)) = made else {
        let problem = Message::new("case-over-budget").with("max", A::BUDGET as usize);
        return Err(fields.too_much(problem));
    };
    if let Some(field) = A::LONG_BY
        && n_steps > Detail::MOST_STEPS
    {
        let problem = Message::new("case-too-many-steps")
            .with("found", n_steps)
            .with("max", Detail::MOST_STEPS);
        return Err(Refusal::at(Code::TooLarge, &Path::Field(field), problem));
    }
    if !fields.is_moderate() {
        check_range::<A>(&input, &output, fields)?;
    }
    Ok(Box::new(Solved::<A> {
        input,
        output,
        counts,
    }))
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
    let mut look = |_: &A::Held, event| {
        if A::NUMBERS.have_all_of(&event) {
            Told::Continue(())
        } else {
            Told::Break(())
        }
    };
    match told::<A>(input, &mut A::begin(input), &mut look) {
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

    fn admits(&self, field: &str, said: &Json) -> bool {
        A::admits(&self.input, &self.output, field, said)
    }

    fn input(&self) -> &dyn Any {
        &self.input
    }
}
