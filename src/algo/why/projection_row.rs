//! Why row 3 of the projection is what it is. z′ = a · depth + b has to lie on the lower border of clip space, −w, for the near plane, and on the
//! upper border, w, for the far plane: two points fix a line, its slope is a and its height at depth 0 is b. After the divide a point is read where
//! the line from 0 through it meets a ruler; equal steps of depth crowd there towards far. *Cost*: three divisions.

use serde::Serialize;

use crate::{
    geom::{Sight, ViewVolume},
    trace::{Real, Told},
};

use super::Proof;

/// The proof; see the module.
#[derive(Clone, Copy, Debug)]
pub struct ProjectionRow;

/// A view volume, and how deep a point is.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ProjectionRowInput {
    /// Whose near and far planes fix the row.
    pub volume: ViewVolume,
    /// −z of a point in view space.
    pub depth: f64,
}

/// What is shown, in order.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum ProjectionRowFact {
    /// z′ of the near plane: −w.
    Near,
    /// z′ of the far plane: w.
    Far,
    /// How much z′ grows for each unit of depth.
    Slope,
    /// z′ at depth 0.
    AtZero,
    /// z′ of the point.
    Point,
    /// z′/w of the point; none where w = 0.
    Divided,
    /// At which depth z′ = 0, the middle of the range: the end.
    Middle,
}

impl ProjectionRowInput {
    /// w of a depth.
    #[must_use]
    pub const fn w(&self, depth: f64) -> f64 {
        match self.volume.sight() {
            Sight::Perspective => depth,
            Sight::Parallel => 1.0,
        }
    }
}

impl Proof for ProjectionRow {
    type Input = ProjectionRowInput;
    type Fact = ProjectionRowFact;

    fn prove<R: Real, S>(
        input: &ProjectionRowInput,
        show: &mut impl FnMut(ProjectionRowFact, R) -> Told<S>,
    ) -> Told<S> {
        let ends = [input.volume.near(), input.volume.far()];
        let [near, far] = ends.map(R::new);
        let [low, high] = ends.map(|depth| R::new(input.w(depth)));
        show(ProjectionRowFact::Near, -low)?;
        show(ProjectionRowFact::Far, high)?;
        let slope = (high + low) / (far - near);
        show(ProjectionRowFact::Slope, slope)?;
        let start = -low - slope * near;
        show(ProjectionRowFact::AtZero, start)?;
        let depth = R::new(input.depth);
        let at = slope * depth + start;
        show(ProjectionRowFact::Point, at)?;
        let w = input.w(input.depth);
        if w != 0.0 {
            show(ProjectionRowFact::Divided, at / R::new(w))?;
        }
        show(ProjectionRowFact::Middle, -start / slope)
    }

    fn max_facts(_: &ProjectionRowInput) -> usize {
        7
    }
}
