//! How an algorithm joins, and what it makes of a case.

use std::{any::Any, io};

use serde::Serialize;

use crate::{
    figure::Run,
    labs::{Answer, MethodCard, recorded::Recorded, telling::Telling},
    trace::{Counted, Listening, Method, Real, Told, silent},
};

use super::{
    Fields, Mistake,
    budget::{Meter, OverBudget},
    finite::Numbers,
    prelude::*,
};

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
    /// Catalogue key of what the symbols of its formulas mean, where no sentence says it.
    const SYMBOLS_KEY: Option<&'static str> = None;
    /// The field by which a case is refused whose report would have more steps than [`Detail::MOST_STEPS`]; `None` where
    /// the limits on the fields' sizes are enough.
    const LONG_BY: Option<&'static str> = None;
    /// So many steps a case may be: a few seconds of work, and less than 1 GB.
    const BUDGET: u64 = 500_000_000;
    /// What the numbers of its answer and of its events may be.
    const NUMBERS: Numbers = Numbers::Finite;
    /// Its input.
    const READ: Reading<Self>;
    /// Its answer in one sentence.
    const VERDICT: Verdict<Self>;

    /// For how many steps an event counts that has just been told: the pixels that are painted with it.
    #[inline(always)]
    fn cost(_input: &Self::Input, _held: &Self::Held, _event: &Self::Event) -> u64 {
        1
    }

    /// The run that is made where no step is asked for: the taught one, unless there is one that comes to the same answer sooner.
    ///
    /// # Errors
    /// It is over its budget.
    #[inline(always)]
    fn answer_alone<R: Real>(
        input: &Self::Input,
        meter: &mut Meter,
    ) -> Told<OverBudget, Self::Output> {
        let (held, _) = metered::<Self, R>(input, meter)?;
        Told::Continue(Self::output(held))
    }

    /// Is another value of a field of `output` as right as this one? Only where more than one is.
    fn admits(_input: &Self::Input, _output: &Self::Output, _field: &str, _said: &Json) -> bool {
        false
    }

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

/// The memory after a run over the scalar `R`, and how many steps it tells.
fn metered<A: Solve, R: Real>(
    input: &A::Input,
    meter: &mut Meter,
) -> Told<OverBudget, (<A as Method>::Held, usize)> {
    let (mut held, mut n_told) = (A::begin(input), 0);
    let mut counting = Listening(|held: &A::Held, event| {
        n_told += 1;
        meter.add(A::cost(input, held, &event))
    });
    A::run::<R, _>(input, &mut held, &mut counting)?;
    Told::Continue((held, n_told))
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

    fn admits(&self, field: &str, said: &Json) -> bool {
        A::admits(&self.input, &self.output, field, said)
    }

    fn input(&self) -> &dyn Any {
        &self.input
    }
}
