//! The list of triangles in, with the distances of their corners from the plane at work, and the list out.

use std::ops::Range;

use crate::{
    algo::volume::{AskedTriangle, PlaneAtATimeEvent as Event, PlaneAtATimeState as State},
    figure::{ItemMarker, Link, ListColumn, ListLink, ListRow, Lists, Role},
    labs::words::{name, subscript},
    text::{Formula, Value},
};

use super::captions::triangle_symbol;

/// What marks and rows about a triangle of the list have in common.
pub const fn triangle_link(idx: usize) -> Link {
    Link::nth("triangle", idx)
}

/// `T₂′`: in the list out.
fn out_symbol(idx: usize) -> String {
    format!("{}′", triangle_symbol(idx))
}

/// Both lists at a step; at the end what is left.
pub fn pieces(state: &State, event: Option<Event>) -> Lists {
    let has_passed = matches!(event, Some(Event::Pass { .. }));
    let (n_in, n_out) = if has_passed {
        (state.passed.len(), state.list.len())
    } else {
        (state.list.len(), state.next.len())
    };
    if state.is_done {
        return Lists {
            lists: vec![left(n_in)],
            links: Vec::new(),
            legend: Vec::new(),
        };
    }
    let current = state.asked.last().filter(|_| !has_passed);
    let current = current.map(|asked| asked.triangle_idx);
    let reach = ListColumn::reach(n_in, current);
    let out_reach = ListColumn::reach(n_out, n_out.checked_sub(1));
    let is_new = |i: usize| matches!(event, Some(Event::Piece { .. })) && i + 1 == n_out;
    let links = match state.plane_idx {
        Some(_) => links(&state.origins, [&reach, &out_reach], is_new),
        None => Vec::new(),
    };
    let out_list = out_list((n_out, out_reach), has_passed, is_new);
    Lists {
        lists: vec![in_list(state, (n_in, reach), current, has_passed), out_list],
        links,
        legend: Vec::new(),
    }
}

fn in_list(
    state: &State,
    (n_in, reach): (usize, Range<usize>),
    current: Option<usize>,
    has_passed: bool,
) -> ListColumn {
    let entry = |i: usize| {
        let asked = state.asked.iter().find(|asked| asked.triangle_idx == i);
        let mut entry = ListRow::new(name(triangle_symbol(i)));
        entry.role = match asked {
            _ if current == Some(i) => Role::Signal,
            Some(asked) if asked.inside.contains(&true) => Role::Ink,
            Some(_) => Role::Discarded,
            None => Role::Soft,
        };
        entry.marker = asked.map(marker);
        entry.details = (0..3)
            .map(|corner| {
                asked.map(|asked| Value::Formula(Formula::decimals().num(asked.distances[corner])))
            })
            .collect();
        entry.link = Some(triangle_link(i)).filter(|_| !has_passed);
        entry
    };
    let columns = (0..3).map(|i| name(format!("d{}", subscript(i))));
    ListColumn {
        columns: columns.collect(),
        n_before: reach.start,
        n_after: n_in - reach.end,
        focus: current.map(|current| current - reach.start),
        ..ListColumn::new(
            Value::Term("tri-list-in"),
            reach.clone().map(entry).collect(),
        )
    }
}

fn out_list(
    (n_out, reach): (usize, Range<usize>),
    has_passed: bool,
    is_new: impl Fn(usize) -> bool,
) -> ListColumn {
    let out = |i: usize| {
        let mut entry = ListRow::new(name(out_symbol(i)));
        entry.role = if is_new(i) {
            Role::Signal
        } else {
            Role::Accent
        };
        entry.marker = Some(ItemMarker::Dot);
        // Once the plane is done with, the new triangles stand on the stage.
        entry.link = Some(triangle_link(i)).filter(|_| has_passed);
        entry
    };
    ListColumn {
        n_before: reach.start,
        n_after: n_out - reach.end,
        focus: n_out.checked_sub(1).map(|last| last - reach.start),
        ..ListColumn::new(
            Value::Term("tri-list-out"),
            reach.clone().map(out).collect(),
        )
    }
}

/// From each triangle of the list in to those that came of it, as far as both stand in the view.
fn links(
    origins: &[usize],
    [reach, out_reach]: [&Range<usize>; 2],
    is_new: impl Fn(usize) -> bool,
) -> Vec<ListLink> {
    let place = |reach: &Range<usize>, i: usize| reach.contains(&i).then(|| i - reach.start);
    let link = |(i, &origin): (usize, &usize)| {
        Some(ListLink {
            from: [0, place(reach, origin)?],
            to: [1, place(out_reach, i)?],
            role: if is_new(i) { Role::Signal } else { Role::Soft },
        })
    };
    origins.iter().enumerate().filter_map(link).collect()
}

/// Whole, in part, or not at all inside.
fn marker(asked: &AskedTriangle) -> ItemMarker {
    match asked.inside.iter().filter(|&&inside| inside).count() {
        3 => ItemMarker::Dot,
        0 => ItemMarker::Ring,
        1 | 2 | 4.. => ItemMarker::Cross,
    }
}

fn left(n: usize) -> ListColumn {
    let reach = ListColumn::reach(n, None);
    let entry = |i: usize| {
        let mut entry = ListRow::new(name(triangle_symbol(i)));
        entry.role = Role::Accepted;
        entry.marker = Some(ItemMarker::Dot);
        entry.link = Some(triangle_link(i));
        entry
    };
    ListColumn {
        n_after: n - reach.end,
        ..ListColumn::new(Value::Term("tri-list-left"), reach.map(entry).collect())
    }
}
