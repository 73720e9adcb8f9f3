//! What Weiler–Atherton draws: intersections by what they are, the walk, and the pieces so far.

use crate::{
    algo::polygon::weiler_atherton::{
        Label, List, ListNode, RingKind, StateRing, WeilerAtherton, WeilerAthertonEvent as Event,
        WeilerAthertonState as State,
    },
    figure::{Mark, Role, Shape},
    geom::Point,
    labs::{Step, words::name},
    text::Value,
    trace::Log,
};

use super::names;

/// Up to this number of entries in both lists each has its mark and its name.
const FEW_ENOUGH: usize = 60;
/// Up to this number of intersections each has its mark.
const MOST_MARKS: usize = 600;

pub fn marks(step: &Step<'_, WeilerAtherton>) -> Vec<Mark> {
    let state = step.state;
    let mut marks: Vec<Mark> = pieces(state).into_iter().collect();
    if !state.path.is_empty() {
        let path = state.path.iter().map(|p| p.to_array()).collect();
        marks.push(Mark::new(Role::Accent, Shape::Path(path)));
    }
    let few = state.lists.iter().map(Log::len).sum::<usize>() <= FEW_ENOUGH;
    if few && state.relation.is_none() {
        marks.extend(vertices(step));
    }
    marks.extend(event_marks(step));
    if state.nodes.len() <= MOST_MARKS && state.relation.is_none() {
        let nodes = state.nodes.iter().enumerate();
        marks.extend(nodes.flat_map(|(idx, node)| node_marks(state, idx as u32, node, few)));
    }
    if let Some((list, place)) = state.position
        && let Some(entry) = state.lists[list.idx()].get(place as usize)
    {
        // Hollow where it leaves, as the intersection itself is drawn.
        let label = entry.node.and_then(|node| state.labels.get(node as usize));
        let at = entry.at.to_array();
        let shape = match label {
            Some(label) if label.label == Label::Leaving => Shape::Ring(at),
            _ => Shape::Dot(at),
        };
        marks.push(Mark::new(Role::Signal, shape));
    }
    marks
}

/// All closed rings, filled where an odd number of them goes round.
fn pieces(state: &State) -> Option<Mark> {
    let rings = state
        .rings
        .iter()
        .filter(|ring| ring.kind != RingKind::Sliver);
    let outlines: Vec<Vec<[f64; 2]>> = rings.map(|ring| outline(ring)).collect();
    (!outlines.is_empty()).then(|| Mark::new(Role::Accepted, Shape::Area(outlines)))
}

fn outline(ring: &StateRing) -> Vec<[f64; 2]> {
    ring.points.iter().map(|p| p.to_array()).collect()
}

/// The polygons' own vertices, by name, as far as they are in their lists.
fn vertices(step: &Step<'_, WeilerAtherton>) -> Vec<Mark> {
    let of = |list: List| {
        let entries = step.state.lists[list.idx()].iter();
        entries.filter_map(move |entry| {
            let vertex_idx = entry.vertex? as usize;
            let label = name(names::vertex(step.input, list, vertex_idx));
            let role = match list {
                List::Subject => Role::Ink,
                List::Clip => Role::Soft,
            };
            // Where it is an intersection, that one's shape is drawn.
            let shape = Shape::Dot(entry.at.to_array());
            Some(Mark::new(role, shape).labelled(label))
        })
    };
    [List::Subject, List::Clip]
        .into_iter()
        .flat_map(of)
        .collect()
}

