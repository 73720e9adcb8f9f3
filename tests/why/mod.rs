//! What stays in a proof by picture, whatever the reader drags.

mod planes;

use clipscope::{
    algo::why::{Proof, Why},
    trace::{laws, silent},
};

/// The laws of told runs, and the last number of a fact.
fn shown<P: Proof>(input: &P::Input) -> impl Fn(P::Fact) -> Option<f64>
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
