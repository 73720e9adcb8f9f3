//! The methods of this lab. To add one: a file in `algo::line`, its [`LineDemo`] here beside the
//! others, one line below.

use crate::{
    algo::line,
    geom::Segment,
    labs::{self, Carded, Listed, MethodCard},
    trace::{Counted, Counts, silent},
};

use super::{LineDemo, MethodInfo, Pass, Scene, verdict::decided};

const fn info<A: LineDemo>() -> MethodInfo<Scene> {
    MethodInfo {
        card: MethodCard::of::<A>(),
        takes_polygon: A::TAKES_POLYGON,
        writes_codes: A::WRITES_CODES,
        record: |scene, segment| labs::record::<A>(A::input(scene, segment)),
        clip: |scene, segment| silent::<A>(&A::input(scene, segment)),
        cost: |scene, segment| {
            let input = A::input(scene, segment);
            Counts::of(|| A::run::<Counted>(&input, |_| {}))
        },
        decided: decided::<A>,
        pass: pass::<A>,
    }
}

/// Inputs are made beforehand: only the clipping itself is left to measure.
fn pass<A: LineDemo>(scene: &Scene, segments: &[Segment]) -> Pass {
    let inputs: Vec<A::Input> = segments
        .iter()
        .map(|&segment| A::input(scene, segment))
        .collect();
    Box::new(move || inputs.iter().filter_map(silent::<A>).count())
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
