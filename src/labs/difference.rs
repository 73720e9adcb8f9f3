//! A method that is wrong on purpose beside a right one.

use crate::{
    figure::{Comparison, Run, Words},
    text::{Message, Value},
};

use super::{MethodCard, Scene};

/// How methods stand beside each other: one that is wrong on purpose over the right one, where the answers differ.
pub fn comparison(methods: &[&MethodCard], runs: &[&dyn Run]) -> Comparison {
    let is_same = || {
        runs.windows(2)
            .all(|pair| pair[0].output_json() == pair[1].output_json())
    };
    let faulty: Vec<bool> = methods.iter().map(|method| method.is_faulty).collect();
    match faulty[..] {
        _ if !faulty.contains(&true) || is_same() => Comparison::between(runs),
        [true, false] => Comparison::over(runs, 0),
        [false, true] => Comparison::over(runs, 1),
        _ => Comparison::Apart,
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

    /// The same of a scene's methods and what has been recorded of it.
    pub fn in_scene(scene: &Scene, recorded: &[Box<dyn Run>]) -> Option<Self> {
        let runs: Vec<&dyn Run> = recorded.iter().map(|run| &**run).collect();
        Self::between(&scene.document().methods(), &runs)
    }

    /// The kind of event of a scene's mistake at its first difference; none where there is no difference, or no mistake.
    pub fn kind_in(scene: &Scene) -> Option<Words> {
        let recorded = scene.document().record();
        let Self { column, step } = Self::in_scene(scene, &recorded)?;
        let mut words = Words::default();
        recorded[column].read_words(step?, &mut words);
        Some(words.name())
    }

    /// "differs from step 7 on", for the title of that column.
    pub fn message(self) -> Message {
        match self.step {
            Some(step) => Message::new("differs-from").with("step", Value::Count(step)),
            None => Message::new("differs-nowhere"),
        }
    }
}
