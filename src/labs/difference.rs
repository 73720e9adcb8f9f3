//! A method that is wrong on purpose beside a right one.

use crate::{
    figure::{Comparison, Run},
    text::{Message, Value},
};

use super::MethodCard;

/// How methods stand beside each other: where one is wrong on purpose apart, but for one that only does too much.
pub fn comparison(methods: &[&MethodCard], runs: &[&dyn Run]) -> Comparison {
    let is_same = || {
        runs.windows(2)
            .all(|pair| pair[0].output_json() == pair[1].output_json())
    };
    if methods.iter().any(|method| method.is_faulty) && !is_same() {
        Comparison::Apart
    } else {
        Comparison::between(runs)
    }
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Difference {
    pub column: usize,
    /// The first step at which it does something else than it should; none where it never does on this input.
    pub step: Option<usize>,
}

impl Difference {
    /// Of the methods on stage and their runs; `None` unless exactly one is wrong on purpose, and another is not.
    pub fn between(methods: &[&MethodCard], runs: &[&dyn Run]) -> Option<Self> {
        let mut wrong = (0..methods.len()).filter(|&i| methods[i].is_faulty);
        let column = wrong.next()?;
        if methods.len() < 2 || wrong.next().is_some() {
            return None;
        }
        let step = runs.get(column)?.differs_at();
        Some(Self { column, step })
    }

    /// "differs from step 7 on", for the title of that column.
    pub fn message(self) -> Message {
        match self.step {
            Some(step) => Message::new("differs-from").with("step", Value::Count(step)),
            None => Message::new("differs-nowhere"),
        }
    }
}
