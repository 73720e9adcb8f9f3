//! What ear clipping holds: the ring of what is left, and the triangles that are cut off it.

use crate::algo::polygon::{Corner, EarClipping, EarClippingEvent as Event, Triangle};

use super::{
    super::{
        prelude::*,
        triangles::{triangle_link, triangle_name},
    },
    asked, corner, corner_name, cuts, is_done, vertex_link,
};

pub const VIEW: &str = "ring";

/// Up to this number of vertices, one that is cut off keeps its place in the ring.
const FEW_ENOUGH: usize = 12;

pub fn lists(step: &Step<'_, EarClipping>) -> Lists {
    let (ring, tip) = ring(step);
    let triangles = triangles(step);
    let cut = tip.zip(triangles.focus).filter(|_| cuts(step.event()));
    let link = cut.map(|(tip, triangle)| ListLink::between(tip, triangle, Role::Signal));
    Lists {
        lists: vec![ring, triangles],
        links: link.into_iter().collect(),
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
    let entry = |i: usize| ListRow {
        details: vec![fate(step, i).or(held.corners[i].map(corner_name))],
        // As in the drawing.
        marker: held.corners[i].map(|it| ItemMarker::dot_or_ring(it == Corner::Convex)),
        role: role(step, corner, i),
        link: Some(vertex_link(i)),
        ..ListRow::new(vertex_name(i))
    };
    let entries = vertices.into_iter().map(entry).collect();
    let list = ListColumn {
        columns: vec![name("")],
        n_before,
        n_after: held.ring.len().saturating_sub(n_before + n_shown),
        is_ring: true,
        focus: tip.or(focus),
        ..ListColumn::new(Value::Term("ear-list-ring"), entries)
    };
    (list, tip)
}

/// Of a long ring the vertices about this step's one, how many come before them, and its place among them. Where it
/// has just been cut off, about the one before it.
fn about(
    step: &Step<'_, EarClipping>,
    corner: Option<Triangle>,
) -> (Vec<usize>, usize, Option<usize>) {
    let ring = &step.held.ring;
    let tip = corner.map(|[prev, tip, _]| if ring.contains(tip) { tip } else { prev });
    let asked = tip.or(asked(step));
    let place = asked.and_then(|asked| ring.iter().position(|i| i == asked));
    let reach = ListColumn::reach(ring.len(), place);
    let shown = ring.iter().skip(reach.start).take(reach.len());
    let focus = place.map(|place| place - reach.start);
    (shown.collect(), reach.start, focus)
}

fn role(step: &Step<'_, EarClipping>, corner: Option<Triangle>, vertex_idx: usize) -> Role {
    let is_left = !is_done(step.event()) && step.held.ring.contains(vertex_idx);
    let is_tip = corner.is_some_and(|[_, tip, _]| tip == vertex_idx);
    let is_beside = corner.is_some_and(|corner| corner.contains(&vertex_idx));
    if is_tip || blocks(step, vertex_idx) {
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

fn blocks(step: &Step<'_, EarClipping>, vertex_idx: usize) -> bool {
    matches!(step.event(), Some(Event::Blocked { by_idx, .. }) if by_idx == vertex_idx)
}

/// May this vertex lie in the triangle that is asked about? Only one that is left and not convex, and no corner of it.
fn is_rival(step: &Step<'_, EarClipping>, vertex_idx: usize) -> bool {
    let held = step.held;
    let is_asked = matches!(
        step.event(),
        Some(Event::Candidate { .. } | Event::Blocked { .. } | Event::Ear { .. })
    );
    let is_own = corner(step).is_some_and(|corner| corner.contains(&vertex_idx));
    let is_convex = held.corners[vertex_idx].is_none_or(|corner| corner == Corner::Convex);
    is_asked && !is_own && !is_convex && held.ring.contains(vertex_idx)
}

/// Where a rival lies, once that is known.
fn fate(step: &Step<'_, EarClipping>, vertex_idx: usize) -> Option<Value> {
    let is_ear = matches!(step.event(), Some(Event::Ear { .. }));
    let is_outside = is_ear && is_rival(step, vertex_idx);
    let inside = blocks(step, vertex_idx).then_some("ear-inside");
    Some(Value::Term(inside.or(is_outside.then_some("ear-outside"))?))
}

/// The triangles that have been cut off, and a place for each that is still to come.
fn triangles(step: &Step<'_, EarClipping>) -> ListColumn {
    let cut_off = step.held.cut_off.triangles();
    let n = step.input.vertices().len() - 2;
    let last = cut_off.len().checked_sub(1);
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
    ListColumn::about(Value::Term("ear-list-triangles"), n, last, entry)
}
