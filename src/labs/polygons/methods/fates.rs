//! What becomes of each triangle where a polygon is cut into triangles first and each of them clipped on its own.

use crate::algo::polygon::{
    EachTriangleEvent as Each, Triangle, TriangulateAndClip, TriangulateAndClipEvent as Event,
};

use super::{
    prelude::*,
    triangles::{triangle_link, triangle_name},
};

pub fn is_triangulating(step: &Step<'_, TriangulateAndClip>) -> bool {
    matches!(step.event(), Some(Event::Triangulate(_)) | None)
}

pub fn is_done(step: &Step<'_, TriangulateAndClip>) -> bool {
    matches!(step.event(), Some(Event::Each(Each::Finish { .. })))
}

pub fn triangle_now(step: &Step<'_, TriangulateAndClip>) -> Option<(usize, Triangle)> {
    if is_triangulating(step) || is_done(step) {
        return None;
    }
    let triangle_idx = step.held.triangle_idx;
    let triangle = step.held.ears.cut_off.triangles().get(triangle_idx)?;
    Some((triangle_idx, *triangle))
}

pub const FATES: &str = "fates";

/// The triangles, the pieces, and which comes from which.
pub fn fates(step: &Step<'_, TriangulateAndClip>) -> Lists {
    let lists = [triangles(step), pieces(step)];
    let links = step.held.pieces.triangles().iter().enumerate();
    let links = links.filter_map(|(piece, &triangle)| {
        let (from, to) = (lists[0].entry_of(triangle)?, lists[1].entry_of(piece)?);
        let is_now = is_new(step) && to + 1 == lists[1].entries.len();
        let role = if is_now { Role::Signal } else { Role::Soft };
        Some(ListLink::between(from, to, role))
    });
    Lists {
        links: links.collect(),
        lists: lists.into(),
        legend: Vec::new(),
    }
}

fn is_piece(step: &Step<'_, TriangulateAndClip>) -> bool {
    matches!(step.event(), Some(Event::Each(Each::Piece { .. })))
}

/// Has the triangle been done with at this very step, and left something?
fn is_new(step: &Step<'_, TriangulateAndClip>) -> bool {
    is_piece(step) && step.held.pieces.triangles().last() == Some(&step.held.triangle_idx)
}

fn triangles(step: &Step<'_, TriangulateAndClip>) -> ListColumn {
    let all = step.held.ears.cut_off.triangles();
    let n_done = step.held.triangle_idx + usize::from(is_piece(step));
    let now = triangle_now(step).map(|(now, _)| now);
    let entry = |i: usize| {
        // Of those that are done: is it, or has it left, a piece?
        let is_kept = (i < n_done).then(|| step.held.pieces.triangles().contains(&i));
        ListRow {
            role: match is_kept {
                Some(true) => Role::Ink,
                Some(false) => Role::Discarded,
                None if now == Some(i) => Role::Signal,
                None => Role::Soft,
            },
            marker: is_kept.map(ItemMarker::dot_or_ring),
            details: vec![(is_kept == Some(false)).then_some(Value::Term("tac-dropped"))],
            link: Some(triangle_link(i)),
            ..ListRow::new(triangle_name(all[i]))
        }
    };
    let focus = now.or(all.len().checked_sub(1));
    ListColumn::about(Value::Term("tac-list-triangles"), all.len(), focus, entry)
}

fn pieces(step: &Step<'_, TriangulateAndClip>) -> ListColumn {
    let (pieces, n) = (&step.held.pieces, step.held.pieces.len());
    let entry = |i: usize| ListRow {
        role: Role::Accepted,
        details: vec![Some(Value::Count(pieces.ring(i).len()))],
        link: Some(triangle_link(pieces.triangles()[i])),
        ..ListRow::new(name(numbered('Q', i)))
    };
    ListColumn {
        columns: vec![Value::Term("tac-vertices")],
        ..ListColumn::about(Value::Term("tac-list-pieces"), n, n.checked_sub(1), entry)
    }
}
