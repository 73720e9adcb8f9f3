//! The sentences of Weiler–Atherton, with the numbers of their step.

use crate::{
    algo::{
        line::Ratio,
        polygon::weiler_atherton::{
            Contact, IntersectionLabel, List, Relation, RingKind, Side,
            WeilerAthertonEvent as Event, WeilerAthertonInput as Input,
            WeilerAthertonState as State,
        },
    },
    figure::Caption,
    geom::{Axis, Point},
    labs::words::{along, axis_symbol, name, point_formula},
    text::{Formula, Message, Value},
};

use super::names;

pub fn opening(input: &Input) -> Caption {
    Caption::new(
        Message::new("wa-opening")
            .with("n", names::border(input, List::Subject).points().len())
            .with("m", names::border(input, List::Clip).points().len()),
    )
}

pub fn caption(event: &Event, before: &State, input: &Input) -> Caption {
    match *event {
        Event::Vertex {
            list,
            vertex_idx,
            at,
        } => vertex(list, vertex_idx as usize, at, input),
        Event::Found { .. } => found(event, input),
        Event::Inserted {
            node_idx,
            at_vertex,
            ..
        } => inserted(node_idx, at_vertex, before, input),
        Event::Labelled {
            node_idx,
            label,
            before: from,
            after: to,
        } => labelled(node_idx, label, [from, to], before),
        Event::Start { node_idx } => start(node_idx, before),
        Event::Visit {
            list,
            place,
            at,
            corner,
        } => visit(list, place, at, corner, before, input),
        Event::Switch { node_idx, to, .. } => switch(node_idx, to, before),
        Event::Closed { from, kind } => closed(from, kind, before),
        Event::Whole {
            list,
            ring_idx,
            side,
            kind,
            ..
        } => whole(list, ring_idx, side, kind, before),
        Event::Hole {
            hole_idx,
            outer_idx,
        } => Caption::new(
            Message::new("wa-hole")
                .with("hole", names::ring(hole_idx as usize))
                .with("ring", names::ring(outer_idx as usize)),
        ),
        Event::Done { relation } => done(relation, before),
    }
}

fn vertex(list: List, vertex_idx: usize, at: Point, input: &Input) -> Caption {
    let key = match list {
        List::Subject => "wa-vertex-subject",
        List::Clip => "wa-vertex-clip",
    };
    let vertex = names::vertex(input, list, vertex_idx);
    let message = Message::new(key)
        .with("vertex", name(vertex.clone()))
        .with("edge", name(names::edge(input, list, vertex_idx)));
    Caption::new(message).so(position(vertex, at))
}

fn start(node_idx: u32, before: &State) -> Caption {
    let node = names::node(node_idx);
    let caption = Caption::new(Message::new("wa-start").with("node", name(node.clone())));
    match before.nodes.get(node_idx as usize) {
        Some(known) => caption.so(position(node, known.at)),
        None => caption,
    }
}

/// Two edges meet: where along each, and where in the plane.
fn found(event: &Event, input: &Input) -> Caption {
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
        return opening(input);
    };
    let (s, c) = (s as usize, c as usize);
    let node = names::node(node_idx);
    let (subject, clip) = (
        names::edge(input, List::Subject, s),
        names::edge(input, List::Clip, c),
    );
    let message = |key| Message::new(key).with("node", name(node.clone()));
    match contact {
        Contact::Crossing => {
            let (ratio, edge_idx) = match list {
                List::Subject => (t, s),
                List::Clip => (u, c),
            };
            let ends = names::border(input, list).edge(edge_idx);
            let message = message("wa-found-crossing")
                .with("subject", name(subject))
                .with("clip", name(clip));
            Caption::new(message)
                .so(quotient("t", t))
                .so(quotient("u", u))
                .so(mean(Axis::X, ends, ratio, at))
                .so(mean(Axis::Y, ends, ratio, at))
        }
        Contact::SubjectVertex => {
            let message = message("wa-found-on-edge")
                .with("vertex", name(names::vertex(input, List::Subject, s)))
                .with("edge", name(clip));
            Caption::new(message)
                .so(position(node, at))
                .so(quotient("u", u))
        }
        Contact::ClipVertex => {
            let message = message("wa-found-on-edge")
                .with("vertex", name(names::vertex(input, List::Clip, c)))
                .with("edge", name(subject));
            Caption::new(message)
                .so(position(node, at))
                .so(quotient("t", t))
        }
        Contact::BothVertices => {
            let message = message("wa-found-both")
                .with("subject", name(names::vertex(input, List::Subject, s)))
                .with("clip", name(names::vertex(input, List::Clip, c)));
            Caption::new(message).so(position(node, at))
        }
    }
}

