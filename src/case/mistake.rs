//! What a case would be answered by a program with a mistake that is known.

use std::any::Any;

use serde::Serialize;

use crate::{
    labs::telling::Telling,
    trace::{Method, Told, told},
};

use super::{prelude::*, solve::Solve};

/// An answer with its steps, which a mistake leads to.
#[derive(Clone, PartialEq, Debug)]
pub struct Mistaken {
    /// Of the mistake, as reports have it.
    pub id: &'static str,
    /// Catalogue key of what is wrong.
    pub name_key: &'static str,
    /// As of an answer.
    pub output: Json,
    /// In order.
    pub events: Vec<Json>,
}

/// An `output`, and the steps that led to it.
type Answered = Option<(Json, Vec<Json>)>;

/// What is known to be got wrong in an algorithm, whose type is erased.
#[derive(Debug)]
pub struct Mistake {
    id: &'static str,
    name_key: &'static str,
    answered: fn(&dyn Any) -> Answered,
}

impl Mistake {
    /// Of `A`, as one that can be stepped in the window.
    pub(super) const fn of<A: Solve, W>() -> Self
    where
        W: Telling + Method<Input = A::Input, Output = A::Output>,
    {
        Self::called::<A, W>(W::ID, W::NAME_KEY)
    }

    /// Of `A`, as one that has no other name.
    pub(super) const fn called<A: Solve, W>(id: &'static str, name_key: &'static str) -> Self
    where
        W: Method<Input = A::Input, Output = A::Output, Event: Serialize>,
    {
        Self {
            id,
            name_key,
            answered: |input| answered::<A, W>(input.downcast_ref()?),
        }
    }

    /// What it makes of an input of its algorithm; `None` where it does not end, or comes to numbers that are none.
    #[must_use]
    pub fn answer(&self, input: &dyn Any) -> Option<Mistaken> {
        let (output, events) = (self.answered)(input)?;
        Some(Mistaken {
            id: self.id,
            name_key: self.name_key,
            output,
            events,
        })
    }
}

fn answered<A, W>(input: &A::Input) -> Answered
where
    A: Solve,
    W: Method<Input = A::Input, Output = A::Output, Event: Serialize>,
{
    let (mut held, mut events) = (W::begin(input), Vec::new());
    let most = W::max_events(input).min(Detail::MOST_STEPS);
    let mut keep = |_: &W::Held, event: W::Event| {
        if events.len() == most || !A::NUMBERS.have_all_of(&event) {
            return Told::Break(());
        }
        events.push(json!(event));
        Told::Continue(())
    };
    match told::<W>(input, &mut held, &mut keep) {
        Told::Continue(()) => Some((json!(A::told(input, &W::output(held))), events)),
        Told::Break(()) => None,
    }
}
