//! What ear clipping holds: the ring of what is left, and the triangles that are cut off it.

use crate::{
    algo::polygon::{
        Corner, EarClipping, EarClippingEvent as Event, EarClippingHeld as Held, Triangle,
    },
    figure::{ItemMarker, ListColumn, ListLink, ListRow, Lists, Role},
    labs::{
        polygons::methods::triangles::{triangle_link, triangle_name},
        words::{name, vertex_name},
    },
    text::Value,
    trace::Step,
};

use super::{asked, corner, corner_name, cuts, is_done, vertex_link};

/// The view's name.
pub const VIEW: &str = "ring";

/// Up to this number of vertices, one that is cut off keeps its place in the ring.
const FEW_ENOUGH: usize = 12;

pub fn lists(step: &Step<'_, EarClipping>) -> Lists {
    let (ring, tip) = ring(step);
    let triangles = triangles(step);
    let links = match (cuts(step.event()), tip, triangles.focus) {
        (true, Some(tip), Some(triangle)) => vec![ListLink {
            from: [0, tip],
            to: [1, triangle],
            role: Role::Signal,
        }],
        (true | false, ..) => Vec::new(),
    };
    Lists {
        lists: vec![ring, triangles],
        links,
        // Each entry says it itself.
        legend: Vec::new(),
    }
}

/// The vertices that are left, and the place of this step's one. Of few, those that are cut off stand where they were.
fn ring(step: &Step<'_, EarClipping>) -> (ListColumn, Option<usize>) {
    let held = step.held;
    let corner = corner(step);
    let n = step.input.vertices().len();
    let (vertices, n_before, focus) = if n <= FEW_ENOUGH {
        let given = (0..n).map(|i| step.input.given_vertex(i));
        (given.collect(), 0, None)
    } else {
        about(step, corner)
    };
    let n_shown = vertices.len();
    let tip = corner.and_then(|[_, tip, _]| vertices.iter().position(|&i| i == tip));
    let entry = |i: usize| {
        let fate = fate(step, i);
        ListRow {
            details: vec![fate.or(held.corners[i].map(corner_name))],
            marker: marker(held, i),
            role: role(step, corner, i),
            link: Some(vertex_link(i)),
            ..ListRow::new(vertex_name(i))
        }
    };
    let list = ListColumn {
        columns: vec![name("")],
        n_before,
        n_after: held.ring.len().saturating_sub(n_before + n_shown),
        is_ring: true,
        focus: tip.or(focus),
        ..ListColumn::new(
            Value::Term("ear-list-ring"),
            vertices.into_iter().map(entry).collect(),
        )
    };
    (list, tip)
}

/// Of a long ring the vertices about this step's one, how many come before them, and its place among them. Where it
/// has just been cut off, about the one before it.
fn about(
    step: &Step<'_, EarClipping>,
    corner: Option<Triangle>,
) -> (Vec<usize>, usize, Option<usize>) {
    let held = step.held;
    let tip = corner.map(
        |[prev, tip, _]| {
            if held.ring.contains(tip) { tip } else { prev }
        },
    );
    let place = tip
        .or(asked(step))
        .and_then(|asked| held.ring.iter().position(|i| i == asked));
    let reach = ListColumn::reach(held.ring.len(), place);
    let shown = held.ring.iter().skip(reach.start).take(reach.len());
    (
        shown.collect(),
        reach.start,
        place.map(|place| place - reach.start),
    )
}

/// What a vertex is at this step: its corner's tip, beside it, in its triangle, or about to be asked whether it is.
fn role(step: &Step<'_, EarClipping>, corner: Option<Triangle>, vertex_idx: usize) -> Role {
    let held = step.held;
    let is_left = !is_done(step.event()) && held.ring.contains(vertex_idx);
    let [is_tip, is_beside] = corner.map_or([false; 2], |corner| {
        [corner[1] == vertex_idx, corner.contains(&vertex_idx)]
    });
    let blocks =
        matches!(step.event(), Some(Event::Blocked { by_idx, .. }) if by_idx == vertex_idx);
    if is_tip || blocks {
        Role::Signal
    } else if is_beside {
        Role::Accent
    } else if !is_left {
        Role::Discarded
    } else if is_rival(step, vertex_idx) {
        Role::Ink
    } else {
        Role::Soft
    }
}

/// May this vertex lie in the triangle that is asked about? Only one that is left and not convex, and no corner of it.
fn is_rival(step: &Step<'_, EarClipping>, vertex_idx: usize) -> bool {
    let held = step.held;
    let is_asked = match step.event() {
        Some(Event::Candidate { .. } | Event::Blocked { .. } | Event::Ear { .. }) => true,
        Some(
            Event::Classify { .. }
            | Event::Round { .. }
            | Event::Pass { .. }
            | Event::Cut { .. }
            | Event::Last { .. }
            | Event::Done { .. },
        )
        | None => false,
    };
    let is_own = corner(step).is_some_and(|corner| corner.contains(&vertex_idx));
    let is_convex = held.corners[vertex_idx].is_none_or(|corner| corner == Corner::Convex);
    is_asked && !is_own && !is_convex && held.ring.contains(vertex_idx)
}

/// Where a rival lies, once that is known.
fn fate(step: &Step<'_, EarClipping>, vertex_idx: usize) -> Option<Value> {
    let is_in = match step.event()? {
        Event::Blocked { by_idx, .. } if by_idx == vertex_idx => true,
        Event::Ear { .. } if is_rival(step, vertex_idx) => false,
        Event::Classify { .. }
        | Event::Round { .. }
        | Event::Pass { .. }
        | Event::Candidate { .. }
        | Event::Blocked { .. }
        | Event::Ear { .. }
        | Event::Cut { .. }
        | Event::Last { .. }
        | Event::Done { .. } => return None,
    };
    Some(Value::Term(if is_in {
        "ear-inside"
    } else {
        "ear-outside"
    }))
}

/// As in the drawing: a dot for a convex vertex, a ring for any other.
fn marker(held: &Held, vertex_idx: usize) -> Option<ItemMarker> {
    held.corners[vertex_idx].map(|corner| match corner {
        Corner::Convex => ItemMarker::Dot,
        Corner::Straight | Corner::Reflex => ItemMarker::Ring,
    })
}

/// The triangles that have been cut off, and a place for each that is still to come.
fn triangles(step: &Step<'_, EarClipping>) -> ListColumn {
    let cut_off = step.held.cut_off.triangles();
    let n = step.input.vertices().len() - 2;
    let last = cut_off.len().checked_sub(1);
    let reach = ListColumn::reach(n, last);
    let entry = |triangle_idx: usize| match cut_off.get(triangle_idx) {
        Some(&triangle) => ListRow {
            role: if cuts(step.event()) && last == Some(triangle_idx) {
                Role::Signal
            } else {
                Role::Accepted
            },
            link: Some(triangle_link(triangle_idx)),
            ..ListRow::new(triangle_name(triangle))
        },
        None => ListRow {
            role: Role::Faint,
            ..ListRow::new(name("·"))
        },
    };
    ListColumn {
        n_before: reach.start,
        n_after: n - reach.end,
        focus: last.map(|last| last - reach.start),
        ..ListColumn::new(
            Value::Term("ear-list-triangles"),
            reach.map(entry).collect(),
        )
    }
}