/// `I₁ = (2, 3)`.
fn position(symbol: String, at: Point) -> Formula {
    Formula::default()
        .sym(symbol)
        .sym(" = ")
        .point(at.to_array())
}

/// `t = 1/3`.
fn quotient(symbol: &'static str, ratio: Ratio) -> Formula {
    Formula::default()
        .sym(symbol)
        .equals_ratio(ratio.num, ratio.den)
}

/// Of the edge's other end.
fn other_distance(Ratio { num, den }: Ratio) -> f64 {
    num - den
}

/// `x = (0 · 2 + 6 · 4) / (4 + 2) = 4`: the mean of an edge's ends, weighted by their distances from the other one; where
/// both are 0 there is nothing to compute.
fn mean(axis: Axis, ends: [Point; 2], ratio: Ratio, at: Point) -> Formula {
    let [o1, o2] = ends.map(|p| along(p, axis)[0]);
    if [o1, o2] == [0.0, 0.0] {
        return Formula::default()
            .sym(axis_symbol(axis))
            .sym(" = ")
            .num(0.0);
    }
    let (w1, w2) = (ratio.num.abs(), other_distance(ratio).abs());
    let part = Formula::default;
    let weighted = |f: Formula, o: f64, w: f64| f.operand(o).sym(" · ").num(w);
    let sum = part().num(o1).sym(" · ").num(w2).sym(" + ");
    part()
        .sym(axis_symbol(axis))
        .sym(" = ")
        .over(weighted(sum, o2, w1), part().num(w1).sym(" + ").num(w2))
        .equals(along(at, axis)[0])
}

fn inserted(node_idx: u32, at_vertex: bool, before: &State, input: &Input) -> Caption {
    let key = if at_vertex {
        "wa-inserted-vertex"
    } else {
        "wa-inserted"
    };
    let message = Message::new(key).with("node", name(names::node(node_idx)));
    let Some(node) = before.nodes.get(node_idx as usize) else {
        return Caption::new(message);
    };
    let edge_idx = node.edges[1] as usize;
    if at_vertex {
        let vertex = names::vertex(input, List::Clip, edge_idx);
        return Caption::new(message.with("vertex", name(vertex)))
            .so(position(names::node(node_idx), node.at));
    }
    let edge = names::edge(input, List::Clip, edge_idx);
    Caption::new(message.with("edge", name(edge))).so(quotient("u", node.u))
}

/// Of a crossing the distances say it: `a₁ = −1 < 0 < 2 = a₂`.
fn labelled(
    node_idx: u32,
    label: IntersectionLabel,
    [before, after]: [Side; 2],
    state: &State,
) -> Caption {
    let key = match label {
        IntersectionLabel::Entering => "wa-entering",
        IntersectionLabel::Leaving => "wa-leaving",
        IntersectionLabel::Touching
            if before == after && matches!(before, Side::Inside | Side::Outside) =>
        {
            "wa-touching-same"
        }
        IntersectionLabel::Touching => "wa-touching",
        IntersectionLabel::Pinching => "wa-pinching",
    };
    let caption = Caption::new(
        Message::new(key)
            .with("node", name(names::node(node_idx)))
            .with("before", names::side(before))
            .with("after", names::side(after)),
    );
    match state.nodes.get(node_idx as usize) {
        Some(node) if node.contact == Contact::Crossing => {
            let order = if label == IntersectionLabel::Entering {
                " < 0 < "
            } else {
                " > 0 > "
            };
            let distances = Formula::default()
                .sym("a₁ = ")
                .num(node.t.num)
                .sym(order)
                .num(other_distance(node.t))
                .sym(" = a₂");
            caption.so(distances)
        }
        Some(node) => caption.so(position(names::node(node_idx), node.at)),
        None => caption,
    }
}

