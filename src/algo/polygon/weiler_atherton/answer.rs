//! What Weiler–Atherton answers.

use serde::Serialize;

use crate::geom::Point;

/// How the two lie, exactly.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Relation {
    /// No point in common.
    Disjoint,
    /// Common points or edges, and no common area.
    Touching,
    /// The subject is part of the clip polygon, and is the answer. Borders may touch.
    SubjectInside,
    /// The clip polygon is part of the subject, and is the answer. Borders may touch.
    ClipInside,
    /// The same set of points.
    Equal,
    /// A common area, and neither is part of the other.
    Crossing,
}

/// A polygon of the answer.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct OutputPolygon {
    /// Counter-clockwise.
    pub outer: Vec<Point>,
    /// Clockwise.
    pub holes: Vec<Vec<Point>>,
}

/// The answer.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct WeilerAthertonOutput {
    /// Of the two as given.
    pub relation: Relation,
    /// With disjoint interiors. None where there is no common area, or none is left after rounding.
    pub pieces: Vec<OutputPolygon>,
}
