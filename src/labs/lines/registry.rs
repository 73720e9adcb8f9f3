//! The lab and its methods. To add one: a file in `algo::line`, its [`LineDemo`] here beside the
//! others, one line below.

use crate::{
    algo::line,
    geom::Segment,
    labs::{self, Lab, Listed, MethodCard, MethodEntry, window_handles},
    trace::{Counted, Counts, silent},
};

use super::{LineDemo, Method, MethodInfo, Pass, Scene, verdict::decided};

/// Segments against a window.
pub static LAB: &dyn Lab = &Lines;

struct Lines;

impl Lab for Lines {
    fn id(&self) -> &'static str {
        "lines"
    }

    fn name_key(&self) -> &'static str {
        "lab-lines"
    }

    fn about_key(&self) -> &'static str {
        "lab-lines-about"
    }

    fn methods(&self) -> Vec<&'static MethodCard> {
        Method::all().map(Method::card).collect()
    }

    fn first_scene(&self) -> labs::Scene {
        Scene::first().into()
    }

    fn lock_groups(&self) -> &'static [&'static str] {
        &["p1", "p2", "segment", window_handles::GROUP, "clip"]
    }
}

const fn info<A: LineDemo>() -> MethodEntry<MethodInfo> {
    MethodEntry {
        card: MethodCard::of::<A>(),
        info: MethodInfo {
            takes_polygon: A::TAKES_POLYGON,
            writes_codes: A::WRITES_CODES,
            record: |scene, segment| labs::record::<A>(A::input(scene, segment)),
            cost: |scene, segment| {
                let input = A::input(scene, segment);
                Counts::of(|| A::run::<Counted>(&input, |_| {})).1
            },
            decided: decided::<A>,
            pass: pass::<A>,
        },
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
pub static METHODS: [MethodEntry<MethodInfo>; 5] = [
    info::<line::BruteForce>(),
    info::<line::CohenSutherland>(),
    info::<line::LiangBarsky>(),
    info::<line::CyrusBeck>(),
    info::<line::NichollLeeNicholl>(),
];

impl Listed for MethodInfo {
    fn all() -> &'static [MethodEntry<Self>] {
        &METHODS
    }
}
