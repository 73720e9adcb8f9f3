//! The methods of this lab. To add one: a file in `algo::line`, its [`LineDemo`] here beside the
//! others, one line below.

use std::fmt;

use serde::{Deserialize, Deserializer, Serialize, Serializer, de};

use crate::{
    algo::line::{self, Visible},
    figure::Run,
    geom::Segment,
    labs::{self, MethodCard},
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
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Method(usize);

impl Method {
    /// In the order of the registry.
    pub fn all() -> impl ExactSizeIterator<Item = Self> {
        (0..METHODS.len()).map(Self)
    }

    /// The method with this id.
    #[must_use]
    pub fn by_id(id: &str) -> Option<Self> {
        METHODS.iter().position(|info| info.card.id == id).map(Self)
    }

    /// What is known of it.
    #[must_use]
    pub fn info(self) -> &'static MethodInfo {
        &METHODS[self.0]
    }

    /// Its names, source and pseudocode.
    #[must_use]
    pub fn card(self) -> &'static MethodCard {
        &self.info().card
    }

    /// Runs it on one segment of the scene.
    #[must_use]
    pub fn record(self, scene: &Scene, segment: Segment) -> Box<dyn Run> {
        (self.info().record)(scene, segment)
    }

    /// Its answer for one segment of the scene, as a program would ask for it.
    #[must_use]
    pub fn clip(self, scene: &Scene, segment: Segment) -> Visible {
        (self.info().clip)(scene, segment)
    }

    /// The same answer and how many operations it took, without recording the steps.
    #[must_use]
    pub fn cost(self, scene: &Scene, segment: Segment) -> (Visible, Counts) {
        (self.info().cost)(scene, segment)
    }

    /// Clips all `segments` silently each time it is called; the number of those that are visible.
    #[must_use]
    pub fn pass(self, scene: &Scene, segments: &[Segment]) -> Pass {
        (self.info().pass)(scene, segments)
    }
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.card().id)
    }
}

impl Serialize for Method {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.card().id)
    }
}

impl<'de> Deserialize<'de> for Method {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let id = String::deserialize(deserializer)?;
        Self::by_id(&id).ok_or_else(|| {
            let known: Vec<&str> = METHODS.iter().map(|info| info.card.id).collect();
            de::Error::custom(format!(
                "unknown method `{id}`: expected one of {}",
                known.join(", ")
            ))
        })
    }
}
