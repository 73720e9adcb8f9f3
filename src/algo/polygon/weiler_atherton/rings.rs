//! What the walks leave: rings, and the answer that they make.

use serde::Serialize;

use crate::geom::{Location, Point, locate};

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

/// What a closed ring is.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum RingKind {
    /// Around a piece, counter-clockwise.
    Outer,
    /// Around a hole in one, clockwise: a whole ring of the subject, as the clip polygon has no holes.
    Hole,
    /// Around a piece so thin that its corners, rounded, run around no area any more. Not a polygon; left out.
    Sliver,
}

/// A closed ring. Consecutive corners may have been rounded to the same point.
#[derive(Clone, PartialEq, Debug)]
pub struct BorderRing {
    /// Its corners.
    pub points: Vec<Point>,
    /// What it is.
    pub kind: RingKind,
}

/// The outer ring that each hole lies in, by their numbers.
pub fn owners(rings: &[BorderRing]) -> Vec<[u32; 2]> {
    let outers = || {
        rings
            .iter()
            .enumerate()
            .filter(|(_, ring)| ring.kind == RingKind::Outer)
    };
    let holes = rings
        .iter()
        .enumerate()
        .filter(|(_, ring)| ring.kind == RingKind::Hole);
    holes
        .filter_map(|(hole_idx, hole)| {
            // A hole touches its piece's border in one point at most; and where a crossing was rounded past a
            // vertex of it, another vertex tells.
            let around = hole.points.iter().find_map(|&p| {
                let mut around =
                    outers().filter(|(_, ring)| locate(&ring.points, p) == Location::Inside);
                around.next()
            });
            around.map(|(outer_idx, _)| [hole_idx as u32, outer_idx as u32])
        })
        .collect()
}

/// Outer rings in order, each with its holes; without repeated corners.
pub fn pieces(rings: &[BorderRing], owners: Vec<[u32; 2]>) -> Vec<OutputPolygon> {
    let mut pieces = Vec::new();
    let mut holes: Vec<Option<Vec<Point>>> = Vec::new();
    let mut piece_of = Vec::new();
    for BorderRing { points, kind } in rings {
        piece_of.push(pieces.len());
        let is_hole = *kind == RingKind::Hole;
        holes.push(is_hole.then(|| without_repeats(points)));
        if *kind == RingKind::Outer {
            pieces.push(OutputPolygon {
                outer: without_repeats(points),
                holes: Vec::new(),
            });
        }
    }
    for [hole_idx, outer_idx] in owners {
        if let Some(hole) = holes[hole_idx as usize].take() {
            pieces[piece_of[outer_idx as usize]].holes.push(hole);
        }
    }
    pieces
}

fn without_repeats(ring: &[Point]) -> Vec<Point> {
    let mut points = ring.to_vec();
    points.dedup();
    while points.len() > 1 && points.first() == points.last() {
        points.pop();
    }
    points
}
