//! What stays in a proof by picture, whatever the reader drags.

mod planes;
mod screens;
mod window;

use std::ops::ControlFlow;

use clipscope::{
    algo::why::{Proof, Why},
    labs::{Click, LABS},
    trace::{laws, silent},
};

/// The laws of told runs, and the last number of a fact.
fn shown<P: Proof>(input: &P::Input) -> impl Fn(P::Fact) -> Option<f64> + use<P>
where
    P::Input: std::fmt::Debug,
    P::Fact: std::fmt::Debug,
{
    laws::check::<Why<P>>(input);
    let facts = silent::<Why<P>>(input);
    move |fact| facts.get(fact)
}

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-9 * (1.0 + a.abs().max(b.abs()))
}

/// Its steps are not those of the method that decides about the scene.
#[test]
fn a_proof_runs_on_its_labs_first_scene_and_decides_nothing() {
    let mut n_proofs = 0;
    for lab in LABS {
        let methods = (lab.methods)().into_iter();
        for card in methods.filter(|card| card.is_proof) {
            let mut scene = (lab.first_scene)();
            scene.document_mut().set_method(card.id);
            let document = scene.document();
            let run = document.record().swap_remove(0);
            assert!(!run.is_refused() && run.n_steps() > 0, "{}", card.id);
            run.visit([1, run.n_steps()], &mut |_, shown| {
                assert!(shown.decision().is_none(), "{}", card.id);
                ControlFlow::Continue(())
            });
            let [min, max] = document.bounds();
            let at = [min[0].midpoint(max[0]), min[1].midpoint(max[1]), 0.0];
            let click = Click {
                at,
                reach: 1.0,
                ..Click::default()
            };
            let told = document
                .asked(&click)
                .and_then(|link| document.verdict(link, (&*run, 0)));
            assert!(lab.id != "lines" || told.is_none(), "{}", card.id);
            n_proofs += 1;
        }
    }
    assert_eq!(n_proofs, 12);
}
