//! Why a crossing is a weighted mean. An edge's line that passes between the ends parts the way across it into w₁ and w₂, so it is met after the part
//! t = w₁ / (w₁ + w₂). The triangle up to there has the angles of that of the whole segment: it is the same, t times as large, so t of the way is done along the
//! edge, too. Put together, that is the mean of both ends, each weighted by the distance of the other. *Cost*: that of two crossings.

use serde::Serialize;

use crate::{
    algo::line::WindowInput,
    geom::{Axis, Edge, Point},
    trace::{Real, Told},
};

use super::Proof;

/// The proof; see the module.
#[derive(Clone, Copy, Debug)]
pub struct Mean;

/// What is shown, in order. "Across" is measured at right angles to the edge, "along" beside it.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum MeanFact {
    /// No edge's line passes between the ends. The end.
    Nothing,
    /// How far P₁ is from the edge's line: w₁.
    First,
    /// How far P₂ is from it: w₂.
    Second,
    /// The part of the way across that comes before the line: t.
    Part,
    /// How far the segment goes along the edge until then.
    Rise,
    /// The coordinate of the crossing along the edge, as a weighted mean.
    Mean,
    /// The same mean of the coordinates across: the edge's own. The end.
    Given,
}

impl Mean {
    /// The first edge whose line passes between both ends.
    #[must_use]
    pub fn edge(WindowInput { window, segment }: &WindowInput) -> Option<Edge> {
        Edge::ALL.into_iter().find(|&edge| {
            let [from, to] = [segment.p1, segment.p2].map(|at| split(at, edge)[0]);
            let border = window.border(edge);
            from.min(to) < border && border < from.max(to)
        })
    }
}

/// A point's coordinates across an edge and along it.
const fn split(at: Point, edge: Edge) -> [f64; 2] {
    match edge.axis() {
        Axis::X => [at.x(), at.y()],
        Axis::Y => [at.y(), at.x()],
    }
}

impl Proof for Mean {
    type Input = WindowInput;
    type Fact = MeanFact;

    fn prove<R: Real, S>(
        input: &WindowInput,
        show: &mut impl FnMut(MeanFact, R) -> Told<S>,
    ) -> Told<S> {
        let Some(edge) = Self::edge(input) else {
            return show(MeanFact::Nothing, R::new(0.0));
        };
        let [from, to] = [input.segment.p1, input.segment.p2].map(|at| split(at, edge).map(R::new));
        let border = R::new(input.window.border(edge));
        let [w1, w2] = if from[0] < to[0] {
            [border - from[0], to[0] - border]
        } else {
            [from[0] - border, border - to[0]]
        };
        show(MeanFact::First, w1)?;
        show(MeanFact::Second, w2)?;
        let t = w1 / (w1 + w2);
        show(MeanFact::Part, t)?;
        show(MeanFact::Rise, t * (to[1] - from[1]))?;
        let mean = |i: usize| (from[i] * w2 + to[i] * w1) / (w1 + w2);
        show(MeanFact::Mean, mean(1))?;
        show(MeanFact::Given, mean(0))
    }

    fn max_facts(_: &WindowInput) -> usize {
        6
    }
}
