//! What the names of its table stand for.

use crate::{
    geom::Axis,
    labs::{
        interval::value_of,
        words::{along, axis_symbol},
    },
};

use super::{names, prelude::*};

pub fn found_named(input: &Input, event: &Event, name: &str) -> Option<Named> {
    let Event::Found {
        node_idx,
        edges: [s, c],
        contact,
        at,
        t,
        u,
        along: list,
    } = *event
    else {
        return None;
    };
    let edges = [s, c].map(|idx| idx as usize);
    let edge = |list: List| names::edge(input, list, edges[list.idx()]).into();
    let vertex = |list: List| names::vertex(input, list, edges[list.idx()]).into();
    let mean = |axis| {
        let ends = names::border(input, list).edge(edges[list.idx()]);
        mean(axis, ends, [t, u][list.idx()], at).into()
    };
    Some(match (name, contact) {
        ("node", _) => names::node(node_idx).into(),
        ("subject", Contact::BothVertices) => vertex(Subject),
        ("clip", Contact::BothVertices) => vertex(Clip),
        ("vertex", Contact::SubjectVertex) => vertex(Subject),
        ("vertex", _) => vertex(Clip),
        ("edge", Contact::SubjectVertex) | ("clip" | "clip-edge", _) => edge(Clip),
        ("edge" | "subject" | "subject-edge", _) => edge(Subject),
        ("at", _) => at.to_array().into(),
        ("t", _) => value_of(t).into(),
        ("u", _) => value_of(u).into(),
        ("x", _) => mean(Axis::X),
        ("y", _) => mean(Axis::Y),
        _ => return None,
    })
}

pub fn node_named(
    step: &Step<'_, WeilerAtherton>,
    event: Event,
    node_idx: u32,
    name: &str,
) -> Option<Named> {
    let node = step.held.lists.nodes.get(node_idx as usize)?;
    let clip_edge = node.edges[1] as usize;
    let is_crossing = node.meeting.contact == Contact::Crossing;
    Some(match (name, event) {
        ("node", _) => Named::from(names::node(node_idx)).linked(names::node_link(node_idx)),
        ("vertex", _) => names::vertex(step.input, Clip, clip_edge).into(),
        ("edge", _) => names::edge(step.input, Clip, clip_edge).into(),
        ("u", _) => value_of(node.meeting.u).into(),
        ("at", Event::Labelled { .. }) if is_crossing => return None,
        ("at", _) => node.meeting.at.to_array().into(),
        ("label", Event::Labelled { label: it, .. }) => label(it).into(),
        ("before", Event::Labelled { before, .. }) => names::side(before).into(),
        ("after", Event::Labelled { after, .. }) => names::side(after).into(),
        ("a₁", _) if is_crossing => node.meeting.t.num.into(),
        ("a₂", _) if is_crossing => other_distance(node.meeting.t).into(),
        ("order", Event::Labelled { label, .. }) => {
            let is_entering = label == Entering;
            let order = if is_entering { " < 0 < " } else { " > 0 > " };
            order.to_owned().into()
        }
        _ => return None,
    })
}

pub fn ring_named(step: &Step<'_, WeilerAtherton>, event: Event, name: &str) -> Option<Named> {
    let (held, input) = (step.held, step.input);
    let last = held.rings.last();
    Some(match (name, event) {
        ("at", Event::Vertex { at, .. } | Event::Visit { at, .. }) => at.to_array().into(),
        (
            _,
            Event::Vertex {
                list,
                vertex_idx: i,
                ..
            },
        ) => match name {
            "vertex" => names::vertex(input, list, i as usize).into(),
            "edge" => names::edge(input, list, i as usize).into(),
            _ => return None,
        },
        ("entry", Event::Visit { list, place, .. }) => {
            let entry = held.lists.entries[list.idx()].get(place as usize)?;
            let vertex = entry
                .vertex()
                .map(|idx| names::vertex_link(list, idx as usize));
            let link = vertex.or(entry.node().map(names::node_link));
            let named = Named::from(names::entry(input, list, entry));
            Named { link, ..named }
        }
        ("n", Event::Visit { corner, .. }) => (held.walk.path.len() + usize::from(!corner)).into(),
        ("n", Event::Closed { .. }) => last?.points.len().into(),
        ("n", Event::Done { .. }) => {
            let outer = held.rings.iter().filter(|it| it.kind == Outer);
            outer.count().into()
        }
        ("at", Event::Closed { .. }) => last?.points.first()?.to_array().into(),
        ("ring", Event::Closed { .. }) => names::ring(held.rings.len() - 1).into(),
        ("ring", Event::Whole { kind, .. }) => {
            names::ring(held.rings.len() - usize::from(kind.is_some())).into()
        }
        ("ring", Event::Hole { outer_idx, .. }) => names::ring(outer_idx as usize).into(),
        ("hole", Event::Hole { hole_idx, .. }) => names::ring(hole_idx as usize).into(),
        ("hole", Event::Whole { ring_idx, .. }) => (ring_idx as usize).into(),
        ("side", Event::Whole { side, .. }) => names::side(side).into(),
        _ => return None,
    })
}

pub const fn label(label: IntersectionLabel) -> Value {
    Value::Term(match label {
        Entering => "wa-mark-entering",
        Leaving => "wa-mark-leaving",
        Touching | Pinching => names::label_key(label),
    })
}

/// Of the edge's other end.
fn other_distance(Ratio { num, den }: Ratio) -> f64 {
    num - den
}

/// `x = (0 · 2 + 6 · 4) / (4 + 2) = 4`: the mean of an edge's ends, weighted by their distances from the other one; where
/// both are 0 there is nothing to compute.
fn mean(axis: Axis, ends: [Point; 2], ratio: Ratio, at: Point) -> Formula {
    let part = Formula::default;
    let [o1, o2] = ends.map(|p| along(p, axis)[0]);
    if [o1, o2] == [0.0, 0.0] {
        return part().sym(axis_symbol(axis)).sym(" = ").num(0.0);
    }
    let (w1, w2) = (ratio.num.abs(), other_distance(ratio).abs());
    let weighted = |f: Formula, o: f64, w: f64| f.operand(o).sym(" · ").num(w);
    let sum = part().num(o1).sym(" · ").num(w2).sym(" + ");
    part()
        .sym(axis_symbol(axis))
        .sym(" = ")
        .over(weighted(sum, o2, w1), part().num(w1).sym(" + ").num(w2))
        .equals(along(at, axis)[0])
}
