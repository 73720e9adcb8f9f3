//! What a line clipper that can be shown has beyond any other method.

use serde_json::{Value as Json, json};

use crate::{
    algo::line::Visible,
    geom::Segment,
    labs::{Answer, telling::Telling},
    trace::Method,
};

use super::Scene;

/// A line clipper that can be shown. Of a step that decides about the segment it names `rejects`, the border by which that is
/// rejected; and `enters` and `leaves`, where the segment's line comes in only after it has gone out.
pub trait LineTelling: Telling<Scenery = ()> + Method<Output = Visible> {
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
