//! Answers in one sentence.

use crate::{
    algo::polygon::{ClippedRing, RingOutcome, Triangulation, Vertex},
    geom::{Point, Polygon},
    labs::vertex_symbol,
    text::{Formula, Message},
};

/// Points, or triangles, beyond these are left out.
const MAX_SHOWN: usize = 16;

/// Of each ring its vertices, in parentheses.
pub fn polygons<'a>(rings: impl ExactSizeIterator<Item = &'a [Point]>) -> Message {
    let n = rings.len();
    if n == 0 {
        return Message::new("case-nothing-left");
    }
    let mut shown = Formula::default();
    let mut n_points = 0;
    for (i, ring) in rings.enumerate() {
        if n_points + ring.len() > MAX_SHOWN && i > 0 {
            shown = shown.sym("; …");
            break;
        }
        if i > 0 {
            shown = shown.sym("; ");
        }
        n_points += ring.len();
        for (k, p) in ring.iter().take(MAX_SHOWN).enumerate() {
            let gap = if k > 0 { " " } else { "" };
            shown = shown.sym(gap).point(p.to_array());
        }
        if ring.len() > MAX_SHOWN {
            shown = shown.sym(" …");
        }
    }
    Message::new("case-polygons")
        .with("n", n)
        .with("rings", shown)
}

/// The one ring of Sutherland–Hodgman, where there is something to fill.
pub fn ring<V: Vertex>(ring: &ClippedRing<V>) -> Message {
    if ring.outcome == RingOutcome::Degenerate {
        return Message::new("case-no-area");
    }
    let polygon = ring.polygon();
    polygons(polygon.as_slice().iter().map(Polygon::vertices))
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
