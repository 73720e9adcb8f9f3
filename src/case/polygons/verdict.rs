//! Answers in one sentence.

use crate::{
    algo::polygon::{
        ClippedRing, RingOutcome, Triangulation, Vertex,
        weiler_atherton::{Relation, WeilerAthertonOutput},
    },
    geom::Point,
    labs::vertex_symbol,
    text::{Formula, Message},
};

/// Points, or triangles, beyond these are left out.
const MAX_SHOWN: usize = 16;

/// How many there are, and of each ring its vertices; a minus sign stands before a hole.
pub fn polygons<'a>(n: usize, rings: impl Iterator<Item = (&'a [Point], bool)>) -> Message {
    if n == 0 {
        return Message::new("case-nothing-left");
    }
    let mut shown = Formula::default();
    let mut n_points = 0;
    for (i, (ring, is_hole)) in rings.enumerate() {
        if i > 0 {
            shown = shown.sym(if is_hole { " − " } else { "; " });
        }
        for (k, p) in ring.iter().take(MAX_SHOWN - n_points).enumerate() {
            let gap = if k > 0 { " " } else { "" };
            shown = shown.sym(gap).point(p.to_array());
        }
        n_points += ring.len();
        if n_points > MAX_SHOWN {
            shown = shown.sym(" …");
            break;
        }
    }
    Message::new("case-polygons")
        .with("n", n)
        .with("rings", shown)
}

/// Polygons with their holes.
pub fn pieces(clipped: &WeilerAthertonOutput) -> Message {
    if clipped.relation == Relation::Touching {
        return Message::new("case-no-area");
    }
    let rings = clipped.pieces.iter().flat_map(|piece| {
        let holes = piece.holes.iter().map(|hole| (&hole[..], true));
        std::iter::once((&piece.outer[..], false)).chain(holes)
    });
    polygons(clipped.pieces.len(), rings)
}

/// The one ring of Sutherland–Hodgman, where there is something to fill.
pub fn ring<V: Vertex>(ring: &ClippedRing<V>) -> Message {
    if ring.outcome == RingOutcome::Degenerate {
        return Message::new("case-no-area");
    }
    let polygon = ring.polygon();
    let rings = polygon.iter().map(|polygon| (polygon.vertices(), false));
    polygons(rings.len(), rings)
}

/// `V₁V₂V₃, V₁V₃V₄`.
pub fn triangles(whole: &Triangulation) -> Message {
    let triangles = whole.triangles();
    let names: Vec<String> = triangles
        .iter()
        .take(MAX_SHOWN)
        .map(|triangle| triangle.map(vertex_symbol).concat())
        .collect();
    let more = if triangles.len() > MAX_SHOWN {
        ", …"
    } else {
        ""
    };
    Message::new("case-triangles")
        .with("n", triangles.len())
        .with("triangles", names.join(", ") + more)
}
