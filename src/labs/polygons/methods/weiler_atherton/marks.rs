//! What Weiler–Atherton draws: intersections by what they are, the walk, and the pieces so far.

use std::cmp::Ordering;

use crate::geom::orientation;

use super::super::lists::{middle, outline};

use super::{
    names,
    prelude::*,
    standing::{self, BOTH, Standing, Walked},
};

const FEW_ENOUGH: usize = 60;
const MOST_MARKS: usize = 600;

pub fn marks(step: &Step<'_, WeilerAtherton>) -> Vec<Mark> {
    let held = step.held;
    let lens = BOTH.map(|list| standing::len(step, list));
    let few = lens.iter().sum::<usize>() <= FEW_ENOUGH;
    let mut marks: Vec<Mark> = pieces(held).into_iter().collect();
    if few && standing::is_done(step.event()) {
        marks.extend(ring_names(held));
    }
    if few && !standing::is_done(step.event()) {
        marks.extend(headings(step));
    }
    marks.extend(walk(step, few));
    marks.extend(event_marks(step));
    if few {
        let standing = Standing::of(step, lens.map(|len| 0..len));
        marks.extend(vertices(step, &standing));
        marks.extend(nodes(step, &standing));
    } else {
        marks.extend(nodes_among_many(step));
    }
    marks
}

fn pieces(held: &Held) -> Option<Mark> {
    let rings = held
        .rings
        .iter()
        .filter(|ring| ring.kind != RingKind::Sliver);
    let outlines: Vec<Vec<[f64; 2]>> = rings.map(|ring| outline(&ring.points)).collect();
    (!outlines.is_empty()).then(|| Mark::new(Role::Accepted, Shape::Area(outlines)))
}

/// What the pieces are called, and not their holes.
fn ring_names(held: &Held) -> impl Iterator<Item = Mark> {
    let rings = held.rings.iter().enumerate();
    let outer = rings.filter(|(_, ring)| ring.kind == RingKind::Outer);
    outer.map(|(i, ring)| {
        let mark = Mark::new(Role::Accepted, Shape::Label(middle(&ring.points)));
        mark.labelled(name(numbered('R', i)))
    })
}

/// Which way the edges run, but for those that a walk is on: it has heads of its own. Where the subject runs along an
/// edge of the clip polygon, the same way, one head is for both.
fn headings(step: &Step<'_, WeilerAtherton>) -> Vec<Mark> {
    let held = step.held;
    let edge_of = |list: List, place: u32| {
        let entry = held.lists.entries[list.idx()].get(place as usize)?;
        match (entry.vertex(), entry.node()) {
            (Some(vertex), _) => Some(vertex as usize),
            (None, Some(node)) => {
                Some(held.lists.nodes.get(node as usize)?.edges[list.idx()] as usize)
            }
            (None, None) => None,
        }
    };
    let all_passed = Walked::so_far(step.past).passed;
    let of = |list: List| {
        let passed = all_passed.iter().filter(|passed| passed.list == list);
        let walked: Vec<usize> = passed.filter_map(|at| edge_of(list, at.place)).collect();
        let role = match (step.event(), list) {
            (Some(Event::Whole { list: whole, .. }), list) if whole == list => Role::Signal,
            (_, List::Subject) => Role::Soft,
            (_, List::Clip) => Role::Ink,
        };
        let border = names::border(step.input, list);
        let is_along = |edge_idx: usize| {
            let clip = names::border(step.input, List::Clip);
            let mut others = (0..clip.points().len()).map(|other| clip.edge(other));
            list == List::Subject && others.any(|other| runs_along(border.edge(edge_idx), other))
        };
        let edges = (0..border.points().len())
            .filter(|edge_idx| !walked.contains(edge_idx) && !is_along(*edge_idx));
        let heading = |edge_idx| Shape::Heading(border.edge(edge_idx).map(Point::to_array));
        let marks = edges.map(|edge_idx| Mark::new(role, heading(edge_idx)));
        marks.collect::<Vec<_>>()
    };
    BOTH.into_iter().flat_map(of).collect()
}

/// Does an edge lie on the line of another one, go the same way, and have its middle on it?
fn runs_along([from, to]: [Point; 2], other: [Point; 2]) -> bool {
    let is_on_line = |at: Point| orientation(other[0], other[1], at) == Ordering::Equal;
    let [start, end] = other.map(Point::to_array);
    let along = |[x, y]: [f64; 2]| {
        (x - start[0]) * (end[0] - start[0]) + (y - start[1]) * (end[1] - start[1])
    };
    let [before, after] = [from, to].map(|at| along(at.to_array()));
    let middle = 0.5 * (before + after);
    is_on_line(from) && is_on_line(to) && before < after && (0.0..=along(end)).contains(&middle)
}

