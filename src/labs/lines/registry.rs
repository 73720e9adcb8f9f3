//! The methods of this lab. To add one: a file in `algo::line`, its [`LineDemo`] here beside the
//! others, one line below.

use crate::{
    algo::line::{self, Visible},
    figure::Run,
    geom::Segment,
    labs::{self, Listed, MethodCard},
    trace::{Counted, Counts, silent},
};

use super::{LineDemo, Scene};

/// What is known of a method without running it.
pub struct MethodInfo {
    /// Names, source and pseudocode.
    pub card: MethodCard,
    /// Can it clip against any convex polygon?
    pub takes_polygon: bool,
    /// Does it write outcodes, so that the order of their bits matters?
    pub writes_codes: bool,
    record: fn(&Scene, Segment) -> Box<dyn Run>,
    clip: fn(&Scene, Segment) -> Visible,
    cost: fn(&Scene, Segment) -> (Visible, Counts),
    pass: fn(&Scene, &[Segment]) -> Pass,
}

/// Clips a batch, the same one each time it is called; the number of segments that are visible.
pub type Pass = Box<dyn FnMut() -> usize>;

const fn info<A: LineDemo>() -> MethodInfo {
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
pub static METHODS: [MethodInfo; 5] = [
    info::<line::BruteForce>(),
    info::<line::CohenSutherland>(),
    info::<line::LiangBarsky>(),
    info::<line::CyrusBeck>(),
    info::<line::NichollLeeNicholl>(),
];

/// One of [`METHODS`].
pub type Method = labs::Method<MethodInfo>;

impl Listed for MethodInfo {
    fn all() -> &'static [Self] {
        &METHODS
    }

    fn card(&self) -> &MethodCard {
        &self.card
    }
}

impl MethodInfo {
    /// Runs it on one segment of the scene.
    #[must_use]
    pub fn record(&self, scene: &Scene, segment: Segment) -> Box<dyn Run> {
        (self.record)(scene, segment)
    }

    /// Its answer for one segment of the scene, as a program would ask for it.
    #[must_use]
    pub fn clip(&self, scene: &Scene, segment: Segment) -> Visible {
        (self.clip)(scene, segment)
    }

    /// The same answer and how many operations it took, without recording the steps.
    #[must_use]
    pub fn cost(&self, scene: &Scene, segment: Segment) -> (Visible, Counts) {
        (self.cost)(scene, segment)
    }

    /// Clips all `segments` silently each time it is called; the number of those that are visible.
    #[must_use]
    pub fn pass(&self, scene: &Scene, segments: &[Segment]) -> Pass {
        (self.pass)(scene, segments)
    }
}
