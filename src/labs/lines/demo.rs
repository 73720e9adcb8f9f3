//! What a line clipper that can be shown has beyond any other algorithm.

use serde_json::{Value as Json, json};

use crate::{
    algo::line::Visible,
    geom::Segment,
    labs::{Answer, Demo},
    trace::Algorithm,
};

use super::Scene;

/// A line clipper that can be shown.
pub trait LineDemo: Demo + Algorithm<Output = Visible> {
    /// Can it clip against any convex polygon?
    const TAKES_POLYGON: bool = false;
    /// Does it write outcodes, so that the order of their bits matters?
    const WRITES_CODES: bool = false;

    /// Its input, from the scene and one of its segments.
    fn input(scene: &Scene, segment: Segment) -> Self::Input;
}

impl Answer for Visible {
    fn json(&self) -> Json {
        json!({ "visible": self.is_some(), "segment": self })
    }
}