fn walk(step: &Step<'_, WeilerAtherton>, few: bool) -> Vec<Mark> {
    let held = step.held;
    let mut path: Vec<[f64; 2]> = held.walk.path.iter().map(|(p, _)| p.to_array()).collect();
    if let Some(Event::Switch { node_idx, .. }) = step.event() {
        let node = held.lists.nodes.get(node_idx as usize);
        path.extend(node.map(|node| node.meeting.at.to_array()));
    }
    if path.len() < 2 {
        return Vec::new();
    }
    let is_new = matches!(step.event(), Some(Event::Visit { corner: true, .. }));
    let n_old = path.len() - 1 - usize::from(is_new);
    let mut marks = Vec::new();
    if n_old > 0 {
        marks.push(Mark::new(
            Role::Accent,
            Shape::Path(path[..=n_old].to_vec()),
        ));
    }
    for (edge_idx, ends) in path.windows(2).enumerate() {
        let ends = [ends[0], ends[1]];
        let role = if edge_idx < n_old {
            Role::Accent
        } else {
            marks.push(Mark::new(Role::Signal, Shape::Segment(ends)));
            Role::Signal
        };
        if few {
            marks.push(Mark::new(role, Shape::Heading(ends)));
        }
    }
    marks
}

/// The polygons' own vertices, by name, but for those that are an intersection.
fn vertices(step: &Step<'_, WeilerAtherton>, standing: &Standing) -> Vec<Mark> {
    let held = step.held;
    let of = |list: List| {
        let own = move |place: usize| {
            let entry = held.lists.entries[list.idx()].get(place);
            if entry.is_some_and(|entry| entry.node().is_some()) {
                return None;
            }
            let vertex_idx = standing::vertex_at(step, list, place)?;
            let role = match standing.role(list, place)? {
                // What is still to come is there in the plane, as it was given.
                Role::Faint => Role::Soft,
                role => role,
            };
            let at = names::border(step.input, list).points()[vertex_idx].to_array();
            let link = names::vertex_link(list, vertex_idx);
            let mark = Mark::new(role, Shape::Vertex(at)).linked(link);
            let label = name(names::vertex(step.input, list, vertex_idx));
            // Of the answer's names none is to be crowded out by what has been dropped.
            Some(if role == Role::Discarded {
                mark
            } else {
                mark.labelled(label)
            })
        };
        (0..standing::len(step, list)).filter_map(own)
    };
    BOTH.into_iter().flat_map(of).collect()
}

/// Every intersection, by name, in the role that it has in the subject's list or in the other one.
fn nodes(step: &Step<'_, WeilerAtherton>, standing: &Standing) -> Vec<Mark> {
    let held = step.held;
    let mark = |(node_idx, node): (usize, &Intersection)| {
        let node_idx = node_idx as u32;
        let in_list = |list| {
            let place = standing::place_of(held, list, node_idx)?;
            standing.role(list, place)
        };
        let roles = BOTH.map(in_list);
        let role = [Role::Signal, Role::Accent, Role::Accepted, Role::Discarded]
            .into_iter()
            .find(|&role| roles.contains(&Some(role)))
            .unwrap_or(Role::Ink);
        let link = names::node_link(node_idx);
        let shapes = node_shapes(held, node_idx, node).into_iter();
        let marks = shapes.map(|it| Mark::new(role, it).linked(link));
        let mut marks: Vec<Mark> = marks.collect();
        let label = name(names::meeting(step.input, node_idx, node));
        marks[0] = marks[0].clone().labelled(label).strong();
        marks
    };
    held.lists.nodes.iter().enumerate().flat_map(mark).collect()
}

fn nodes_among_many(step: &Step<'_, WeilerAtherton>) -> Vec<Mark> {
    let held = step.held;
    let mut marks = Vec::new();
    if held.lists.nodes.len() <= MOST_MARKS && !standing::is_done(step.event()) {
        for (node_idx, node) in held.lists.nodes.iter().enumerate() {
            let shapes = node_shapes(held, node_idx as u32, node).into_iter();
            let link = names::node_link(node_idx as u32);
            marks.extend(shapes.map(|shape| Mark::new(Role::Ink, shape).linked(link)));
        }
    }
    for (list, place) in standing::current(step) {
        if let Some(entry) = held.lists.entries[list.idx()].get(place) {
            let node = entry
                .node()
                .and_then(|idx| Some((idx, held.lists.nodes.get(idx as usize)?)));
            let shapes = match node {
                Some((node_idx, node)) => node_shapes(held, node_idx, node),
                None => {
                    let at = held.lists.at(entry, names::border(step.input, list));
                    vec![Shape::Dot(at.to_array())]
                }
            };
            let shapes = shapes.into_iter();
            marks.extend(shapes.map(|shape| Mark::new(Role::Signal, shape)));
        }
    }
    marks
}

