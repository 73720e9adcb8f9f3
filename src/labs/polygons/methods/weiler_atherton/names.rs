//! What vertices, edges and intersections are called: S₁, S₂, … the subject's, through all its rings; C₁, C₂, …
//! the clip polygon's; I₁, I₂, … where they meet, in the subject's order. The numbers are those of the outlines as
//! they were given.

use crate::geom::{Rings, SimplePolygon};

use super::prelude::*;

/// `S₃` or `C₃`.
pub fn vertex(input: &Input, list: List, vertex_idx: usize) -> String {
    match list {
        List::Clip => numbered('C', input.clip.given_vertex(vertex_idx)),
        List::Subject => {
            let subject = &input.subject;
            let ring_idx = subject.rings().ring_of(vertex_idx);
            // Holes are numbered on from the outer ring.
            let rings = std::iter::once(subject.outer()).chain(subject.holes());
            let before: usize = rings.take(ring_idx).map(SimplePolygon::n_given).sum();
            numbered('S', before + subject.given_vertex(vertex_idx))
        }
    }
}

/// `S₃S₄`, in the direction in which it counts.
pub fn edge(input: &Input, list: List, edge_idx: usize) -> String {
    let next = border(input, list).next(edge_idx);
    vertex(input, list, edge_idx) + &vertex(input, list, next)
}

/// `I₂`.
pub fn node(node_idx: u32) -> String {
    numbered('I', node_idx as usize)
}

/// `R₁`.
pub fn ring(ring_idx: usize) -> Value {
    name(numbered('R', ring_idx))
}

/// `S₃`, `I₂` or `S₃ = I₂`.
pub fn entry(input: &Input, list: List, entry: &Entry) -> String {
    let own = entry.vertex().map(|idx| vertex(input, list, idx as usize));
    match (own, entry.node().map(node)) {
        (Some(own), Some(node)) => format!("{own} = {node}"),
        (own, node) => own.or(node).unwrap_or_default(),
    }
}

/// `I₂`, `S₃ = I₂` or `S₃ = C₁ = I₂`: by all its names.
pub fn meeting(input: &Input, node_idx: u32, node: &Intersection) -> String {
    let at_vertex = node.meeting.contact.at_vertex();
    let own = [List::Subject, List::Clip].into_iter().zip(at_vertex);
    let own = own.filter(|&(_, at_vertex)| at_vertex);
    let own = own.map(|(list, _)| vertex(input, list, node.edges[list.idx()] as usize));
    own.chain([self::node(node_idx)])
        .collect::<Vec<_>>()
        .join(" = ")
}

pub const fn label_key(label: IntersectionLabel) -> &'static str {
    match label {
        IntersectionLabel::Entering => "wa-in",
        IntersectionLabel::Leaving => "wa-out",
        IntersectionLabel::Touching => "wa-touches",
        IntersectionLabel::Pinching => "wa-pinches",
    }
}

pub const fn side(side: Side) -> Value {
    Value::Term(match side {
        Side::Inside => "wa-inside",
        Side::Outside => "wa-outside",
        Side::Along => "wa-along",
        Side::Against => "wa-against",
    })
}

pub const fn border(input: &Input, list: List) -> &Rings {
    match list {
        List::Subject => input.subject.rings(),
        List::Clip => input.clip.rings(),
    }
}

pub const fn vertex_link(list: List, vertex_idx: usize) -> Link {
    match list {
        List::Subject => Link::nth("subject-vertex", vertex_idx),
        List::Clip => Link::nth("clip-vertex", vertex_idx),
    }
}

pub const fn node_link(node_idx: u32) -> Link {
    Link::nth("intersection", node_idx as usize)
}
