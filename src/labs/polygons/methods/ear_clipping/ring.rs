//! What ear clipping holds: the ring of what is left, the vertices that may lie in an ear, and the triangles.

use crate::{
    algo::polygon::{
        Corner, EarClipping, EarClippingEvent as Event, EarClippingState as State, Triangle,
    },
    figure::{List, ListEntry, ListLink, Lists, Marker, Role},
    labs::{
        Step,
        polygons::methods::triangles::{triangle_link, triangle_name},
        words::{name, vertex_name},
    },
    text::Value,
};

use super::{captions::corner_name, vertex_link};

/// The view's name.
pub const VIEW: &str = "ring";

/// Up to this number of vertices, one that is cut off keeps its place in the ring.
const FEW_ENOUGH: usize = 12;

pub fn lists(step: &Step<'_, EarClipping>) -> Lists {
    let rivals = rivals(step);
    let (ring, tip) = ring(step);
    let links = match (step.event, tip, rivals.focus) {
        (Some(Event::Blocked { .. }), Some(tip), Some(rival)) => vec![ListLink {
            from: [1, rival],
            to: [0, tip],
            role: Role::Signal,
        }],
        _ => Vec::new(),
    };
    Lists {
        lists: vec![ring, rivals, triangles(step)],
        links,
    }
}

/// The corner that this step is about, its tip in the middle.
fn corner(step: &Step<'_, EarClipping>) -> Option<Triangle> {
    match step.event? {
        Event::Classify {
            vertex_idx,
            prev_idx,
            next_idx,
            ..
        } => Some([prev_idx, vertex_idx, next_idx]),
        Event::Candidate { triangle } | Event::Cut { triangle, .. } | Event::Last { triangle } => {
            Some(triangle)
        }
        Event::Blocked { vertex_idx, .. }
        | Event::Ear { vertex_idx }
        | Event::Pass { vertex_idx, .. } => Some(step.state.ring.corner(vertex_idx)),
        Event::Round { .. } | Event::Done { .. } => None,
    }
}

/// The vertices that are left, and the place of this step's one. Of few, those that are cut off stand where they were.
fn ring(step: &Step<'_, EarClipping>) -> (List, Option<usize>) {
    let state = step.state;
    let corner = corner(step);
    let n = step.input.vertices().len();
    let (vertices, tip, n_before) = if n <= FEW_ENOUGH {
        let given = (0..n).map(|i| step.input.given_vertex(i));
        let vertices: Vec<usize> = given.collect();
        let tip = corner.and_then(|[_, tip, _]| vertices.iter().position(|&i| i == tip));
        (vertices, tip, 0)
    } else {
        let stand = corner.map(|[_, tip, _]| tip).or(state.stand);
        let place = stand.and_then(|stand| state.ring.iter().position(|i| i == stand));
        let reach = List::reach(state.ring.len(), place);
        let shown = state.ring.iter().skip(reach.start).take(reach.len());
        let tip = place.map(|place| place - reach.start);
        (shown.collect(), tip, reach.start)
    };
    let n_shown = vertices.len();
    let entry = |i: usize| {
        let is_left = !state.is_done && state.ring.contains(i);
        let role = match corner {
            Some([_, tip, _]) if tip == i => Role::Signal,
            Some(corner) if corner.contains(&i) => Role::Accent,
            _ if !is_left => Role::Discarded,
            _ => Role::Soft,
        };
        ListEntry {
            details: vec![state.corners[i].map(corner_name)],
            marker: marker(state, i),
            role,
            link: Some(vertex_link(i)),
            ..ListEntry::new(vertex_name(i))
        }
    };
    let list = List {
        columns: vec![name("")],
        n_before,
        n_after: state.ring.len().saturating_sub(n_before + n_shown),
        is_ring: true,
        focus: tip,
        ..List::new(
            Value::Term("ear-list-ring"),
            vertices.into_iter().map(entry).collect(),
        )
    };
    (list, tip)
}

/// As in the drawing: a dot for a convex vertex, a ring for any other.
fn marker(state: &State, vertex_idx: usize) -> Option<Marker> {
    state.corners[vertex_idx].map(|corner| match corner {
        Corner::Convex => Marker::Dot,
        Corner::Straight | Corner::Reflex => Marker::Ring,
    })
}

/// The vertices that are left and not convex, by x: those alone may lie in an ear. What is known of them once the
/// candidate has been decided; its own corners are none.
fn rivals(step: &Step<'_, EarClipping>) -> List {
    let state = step.state;
    let is_candidate = matches!(step.event, Some(Event::Candidate { .. }));
    let is_ear = matches!(step.event, Some(Event::Ear { .. }));
    let is_blocked = matches!(step.event, Some(Event::Blocked { .. }));
    let is_asked = is_candidate || is_ear || is_blocked;
    let candidate = state.candidate.filter(|_| is_asked);
    let blocks = state.blocked_by.filter(|_| is_blocked);
    let is_rival = |&i: &usize| {
        let is_not_convex = state.corners[i].is_some_and(|corner| corner != Corner::Convex);
        is_not_convex && !state.is_done
    };
    let mut vertices: Vec<usize> = state.ring.iter().filter(is_rival).collect();
    let x = |i: usize| state.cut_off.at(i).x();
    vertices.sort_by(|&i, &j| x(i).total_cmp(&x(j)));
    let place = blocks.and_then(|by_idx| vertices.iter().position(|&i| i == by_idx));
    let reach = List::reach(vertices.len(), place);
    let entry = |&i: &usize| {
        let is_own = candidate.is_some_and(|candidate| candidate.contains(&i));
        let (role, fate) = if is_own {
            (Role::Discarded, None)
        } else if blocks == Some(i) {
            (Role::Signal, Some("ear-inside"))
        } else if is_ear {
            (Role::Soft, Some("ear-outside"))
        } else if is_candidate {
            (Role::Ink, None)
        } else {
            (Role::Soft, None)
        };
        ListEntry {
            details: vec![fate.map(Value::Term)],
            marker: Some(Marker::Ring),
            role,
            link: Some(vertex_link(i)),
            ..ListEntry::new(vertex_name(i))
        }
    };
    List {
        columns: vec![candidate.map_or_else(|| name(""), triangle_name)],
        n_before: reach.start,
        n_after: vertices.len() - reach.end,
        focus: place.map(|place| place - reach.start),
        ..List::new(
            Value::Term("ear-list-rivals"),
            vertices[reach].iter().map(entry).collect(),
        )
    }
}

/// The triangles that have been cut off, and a place for each that is still to come.
fn triangles(step: &Step<'_, EarClipping>) -> List {
    let cut_off = step.state.cut_off.triangles();
    let n = step.input.vertices().len() - 2;
    let last = cut_off.len().checked_sub(1);
    let is_new = matches!(step.event, Some(Event::Cut { .. } | Event::Last { .. }));
    let reach = List::reach(n, last);
    let entry = |triangle_idx: usize| match cut_off.get(triangle_idx) {
        Some(&triangle) => ListEntry {
            role: if is_new && last == Some(triangle_idx) {
                Role::Signal
            } else {
                Role::Accepted
            },
            link: Some(triangle_link(triangle_idx)),
            ..ListEntry::new(triangle_name(triangle))
        },
        None => ListEntry {
            role: Role::Faint,
            ..ListEntry::new(name("·"))
        },
    };
    List {
        n_before: reach.start,
        n_after: n - reach.end,
        focus: last.map(|last| last - reach.start),
        ..List::new(
            Value::Term("ear-list-triangles"),
            reach.map(entry).collect(),
        )
    }
}
