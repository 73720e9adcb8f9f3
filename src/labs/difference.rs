//! A method that is wrong on purpose beside a right one.

use crate::{
    figure::Run,
    text::{Message, Value},
};

use super::MethodCard;

/// Two methods side by side, one of them wrong.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Difference {
    /// The column that the wrong one stands in.
    pub column: usize,
    /// The first step at which it does something else than it should; none where it never does on this input.
    pub step: Option<usize>,
}

impl Difference {
    /// Of the methods on stage and their runs; `None` unless exactly one of two is wrong on purpose.
    #[must_use]
    pub fn between(methods: &[&MethodCard], runs: &[&dyn Run]) -> Option<Self> {
        let [a, b] = methods else {
            return None;
        };
        if a.is_faulty == b.is_faulty {
            return None;
        }
        let column = usize::from(b.is_faulty);
        let step = runs.get(column)?.differs_at();
        Some(Self { column, step })
    }

    /// "differs from step 7 on", for the title of that column.
    #[must_use]
    pub fn message(self) -> Message {
        match self.step {
            Some(step) => Message::new("differs-from").with("step", Value::Count(step)),
            None => Message::new("differs-nowhere"),
        }
    }
}
