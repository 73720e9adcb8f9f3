//! How an algorithm joins, and what it makes of a case.

use serde_json::Value as Json;

use crate::{
    figure::Run,
    labs::{
        Answer, Demo, MethodCard, record,
        telling::{Recorded, Telling},
    },
    text::Message,
    trace::{Counted, Counts, silent, told},
};

use super::{Field, Fields, Given, Refusal};

/// An algorithm that a case can name: what it reads, and how its answer is told.
pub trait Solve: Demo {
    /// What a case gives besides `id` and `algorithm`, in the order in which it is checked.
    const FIELDS: &'static [Field];

    /// Its input from checked fields, and what is told of them.
    ///
    /// # Errors
    /// The first field whose value is refused.
    fn read(fields: &Fields<'_>) -> Result<(Self::Input, Told), Refusal>;

    /// Its answer in one sentence.
    fn verdict(output: &Self::Output) -> Message;
}

/// The same of a method that is told by a table.
pub trait SolveTold: Telling {
    /// What a case gives besides `id` and `algorithm`, in the order in which it is checked.
    const FIELDS: &'static [Field];

    /// Its input from checked fields, and what is told of them.
    ///
    /// # Errors
    /// The first field whose value is refused.
    fn read(fields: &Fields<'_>) -> Result<(Self::Input, Told), Refusal>;

    /// Its answer in one sentence.
    fn verdict(output: &Self::Output) -> Message;
}

/// What is given, put into words only when somebody reads it.
pub type Told = Box<dyn Fn() -> Vec<Given>>;

/// An algorithm that a case can name, with its type erased.
pub struct Solver {
    card: MethodCard,
    fields: &'static [Field],
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
            read: read_problem::<A>,
        }
    }

    /// By this method.
    #[must_use]
    pub const fn told<M: SolveTold>() -> Self {
        Self {
            card: MethodCard::told::<M>(),
            fields: M::FIELDS,
            read: read_told::<M>,
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
    /// What is given, for people.
    fn given(&self) -> Vec<Given>;
    /// The answer as a program would ask for it: nothing counted, nothing recorded.
    fn output(&self) -> Json;
    /// The answer and its cost, without recording the steps.
    fn cost(&self) -> (Json, Counts);
    /// Every step.
    fn run(&self) -> Box<dyn Run>;
    /// The answer in one sentence.
    fn verdict(&self) -> Message;
}

/// The problem that fields describe for this algorithm.
pub(super) fn read_problem<A: Solve>(fields: &Fields<'_>) -> Result<Box<dyn Solvable>, Refusal> {
    let (input, told) = A::read(fields)?;
    Ok(Box::new(SolvableOf::<A> { input, told }))
}

struct SolvableOf<A: Solve> {
    input: A::Input,
    told: Told,
}

impl<A: Solve> Solvable for SolvableOf<A> {
    fn given(&self) -> Vec<Given> {
        (self.told)()
    }

    fn output(&self) -> Json {
        silent::<A>(&self.input).json()
    }

    fn cost(&self) -> (Json, Counts) {
        let (output, counts) = Counts::of(|| A::run::<Counted>(&self.input, |_| {}));
        (output.json(), counts)
    }

    fn run(&self) -> Box<dyn Run> {
        record::<A>(self.input.clone())
    }

    fn verdict(&self) -> Message {
        A::verdict(&silent::<A>(&self.input))
    }
}

/// The problem that fields describe for this method.
pub(super) fn read_told<M: SolveTold>(fields: &Fields<'_>) -> Result<Box<dyn Solvable>, Refusal> {
    let (input, told) = M::read(fields)?;
    Ok(Box::new(SolvableBy::<M> { input, told }))
}

struct SolvableBy<M: SolveTold> {
    input: M::Input,
    told: Told,
}

impl<M: SolveTold> Solvable for SolvableBy<M> {
    fn given(&self) -> Vec<Given> {
        (self.told)()
    }

    fn output(&self) -> Json {
        told::silent::<M>(&self.input).json()
    }

    fn cost(&self) -> (Json, Counts) {
        let (held, counts) = Counts::of(|| told::held_after::<M, Counted>(&self.input));
        (M::output(held).json(), counts)
    }

    fn run(&self) -> Box<dyn Run> {
        Box::new(Recorded::<M>::new(self.input.clone(), None))
    }

    fn verdict(&self) -> Message {
        M::verdict(&told::silent::<M>(&self.input))
    }
}
