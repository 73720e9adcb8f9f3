//! How an algorithm joins, and what it makes of a case.

use std::convert::Infallible;

use serde_json::Value as Json;

use crate::{
    figure::Run,
    input::Field,
    labs::{Answer, MethodCard, recorded::Recorded, telling::Telling},
    text::Message,
    trace::{Counted, Counts, Listening, Told, held_after, silent},
};

use super::{Code, Detail, Fields, Path, Refusal};

/// An algorithm that a case can name: what it reads, and how its answer is told.
pub trait Solve: Telling {
    /// What a case gives besides `id` and `algorithm`, in the order in which it is checked.
    const FIELDS: &'static [Field];
    /// What the answer's `output` holds.
    const OUTPUT: &'static [Field];
    /// The field by which a case is refused whose report would have more steps than [`Detail::MOST_STEPS`]; `None` where
    /// the limits on the fields' sizes are enough.
    const LONG_BY: Option<&'static str> = None;

    /// Its input from checked fields.
    ///
    /// # Errors
    /// The first field whose value is refused.
    fn read(fields: &Fields<'_>) -> Result<Self::Input, Refusal>;

    /// Its answer in one sentence.
    fn verdict(output: &Self::Output) -> Message;

    /// The answer's `output`, from that of its run.
    #[must_use]
    fn told_output(_input: &Self::Input, of_run: Json) -> Json {
        of_run
    }
}

/// An algorithm that a case can name, with its type erased.
pub struct Solver {
    card: MethodCard,
    fields: &'static [Field],
    output: &'static [Field],
    read: ReadProblem,
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
            read: read_problem::<A>,
        }
    }

    /// The same, with problems that are read in another way: where a field asks for another type.
    pub(super) const fn reading(self, read: ReadProblem) -> Self {
        Self { read, ..self }
    }

    /// As the command line and JSON spell it.
    #[must_use]
    pub const fn id(&self) -> &'static str {
        self.card.id
    }

    /// Catalogue key of its name.
    #[must_use]
    pub const fn name_key(&self) -> &'static str {
        self.card.name_key
    }

    /// Author and year.
    #[must_use]
    pub const fn source(&self) -> &'static str {
        self.card.source
    }

    /// What a case gives besides `id` and `algorithm`, in the order in which it is checked.
    #[must_use]
    pub const fn fields(&self) -> &'static [Field] {
        self.fields
    }

    /// What the answer's `output` holds.
    #[must_use]
    pub const fn output(&self) -> &'static [Field] {
        self.output
    }

    /// The problem that checked fields describe.
    ///
    /// # Errors
    /// The first field whose value is refused.
    pub fn read(&self, fields: &Fields<'_>) -> Result<Box<dyn Solvable>, Refusal> {
        (self.read)(fields)
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
        self.iter().find(|solver| solver.id() == id)
    }
}

/// A case that can be solved.
pub trait Solvable {
    /// The answer as a program would ask for it: nothing counted, nothing recorded.
    fn output(&self) -> Json;
    /// The answer and its cost, without recording the steps.
    fn cost(&self) -> (Json, Counts);
    /// Every step.
    fn run(&self) -> Box<dyn Run>;
    /// The answer of such a run.
    fn output_of(&self, run: &dyn Run) -> Json;
    /// The answer in one sentence.
    fn verdict(&self) -> Message;
}

/// The problem that fields describe for this algorithm.
pub(super) fn read_problem<A: Solve>(fields: &Fields<'_>) -> Result<Box<dyn Solvable>, Refusal> {
    let input = A::read(fields)?;
    if let Some(field) = A::LONG_BY {
        check_steps::<A>(&input, field, fields.detail())?;
    }
    Ok(Box::new(SolvableOf::<A>(input)))
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

struct SolvableOf<A: Solve>(A::Input);

impl<A: Solve> SolvableOf<A> {
    fn told(&self, output: &A::Output) -> Json {
        A::told_output(&self.0, output.json())
    }
}

impl<A: Solve> Solvable for SolvableOf<A> {
    fn output(&self) -> Json {
        self.told(&silent::<A>(&self.0))
    }

    fn cost(&self) -> (Json, Counts) {
        let (held, counts) = Counts::of(|| held_after::<A, Counted>(&self.0));
        (self.told(&A::output(held)), counts)
    }

    fn run(&self) -> Box<dyn Run> {
        Box::new(Recorded::<A>::new(self.0.clone(), None))
    }

    fn output_of(&self, run: &dyn Run) -> Json {
        A::told_output(&self.0, run.output_json())
    }

    fn verdict(&self) -> Message {
        A::verdict(&silent::<A>(&self.0))
    }
}
