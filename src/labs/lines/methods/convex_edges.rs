//! What Cyrus–Beck knows of the edges: their dot products and crossings, as a table and as an interval.

use crate::{
    algo::line::{
        CyrusBeck, CyrusBeckEvent as Event, CyrusBeckInput as Input, CyrusBeckRow as Row,
        CyrusBeckState as State, Ratio,
    },
    figure::{Cell, Link, Role, Side, Table, TableRow, WatchRow},
    labs::{
        Step,
        words::{name, subscript},
    },
    text::{Formula, Value},
};

use super::parametric::SegmentInterval;
use crate::labs::interval::{ShownCrossing, ShownInterval, direction, quotient, value_of};

/// `e₁`, `e₂`, …: edges are numbered from 1 on screen.
pub fn edge_name(edge_idx: usize) -> Value {
    name(format!("e{}", subscript(edge_idx + 1)))
}

/// What marks, rows and ticks about an edge have in common.
pub const fn edge_link(edge_idx: usize) -> Link {
    Link::nth("edge", edge_idx)
}

/// The edge that the step is about.
pub const fn current_edge(event: Option<Event>) -> Option<usize> {
    match event {
        Some(
            Event::Edge { edge_idx, .. }
            | Event::Parallel { edge_idx, .. }
            | Event::Enter { edge_idx, .. }
            | Event::Leave { edge_idx, .. }
            | Event::Reject { edge_idx },
        ) => Some(edge_idx),
        Some(Event::Interval { .. } | Event::Put { .. } | Event::Accept { .. }) | None => None,
    }
}

/// The edge whose products are shown: the one in hand, or the last one while the interval is looked at.
pub fn edge_in_hand(state: &State, event: Option<Event>) -> Option<usize> {
    match event {
        Some(Event::Interval { .. }) => state.rows.len().checked_sub(1),
        Some(Event::Reject { .. }) => None,
        event => current_edge(event),
    }
}

/// What is left of t in a state; `event` tells which edge is the step's.
pub fn interval(state: &State, event: Option<Event>) -> SegmentInterval {
    let current = edge_in_hand(state, event).or(current_edge(event));
    let crossings = state.rows.iter().enumerate().filter_map(|(i, row)| {
        Some(ShownCrossing {
            at: row.t?,
            quotient: ratio(row, row.t?),
            side: Side::of(-row.slope),
            holds: state.set_by.contains(&Some(i)),
            current: current == Some(i),
            name: edge_name(i),
            link: edge_link(i),
        })
    });
    let verdict = if matches!(event, Some(Event::Parallel { inside: false, .. })) {
        Some(None)
    } else {
        state.verdict
    };
    SegmentInterval {
        shown: ShownInterval {
            symbol: "t",
            bounds: state.interval,
            crossings: crossings.collect(),
            is_rejected: verdict == Some(None),
        },
        crossing_symbol: "t",
        verdict,
        goes_on: false,
        vector: edge_in_hand(state, event).map(|_| "D"),
    }
}

/// t as the quotient of its row.
pub fn ratio(row: &Row, t: f64) -> Ratio {
    quotient(0.0 - row.d1, row.slope, t)
}

/// Where the segment's line crosses the edges' lines, to make room for it.
pub fn reach(Input { clip, segment }: &Input) -> impl Iterator<Item = f64> {
    clip.half_planes().map(|plane| {
        let ([nx, ny], [ex, ey]) = (plane.normal(), plane.origin().to_array());
        let distance = |[x, y]: [f64; 2]| nx * (x - ex) + ny * (y - ey);
        let [d1, d2] = [segment.p1, segment.p2].map(|p| distance(p.to_array()));
        d1 / (d1 - d2)
    })
}

/// Both dot products and t of every edge.
pub fn row_values(step: &Step<'_, CyrusBeck>) -> Vec<WatchRow> {
    let of_edge =
        |i| WatchRow::table(edge_name(i), values(step.state.rows.get(i))).linked(edge_link(i));
    (0..step.input.clip.vertices().len()).map(of_edge).collect()
}

/// n·(P₁ − E), n·D, t.
fn values(row: Option<&Row>) -> Vec<Option<Value>> {
    let t = row.and_then(|row| Some(value_of(ratio(row, row.t?))));
    vec![
        row.map(|row| Value::Number(row.d1)),
        row.map(|row| Value::Number(row.slope)),
        t,
    ]
}

/// Every edge in a row; those that set the bounds stand out.
pub fn edge_table(step: &Step<'_, CyrusBeck>) -> Table {
    let symbol = |symbol: &'static str| Formula::default().sym(symbol);
    let current = match step.event {
        Some(Event::Put { edge_idx, .. }) => edge_idx,
        event => current_edge(event),
    };
    let rows = (0..step.input.clip.vertices().len()).map(|i| {
        let row = step.state.rows.get(i);
        let sets = step.state.set_by.contains(&Some(i));
        let role = if sets { Role::Ink } else { Role::Soft };
        let mut cells: Vec<Cell> = values(row)
            .into_iter()
            .map(|value| Cell::new(role, value))
            .collect();
        if sets {
            let t = cells.pop();
            cells.extend(t.map(Cell::strong));
        }
        let word = row.map(|row| Value::Term(direction(-row.slope)));
        cells.push(Cell::new(role, word));
        TableRow {
            name: edge_name(i),
            cells,
            is_current: current == Some(i),
            link: Some(edge_link(i)),
        }
    });
    Table {
        header: vec![
            Formula::default().term("table-polygon-edge"),
            symbol("n·(P₁ − E)"),
            symbol("n·D"),
            symbol("t"),
            Formula::default(),
        ],
        rows: rows.collect(),
        notes: Vec::new(),
    }
}
