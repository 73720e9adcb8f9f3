//! What Cyrus–Beck knows of the edges: their dot products and crossings, as a table.

use crate::{
    algo::line::CyrusBeckEvent as Event,
    figure::{Cell, Link, Role, Table, TableRow},
    geom::ConvexPolygon,
    labs::{
        interval::direction,
        segments::{LineStep, row_values},
        words::{name, subscript},
    },
    text::{Formula, Value},
};

/// A step of Cyrus–Beck.
pub type Shown<'a> = LineStep<'a, 2, ConvexPolygon>;

/// `e₁`, `e₂`, …: edges are numbered from 1 on screen.
pub fn edge_name(edge_idx: usize) -> Value {
    name(format!("e{}", subscript(edge_idx + 1)))
}

/// What marks, rows and ticks about an edge have in common.
pub const fn edge_link(edge_idx: usize) -> Link {
    Link::nth("edge", edge_idx)
}

/// The edge whose products are shown: the one in hand, as long as it is not rejected by.
pub fn edge_in_hand(shown: &Shown<'_>) -> Option<usize> {
    let is_rejected = matches!(shown.event, Some(Event::Reject { .. }));
    shown.in_hand().filter(|_| !is_rejected)
}

/// Every edge in a row; those that set the bounds stand out.
pub fn edge_table(shown: &Shown<'_>) -> Table {
    let symbol = |symbol: &'static str| Formula::default().sym(symbol);
    let is_interval = matches!(shown.event, Some(Event::Interval { .. }));
    let current = if let Some(Event::Put { plane, .. }) = shown.event {
        plane
    } else {
        shown.in_hand().filter(|_| !is_interval)
    };
    let values = row_values(shown, None);
    let rows = values.into_iter().enumerate().map(|(i, values)| {
        let row = shown.rows.get(i);
        let sets = shown.set_by.contains(&Some(i));
        let role = if sets { Role::Ink } else { Role::Soft };
        let mut cells: Vec<Cell> = values
            .cells
            .into_iter()
            .map(|value| Cell::new(role, value))
            .collect();
        if sets {
            let t = cells.pop();
            cells.extend(t.map(Cell::strong));
        }
        let word = row.map(|row| Value::Term(direction(row.p())));
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
