//! What goes into a pipeline, and what has come out of it.

use crate::{
    algo::polygon::{Pipeline, PipelineEvent as Event},
    figure::{ItemMarker, ListColumn, ListLink, ListRow, Lists, Role},
    labs::words::{name, vertex_symbol},
    text::Value,
    trace::Step,
};

use super::lists::{output_symbol, vertex_link};

/// The view of both lists.
pub const IN_AND_OUT: &str = "in-and-out";

/// The polygon as far as it has been read, and the ring as far as it has come out.
pub fn in_and_out(step: &Step<'_, Pipeline>) -> Lists {
    let lists = [polygon(step), ring(step)];
    let links = links(step, [&lists[0], &lists[1]]);
    Lists {
        lists: lists.into(),
        links,
        legend: Vec::new(),
    }
}

fn polygon(step: &Step<'_, Pipeline>) -> ListColumn {
    let given = &step.input.vertices;
    let read = step.past.iter().rev().find_map(|event| {
        if let Event::Enter { vertex_idx, .. } = *event {
            vertex_idx
        } else {
            None
        }
    });
    let entry = |i: usize| {
        let mut entry = ListRow::new(name(vertex_symbol(i)));
        let is_entering = matches!(
            step.event(),
            Some(Event::Enter { vertex_idx: Some(idx), .. }) if idx == i
        );
        entry.role = match read {
            _ if is_entering => Role::Signal,
            Some(read) if i <= read => Role::Ink,
            Some(_) | None => Role::Faint,
        };
        entry.details = vec![Some(Value::Point(given[i].to_array()))];
        entry.link = Some(vertex_link(i));
        entry
    };
    let reach = ListColumn::reach(given.len(), read);
    ListColumn {
        n_before: reach.start,
        n_after: given.len() - reach.end,
        columns: vec![name("(x, y)")],
        is_ring: true,
        focus: read.map(|idx| idx - reach.start),
        ..ListColumn::new(Value::Term("sh-list-given"), reach.map(entry).collect())
    }
}

fn ring(step: &Step<'_, Pipeline>) -> ListColumn {
    let ring = &step.held.output;
    let is_done = matches!(step.event(), Some(Event::Done { .. }));
    let n = ring.len();
    let entry = |i: usize| {
        let mut entry = ListRow::new(name(output_symbol(i)));
        entry.role = if is_done {
            Role::Accepted
        } else {
            Role::Accent
        };
        entry.marker = Some(ItemMarker::Dot);
        entry.details = vec![Some(Value::Point(ring[i].to_array()))];
        entry
    };
    let focus = n.checked_sub(1);
    let reach = ListColumn::reach(n, focus);
    ListColumn {
        n_before: reach.start,
        n_after: n - reach.end,
        columns: vec![name("(x, y)")],
        is_ring: is_done,
        focus: focus.map(|focus| focus - reach.start),
        ..ListColumn::new(Value::Term("pipe-list-ring"), reach.map(entry).collect())
    }
}

/// From the vertices that have come through to what they are in the ring.
fn links(step: &Step<'_, Pipeline>, [polygon, ring]: [&ListColumn; 2]) -> Vec<ListLink> {
    let given = step.input.vertices.iter().skip(polygon.n_before);
    let given: Vec<_> = given.take(polygon.entries.len()).collect();
    let out = step.held.output.iter().skip(ring.n_before).enumerate();
    let last = ring.entries.len().saturating_sub(1);
    let link = |(to, vertex)| {
        let from = given.iter().position(|&other| other == vertex)?;
        let is_now = to == last && matches!(step.event(), Some(Event::Output { .. }));
        Some(ListLink {
            from: [0, from],
            to: [1, to],
            role: if is_now { Role::Signal } else { Role::Soft },
        })
    };
    out.filter_map(link).collect()
}
