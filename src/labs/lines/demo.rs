//! What a line clipper that can be shown has beyond any other algorithm.

use serde_json::{Value as Json, json};

use crate::{
    algo::line::Visible,
    geom::Segment,
    labs::{Answer, Demo},
    text::Value,
    trace::Algorithm,
};

use super::Scene;

/// What an event says of the segment's fate.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Settles {
    /// Nothing that decides it.
    Nothing,
    /// The last of these is the test that decided it.
    Asked,
    /// The same: the border of this number rejects it.
    Rejects(usize),
    /// What follows from the test before: the border of this number has rejected it.
    Rejected(usize),
}

/// A line clipper that can be shown.
pub trait LineDemo: Demo + Algorithm<Output = Visible> {
    /// Can it clip against any convex polygon?
    const TAKES_POLYGON: bool = false;
    /// Does it write outcodes, so that the order of their bits matters?
    const WRITES_CODES: bool = false;

    /// Its input, from the scene and one of its segments.
    fn input(scene: &Scene, segment: Segment) -> Self::Input;

    /// What an event says of the segment's fate.
    fn settles(event: &Self::Event, input: &Self::Input) -> Settles;

    /// The borders by which the segment's line comes in and goes out, where it comes in only after it has gone out.
    #[must_use]
    fn between(_: &Self::State) -> Option<[Value; 2]> {
        None
    }
}

impl Answer for Visible {
    fn json(&self) -> Json {
        json!({ "visible": self.is_some(), "segment": self })
    }
}