fn visit(
    list: List,
    place: u32,
    at: Point,
    corner: bool,
    before: &State,
    input: &Input,
) -> Caption {
    let entry = before.lists[list.idx()].get(place as usize);
    let entry = entry.map_or_else(String::new, |entry| names::entry(input, list, entry));
    if !corner {
        return Caption::new(Message::new("wa-past").with("entry", name(entry)));
    }
    let key = match list {
        List::Subject => "wa-visit-subject",
        List::Clip => "wa-visit-clip",
    };
    let message = Message::new(key)
        .with("entry", name(entry))
        .with("n", before.path.len() + 1);
    Caption::new(message).so(point_formula("P", at))
}

fn switch(node_idx: u32, to: List, before: &State) -> Caption {
    let label = before
        .labels
        .get(node_idx as usize)
        .map(|label| label.label);
    let key = match (label, to) {
        (Some(IntersectionLabel::Pinching), List::Clip) => "wa-switch-pinch-clip",
        (Some(IntersectionLabel::Pinching), List::Subject) => "wa-switch-pinch-subject",
        (_, List::Clip) => "wa-switch-clip",
        (_, List::Subject) => "wa-switch-subject",
    };
    Caption::new(Message::new(key).with("node", name(names::node(node_idx))))
}

fn closed(from: u32, kind: RingKind, before: &State) -> Caption {
    let key = match kind {
        RingKind::Outer => "wa-closed-outer",
        RingKind::Hole => "wa-closed-hole",
        RingKind::Sliver => "wa-closed-sliver",
    };
    let message = Message::new(key)
        .with("ring", names::ring(before.rings.len()))
        .with("n", before.path.len().saturating_sub(from as usize));
    let back = before.path.get(from as usize);
    back.into_iter()
        .fold(Caption::new(message), |caption, &at| {
            caption.so(point_formula("P", at))
        })
}

fn whole(list: List, ring_idx: u32, side: Side, kind: Option<RingKind>, before: &State) -> Caption {
    let key = match (list, ring_idx, kind.is_some()) {
        (List::Subject, 0, true) => "wa-whole-subject-kept",
        (List::Subject, 0, false) => "wa-whole-subject-dropped",
        (List::Subject, _, true) => "wa-whole-hole-kept",
        (List::Subject, _, false) => "wa-whole-hole-dropped",
        (List::Clip, _, true) => "wa-whole-clip-kept",
        (List::Clip, _, false) => "wa-whole-clip-dropped",
    };
    let message = Message::new(key)
        .with("side", names::side(side))
        .with("ring", names::ring(before.rings.len()))
        .with("hole", Value::Count(ring_idx as usize));
    Caption::new(message)
}

fn done(relation: Relation, before: &State) -> Caption {
    let key = match relation {
        Relation::Disjoint => "wa-done-disjoint",
        Relation::Touching => "wa-done-touching",
        Relation::SubjectInside => "wa-done-subject",
        Relation::ClipInside => "wa-done-clip",
        Relation::Equal => "wa-done-equal",
        Relation::Crossing => "wa-done-crossing",
    };
    let is_outer = |kind| kind == RingKind::Outer;
    let n_pieces = before
        .rings
        .iter()
        .filter(|ring| is_outer(ring.kind))
        .count();
    Caption::new(Message::new(key).with("n", n_pieces))
}
