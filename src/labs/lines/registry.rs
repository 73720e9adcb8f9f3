//! The lab and its methods. To add one: a file in `algo::line`, its [`LineTelling`] here beside the
//! others, one line below.

use crate::{
    algo::{
        line::{
            self, WindowInput,
            faulty::{
                FaultyCohenSutherland, FaultyLiangBarsky, LooksOnce, OutwardCyrusBeck,
                RejectsTwoOutside,
            },
        },
        why::{DoubleArea, Mean, Strips, Why},
    },
    figure::Body,
    geom::Segment,
    labs::{
        Lab, Listed, MethodCard, MethodEntry, recorded::Recorded, telling::Telling, window_handles,
    },
    trace::{self, Counted, Counts, held_after, silent},
};

use super::{
    LineTelling, Method, MethodInfo, Pass, Scene,
    verdict::{decided, dropped},
};

pub static LAB: &Lab = &Lab {
    id: "lines",
    name_key: "lab-lines",
    about_key: "lab-lines-about",
    recording_key: "recording-segments",
    methods: || Method::all().map(Method::card).collect(),
    first_scene: || Scene::first().into(),
    smallest_scene: || Scene::first().into(),
    lock_groups: &["p1", "p2", "segment", window_handles::GROUP, "clip"],
    controls: Vec::new,
    adopt: |_| None,
    outlines: &[],
};

const fn info<M: LineTelling>() -> MethodEntry<MethodInfo> {
    wrong::<M, M>()
}

/// Of one that is wrong on purpose a run knows where it first differs from that of `Right`.
const fn wrong<M: LineTelling, Right>() -> MethodEntry<MethodInfo>
where
    Right: trace::Method<Input = M::Input, Event = M::Event>,
{
    MethodEntry {
        card: MethodCard::of::<M>(),
        info: MethodInfo {
            takes_polygon: M::TAKES_POLYGON,
            writes_codes: M::WRITES_CODES,
            record: |scene, segment| {
                let run = Recorded::<M>::beside::<Right>(M::input(scene, segment), None);
                Box::new(run.ending_in(scene.costs_of_all().map(Body::Costs)))
            },
            cost: |scene, segment| {
                let input = M::input(scene, segment);
                Counts::of(|| held_after::<M, Counted>(&input)).1
            },
            decided: decided::<M>,
            dropped: dropped::<M>,
            pass: pass::<M>,
        },
    }
}

/// The proof of a formula by which `Proved` clips: what is done to all other segments is done by that.
const fn why<M, Proved: LineTelling>() -> MethodEntry<MethodInfo>
where
    M: Telling<Scenery = (), Input: From<WindowInput>>,
{
    let proved = info::<Proved>();
    MethodEntry {
        card: MethodCard::of::<M>(),
        info: MethodInfo {
            record: |scene, segment| {
                let input = M::Input::from(scene.with(segment));
                Box::new(Recorded::<M>::new(input, None))
            },
            ..proved.info
        },
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

/// Every method, in the order in which they are taught; mistakes last.
pub static METHODS: [MethodEntry<MethodInfo>; 12] = [
    info::<line::BruteForce>(),
    info::<line::CohenSutherland>(),
    info::<line::LiangBarsky>(),
    info::<line::CyrusBeck>(),
    info::<line::NichollLeeNicholl>(),
    why::<Why<Mean>, line::BruteForce>(),
    why::<Why<Strips>, line::LiangBarsky>(),
    why::<Why<DoubleArea>, line::NichollLeeNicholl>(),
    wrong::<FaultyCohenSutherland<LooksOnce>, line::CohenSutherland>(),
    wrong::<FaultyCohenSutherland<RejectsTwoOutside>, line::CohenSutherland>(),
    wrong::<FaultyLiangBarsky, line::LiangBarsky>(),
    wrong::<OutwardCyrusBeck, line::CyrusBeck>(),
];

impl Listed for MethodInfo {
    fn all() -> &'static [MethodEntry<Self>] {
        &METHODS
    }
}
