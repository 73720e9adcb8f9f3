//! What makes an algorithm one that a case can name.

use serde::Serialize;

use crate::{
    labs::{Answer, telling::Telling},
    trace::{Listening, Method, Real, Told},
};

use super::{
    Fields,
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

/// The memory after a run over the scalar `R`, and how many steps it tells.
pub(super) fn metered<A: Solve, R: Real>(
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
