//! What becomes of each triangle where a polygon is cut into triangles first and each of them clipped on its own.

use crate::{
    algo::polygon::{
        EachTriangleEvent as Each, Triangle, TriangulateAndClip, TriangulateAndClipEvent as Event,
    },
    figure::{ItemMarker, ListColumn, ListLink, ListRow, Lists, Role},
    labs::words::{name, subscript},
    text::Value,
    trace::Step,
};

use super::triangles::{triangle_link, triangle_name};

/// Is the polygon still cut into triangles?
pub fn is_triangulating(step: &Step<'_, TriangulateAndClip>) -> bool {
    matches!(step.event(), Some(Event::Triangulate(_)) | None)
}

/// Is everything told?
pub fn is_done(step: &Step<'_, TriangulateAndClip>) -> bool {
    matches!(step.event(), Some(Event::Each(Each::Finish { .. })))
}

/// The triangle whose turn it is, and its number.
pub fn triangle_now(step: &Step<'_, TriangulateAndClip>) -> Option<(usize, Triangle)> {
    if is_triangulating(step) || is_done(step) {
        return None;
    }
    let triangle_idx = step.held.triangle_idx;
    let triangle = step.held.ears.cut_off.triangles().get(triangle_idx)?;
    Some((triangle_idx, *triangle))
}

/// The view of triangles and pieces.
pub const FATES: &str = "fates";

/// What has become of a triangle.
#[derive(Clone, Copy, PartialEq, Eq)]
enum TriangleFate {
    ToCome,
    Now,
    /// It is, or has left, a piece.
    Piece,
    Dropped,
}

/// The triangles, the pieces, and which comes from which.
pub fn fates(step: &Step<'_, TriangulateAndClip>) -> Lists {
    let lists = [triangles(step), pieces(step)];
    let [from, to] = [&lists[0], &lists[1]].map(|list| list.n_before);
    let n = lists.each_ref().map(|list| list.entries.len());
    let links = step.held.pieces.triangles().iter().enumerate();
    let links = links.filter_map(|(piece, triangle)| {
        let from = triangle.checked_sub(from).filter(|&from| from < n[0])?;
        let to = piece.checked_sub(to).filter(|&to| to < n[1])?;
        let is_now = is_new(step) && to + 1 == n[1];
        Some(ListLink {
            from: [0, from],
            to: [1, to],
            role: if is_now { Role::Signal } else { Role::Soft },
        })
    });
    let links = links.collect();
    Lists {
        lists: lists.into(),
        links,
        legend: Vec::new(),
    }
}

/// Has the triangle been done with at this very step, and left something?
fn is_new(step: &Step<'_, TriangulateAndClip>) -> bool {
    let is_piece = matches!(step.event(), Some(Event::Each(Each::Piece { .. })));
    is_piece && step.held.pieces.triangles().last() == Some(&step.held.triangle_idx)
}

fn fate(step: &Step<'_, TriangulateAndClip>, triangle_idx: usize) -> TriangleFate {
    let is_done = matches!(step.event(), Some(Event::Each(Each::Piece { .. })));
    let n_done = step.held.triangle_idx + usize::from(is_done);
    if triangle_idx < n_done {
        let is_piece = step.held.pieces.triangles().contains(&triangle_idx);
        return if is_piece {
            TriangleFate::Piece
        } else {
            TriangleFate::Dropped
        };
    }
    if triangle_now(step).is_some_and(|(now, _)| now == triangle_idx) {
        TriangleFate::Now
    } else {
        TriangleFate::ToCome
    }
}

fn triangles(step: &Step<'_, TriangulateAndClip>) -> ListColumn {
    let all = step.held.ears.cut_off.triangles();
    let entry = |i: usize| {
        let fate = fate(step, i);
        let mut entry = ListRow::new(triangle_name(all[i]));
        entry.role = match fate {
            TriangleFate::Now => Role::Signal,
            TriangleFate::Piece => Role::Ink,
            TriangleFate::Dropped => Role::Discarded,
            TriangleFate::ToCome => Role::Soft,
        };
        entry.marker = match fate {
            TriangleFate::Piece => Some(ItemMarker::Dot),
            TriangleFate::Dropped => Some(ItemMarker::Ring),
            TriangleFate::Now | TriangleFate::ToCome => None,
        };
        let word = (fate == TriangleFate::Dropped).then_some(Value::Term("tac-dropped"));
        entry.details = vec![word];
        entry.link = Some(triangle_link(i));
        entry
    };
    let now = triangle_now(step).map(|(now, _)| now);
    let focus = now.or(all.len().checked_sub(1));
    let reach = ListColumn::reach(all.len(), focus);
    ListColumn {
        n_before: reach.start,
        n_after: all.len() - reach.end,
        focus: focus.map(|focus| focus - reach.start),
        ..ListColumn::new(
            Value::Term("tac-list-triangles"),
            reach.clone().map(entry).collect(),
        )
    }
}

fn pieces(step: &Step<'_, TriangulateAndClip>) -> ListColumn {
    let (pieces, n) = (&step.held.pieces, step.held.pieces.len());
    let focus = n.checked_sub(1);
    let reach = ListColumn::reach(n, focus);
    let rings = pieces.rings().zip(pieces.triangles());
    let shown = rings.enumerate().skip(reach.start).take(reach.len());
    let entry = |(i, (ring, &triangle_idx)): (usize, (&[_], &usize))| {
        let mut entry = ListRow::new(name(format!("Q{}", subscript(i + 1))));
        entry.role = Role::Accepted;
        entry.details = vec![Some(Value::Count(ring.len()))];
        entry.link = Some(triangle_link(triangle_idx));
        entry
    };
    ListColumn {
        columns: vec![Value::Term("tac-vertices")],
        n_before: reach.start,
        n_after: n - reach.end,
        focus: focus.map(|focus| focus - reach.start),
        ..ListColumn::new(Value::Term("tac-list-pieces"), shown.map(entry).collect())
    }
}
