//! The methods of this lab. To add one: a file in `algo::line`, its [`LineTelling`] here beside the
//! others, one line below.

use crate::{
    algo::line,
    geom::Segment,
    labs::{Carded, Listed, MethodCard, telling::Recorded},
    trace::{
        Counted, Counts,
        told::{held_after, silent},
    },
};

use super::{LineTelling, MethodInfo, Pass, Scene, verdict::decided};

const fn info<M: LineTelling>() -> MethodInfo<Scene> {
    MethodInfo {
        card: MethodCard::told::<M>(),
        takes_polygon: M::TAKES_POLYGON,
        writes_codes: M::WRITES_CODES,
        record: |scene, segment| Box::new(Recorded::<M>::new(M::input(scene, segment), None)),
        clip: |scene, segment| silent::<M>(&M::input(scene, segment)),
        cost: |scene, segment| {
            let input = M::input(scene, segment);
            let (held, counts) = Counts::of(|| held_after::<M, Counted>(&input));
            (M::output(held), counts)
        },
        decided: decided::<M>,
        pass: pass::<M>,
    }
}

/// Inputs are made beforehand: only the clipping itself is left to measure.
fn pass<M: LineTelling>(scene: &Scene, segments: &[Segment]) -> Pass {
    let inputs: Vec<M::Input> = segments
        .iter()
        .map(|&segment| M::input(scene, segment))
        .collect();
    Box::new(move || inputs.iter().filter_map(silent::<M>).count())
}

/// Every method, in the order in which they are taught.
pub static METHODS: [MethodInfo<Scene>; 5] = [
    info::<line::BruteForce>(),
    info::<line::CohenSutherland>(),
    info::<line::LiangBarsky>(),
    info::<line::CyrusBeck>(),
    info::<line::NichollLeeNicholl>(),
];

impl Carded for MethodInfo<Scene> {
    fn card(&self) -> &MethodCard {
        &self.card
    }
}

impl Listed for MethodInfo<Scene> {
    fn all() -> &'static [Self] {
        &METHODS
    }
}