fn node_shapes(held: &Held, node_idx: u32, node: &Intersection) -> Vec<Shape> {
    let at = node.meeting.at.to_array();
    match standing::marker(standing::label(held, node_idx)) {
        ItemMarker::Cross => vec![Shape::Cross(at)],
        // No intersection is one by half.
        ItemMarker::Dot | ItemMarker::HalfDot => vec![Shape::Dot(at)],
        ItemMarker::Ring => vec![Shape::Ring(at)],
        ItemMarker::CrossedRing => vec![Shape::Ring(at), Shape::Cross(at)],
    }
}

fn event_marks(step: &Step<'_, WeilerAtherton>) -> Vec<Mark> {
    let (held, input) = (step.held, step.input);
    let signal = |shape| Mark::new(Role::Signal, shape);
    let edge = |list: List, edge_idx: u32| {
        let border = names::border(input, list);
        directed(border.edge(edge_idx as usize))
    };
    let ring = |ring_idx: usize| held.rings.get(ring_idx).map(|ring| outline(&ring.points));
    match step.event() {
        Some(Event::Vertex {
            list, vertex_idx, ..
        }) => edge(list, vertex_idx),
        Some(Event::Found { edges: [s, c], .. }) => {
            let both = [edge(List::Subject, s), edge(List::Clip, c)];
            both.concat()
        }
        Some(Event::Inserted { node_idx, .. }) => {
            let node = held.lists.nodes.get(node_idx as usize);
            node.map_or_else(Vec::new, |node| edge(List::Clip, node.edges[1]))
        }
        Some(Event::Labelled { node_idx, .. }) => {
            let node = held.lists.nodes.get(node_idx as usize);
            node.map_or_else(Vec::new, |node| through(step, node))
        }
        Some(Event::Start { node_idx }) => {
            let place = standing::place_of(held, List::Subject, node_idx);
            place.map_or_else(Vec::new, |place| onwards(step, List::Subject, place))
        }
        Some(Event::Switch { to, place, .. }) => onwards(step, to, place as usize),
        Some(Event::Closed { .. } | Event::Whole { kind: Some(_), .. }) => {
            let last = held.rings.last();
            let last = last.map(|ring| signal(Shape::Outline(outline(&ring.points))));
            last.into_iter().collect()
        }
        Some(Event::Whole {
            list,
            ring_idx,
            kind: None,
            ..
        }) => {
            let ring = names::border(input, list).ring(ring_idx as usize);
            vec![Mark::new(Role::Discarded, Shape::Outline(outline(ring)))]
        }
        Some(Event::Hole {
            hole_idx,
            outer_idx,
        }) => {
            let both = [hole_idx, outer_idx].map(|idx| ring(idx as usize));
            let both = both.into_iter().flatten();
            both.map(|outline| signal(Shape::Outline(outline)))
                .collect()
        }
        Some(Event::Visit { .. } | Event::Done { .. }) | None => Vec::new(),
    }
}

fn directed(ends: [Point; 2]) -> Vec<Mark> {
    let ends = ends.map(Point::to_array);
    [Shape::Segment(ends), Shape::Heading(ends)]
        .map(|shape| Mark::new(Role::Signal, shape))
        .to_vec()
}

fn onwards(step: &Step<'_, WeilerAtherton>, list: List, place: usize) -> Vec<Mark> {
    let lists = &step.held.lists;
    let next = standing::next_place(step.held, list, place);
    let border = names::border(step.input, list);
    directed([place, next].map(|place| lists.at(&lists.entries[list.idx()][place], border)))
}

fn through(step: &Step<'_, WeilerAtherton>, node: &Intersection) -> Vec<Mark> {
    let border = names::border(step.input, List::Subject);
    let edge_idx = node.edges[0] as usize;
    let [from, to] = border.edge(edge_idx);
    let from = if node.meeting.contact.at_vertex()[0] {
        border.points()[border.previous(edge_idx)]
    } else {
        from
    };
    [
        directed([from, node.meeting.at]),
        directed([node.meeting.at, to]),
    ]
    .concat()
}
