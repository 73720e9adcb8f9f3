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

#[test]
fn what_an_edge_is_said_to_put_out_is_what_the_run_then_puts_out() {
    let mut seen = BTreeSet::new();
    for scene in scenes() {
        // A mistake may put out something else than its rule says.
        for (card, run) in record(&scene)
            .into_iter()
            .filter(|(card, _)| !card.is_faulty)
        {
            run.visit([1, run.n_steps()], &mut |step, shown| {
                if shown.question() != Some("puts-out") {
                    return ControlFlow::Continue(());
                }
                let Some(Choice { options, right, .. }) = shown.options() else {
                    panic!("step {step} of {} has no options", card.id);
                };
                let Value::Message(said) = &options[right] else {
                    panic!("{:?} is no sentence", options[right]);
                };
                let of_edge = |step: &usize| {
                    let event = run.event_json(*step);
                    let name = event["event"].as_str().unwrap_or_default().to_owned();
                    ["cross", "output"].contains(&&*name).then_some(name)
                };
                let after: Vec<String> = (step + 1..=run.n_steps())
                    .map_while(|it| of_edge(&it))
                    .collect();
                let n_out = after.iter().filter(|name| *name == "output").count();
                let (crosses, puts) = match said.key {
                    "option-puts-nothing" => (false, 0),
                    "option-puts-end" => (false, 1),
                    "option-puts-crossing" => (true, 1),
                    "option-puts-both" => (true, 2),
                    other => panic!("{other} is no answer"),
                };
                let place = format!("step {step} of {} on {scene:?}", card.id);
                assert_eq!(
                    after.first().is_some_and(|name| name == "cross"),
                    crosses,
                    "{place}"
                );
                // In a pipeline the next stage takes what is put out.
                if card.id != "sutherland-hodgman-pipeline" {
                    assert_eq!(n_out, puts, "{place}");
                }
                seen.insert(said.key);
                ControlFlow::Continue(())
            });
        }
    }
    assert_eq!(seen.len(), 4, "{seen:?}");
}