/// A dot where the subject enters, a ring where it leaves, a cross where it does neither, and a ring with a cross
/// where both borders pinch.
fn node_marks(state: &State, idx: u32, node: &ListNode, named: bool) -> Vec<Mark> {
    let at = node.at.to_array();
    let label = state.labels.get(idx as usize).map(|label| label.label);
    let shapes = match label {
        None | Some(Label::Touching) => vec![Shape::Cross(at)],
        Some(Label::Entering) => vec![Shape::Dot(at)],
        Some(Label::Leaving) => vec![Shape::Ring(at)],
        Some(Label::Pinching) => vec![Shape::Cross(at), Shape::Ring(at)],
    };
    let text = Value::Formula(names::labelled_node(state, idx));
    shapes
        .into_iter()
        .enumerate()
        .map(|(k, shape)| {
            let mark = Mark::new(Role::Accent, shape).linked(names::node_link(idx));
            if named && k == 0 {
                mark.labelled(text.clone())
            } else {
                mark
            }
        })
        .collect()
}

/// What this step is about.
fn event_marks(step: &Step<'_, WeilerAtherton>) -> Vec<Mark> {
    let (state, input) = (step.state, step.input);
    let signal = |shape| Mark::new(Role::Signal, shape);
    let segment = |list: List, edge_idx: usize| {
        Shape::Segment(
            names::border(input, list)
                .edge(edge_idx)
                .map(Point::to_array),
        )
    };
    let ring = |ring_idx: usize| state.rings.get(ring_idx).map(|ring| outline(ring));
    match step.event {
        Some(Event::Vertex {
            list, vertex_idx, ..
        }) => vec![signal(segment(list, vertex_idx as usize))],
        Some(Event::Found {
            edges: [s, c], at, ..
        }) => vec![
            signal(segment(List::Subject, s as usize)),
            signal(segment(List::Clip, c as usize)),
            signal(Shape::Dot(at.to_array())),
        ],
        Some(Event::Inserted { node_idx, at, .. }) => {
            let node = state.nodes.get(node_idx as usize);
            let edge = node.map(|node| signal(segment(List::Clip, node.edges[1] as usize)));
            edge.into_iter()
                .chain([signal(Shape::Ring(at.to_array()))])
                .collect()
        }
        Some(Event::Labelled { node_idx, .. }) => {
            let node = state.nodes.get(node_idx as usize);
            node.map_or_else(Vec::new, |node| arrows(step, node))
        }
        Some(Event::Start { node_idx } | Event::Switch { node_idx, .. }) => {
            let node = state.nodes.get(node_idx as usize);
            node.map(|node| signal(Shape::Ring(node.at.to_array())))
                .into_iter()
                .collect()
        }
        Some(Event::Closed { .. } | Event::Whole { kind: Some(_), .. }) => {
            let last = state
                .rings
                .last()
                .map(|ring| signal(Shape::Outline(outline(ring))));
            last.into_iter().collect()
        }
        Some(Event::Whole {
            list,
            ring_idx,
            kind: None,
            ..
        }) => {
            let ring = names::border(input, list).ring(ring_idx as usize);
            let outline = ring.iter().map(|p| p.to_array()).collect();
            vec![Mark::new(Role::Discarded, Shape::Outline(outline))]
        }
        Some(Event::Hole {
            hole_idx,
            outer_idx,
        }) => {
            let both = [hole_idx, outer_idx].map(|idx| ring(idx as usize));
            both.into_iter()
                .flatten()
                .map(|outline| signal(Shape::Outline(outline)))
                .collect()
        }
        Some(Event::Visit { .. } | Event::Done { .. }) | None => Vec::new(),
    }
}

/// The subject's edge that comes to an intersection, and the one that goes on from it.
fn arrows(step: &Step<'_, WeilerAtherton>, node: &ListNode) -> Vec<Mark> {
    let border = names::border(step.input, List::Subject);
    let edge_idx = node.edges[0] as usize;
    let [from, to] = border.edge(edge_idx);
    let from = if node.contact.at_vertex()[0] {
        border.points()[border.previous(edge_idx)]
    } else {
        from
    };
    let [from, at, to] = [from, node.at, to].map(Point::to_array);
    [[from, at], [at, to]]
        .map(|ends| Mark::new(Role::Signal, Shape::Arrow(ends)))
        .to_vec()
}
