//! Every decision of every method is a question whose options can be said.

use std::{
    collections::{BTreeMap, BTreeSet},
    ops::ControlFlow,
};

use clipscope::{
    figure::{Choice, Decides, Shown, Tick},
    text::{Catalog, Lang, Value},
};

use crate::captions::{record, scenes};

#[test]
fn every_decision_has_options_that_can_be_said_and_differ() {
    let mut right: BTreeMap<(&str, &str), [usize; 2]> = BTreeMap::new();
    let mut silent = BTreeSet::new();
    for scene in scenes() {
        for (card, run) in record(&scene) {
            run.visit([1, run.n_steps()], &mut |step, shown| {
                let place = format!("step {step} of {} on {scene:?}", card.id);
                // What only carries out an earlier decision, a cut or the end, asks nothing: its tick is no test.
                let decides = run.tick(step) == Tick::Test
                    && shown
                        .decision()
                        .is_some_and(|(it, _)| it != Decides::Nothing);
                let choice = options(shown, &place);
                if decides && choice.is_none() {
                    silent.insert((card.id, shown.caption().decision.key));
                }
                if let Some(choice) = choice {
                    let seen = right.entry((card.id, choice.question)).or_default();
                    seen[0] += 1;
                    seen[1] = seen[1].max(choice.options.len());
                }
                ControlFlow::Continue(())
            });
        }
    }
    assert!(
        silent.is_empty(),
        "these decide and ask nothing: {silent:#?}"
    );
    for ((id, question), [_, n_options]) in right {
        assert!(n_options > 1, "{id} asks {question}, which has one answer");
    }
}

/// The options of a step, checked in every language; none where the step answers no question.
fn options(shown: &dyn Shown, place: &str) -> Option<Choice> {
    let question = shown.question()?;
    let choice = shown.options();
    let choice = choice.unwrap_or_else(|| panic!("the answer to {question} is no option: {place}"));
    for lang in Lang::ALL {
        let catalog = Catalog::of(lang);
        let said = |option: &Value| catalog.value(option);
        let mut texts: Vec<String> = choice.options.iter().map(said).collect();
        for text in &texts {
            assert!(
                !text.contains('⟦') && !text.is_empty(),
                "{question} has the option {text:?} in {lang}: {place}"
            );
        }
        texts.sort();
        texts.dedup();
        assert_eq!(
            texts.len(),
            choice.options.len(),
            "two options of {question} read the same in {lang}: {place}"
        );
    }
    Some(choice)
}
