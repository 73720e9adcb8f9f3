//! Where a method that is wrong on purpose first differs from the right one beside it.

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
    /// The first step at which they differ; none where they do the same on this input.
    pub step: Option<usize>,
}

impl Difference {
    /// Compares the runs of the methods on stage; `None` unless exactly one of two is wrong on purpose.
    #[must_use]
    pub fn between(methods: &[&MethodCard], runs: &[&dyn Run]) -> Option<Self> {
        let ([a, b], [first, second]) = (methods, runs) else {
            return None;
        };
        if a.is_faulty == b.is_faulty {
            return None;
        }
        Some(Self {
            column: usize::from(b.is_faulty),
            step: first.first_difference(*second),
        })
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
