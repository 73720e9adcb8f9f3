//! The rows of Liang–Barsky: p, q, r of each side and what is left of u after it, as a table and as an interval.

use crate::{
    algo::line::{
        LiangBarsky, LiangBarskyEvent as Event, LiangBarskyState as State, Ratio, Row, Visible,
        WindowInput,
    },
    figure::{Cell, Role, Side, Table, TableNote, TableRow, WatchRow},
    geom::Edge,
    labs::{
        Step,
        words::{along, edge_link, edge_name, name},
    },
    text::{Formula, Message, Value},
};

use super::{parametric::SegmentInterval, shared::side_key};
use crate::labs::interval::{ShownCrossing, ShownInterval, direction, quotient, value_of};

/// What is left of u in a state; `event` tells which side is the step's.
pub fn interval(state: &State, event: Option<Event>) -> SegmentInterval {
    let current = edge_in_hand(state, event);
    let crossings = state.rows.into_iter().flatten().filter_map(|row| {
        let at = row.r?;
        Some(ShownCrossing {
            at,
            quotient: quotient(row.q, row.p, at),
            side: Side::of(row.p),
            holds: state.set_by.contains(&Some(row.edge)),
            current: current == Some(row.edge),
            name: edge_name(row.edge),
            link: edge_link(row.edge),
        })
    });
    let verdict = verdict(state, event);
    SegmentInterval {
        shown: ShownInterval {
            symbol: "u",
            bounds: state.interval,
            crossings: crossings.collect(),
            is_rejected: verdict == Some(None),
        },
        crossing_symbol: "r",
        verdict,
        goes_on: true,
        vector: None,
    }
}

/// r as the quotient of its row.
pub fn ratio(state: &State, edge: Edge, r: f64) -> Ratio {
    let row = state.rows[edge as usize];
    row.map_or(Ratio { num: r, den: 1.0 }, |row| quotient(row.q, row.p, r))
}

/// The side that the step is about; while the interval is looked at, the last one.
pub fn edge_in_hand(state: &State, event: Option<Event>) -> Option<Edge> {
    match event? {
        Event::Row { edge, .. }
        | Event::Parallel { edge, .. }
        | Event::Enter { edge, .. }
        | Event::Leave { edge, .. }
        | Event::Reject { edge } => Some(edge),
        Event::Interval { .. } => state.rows.iter().flatten().last().map(|row| row.edge),
        Event::Delta { .. } | Event::Put { .. } | Event::Accept { .. } => None,
    }
}

/// The answer that a step shows: what lies outside a parallel side is rejected as soon as that is seen.
fn verdict(state: &State, event: Option<Event>) -> Option<Visible> {
    if matches!(event, Some(Event::Parallel { inside: false, .. })) {
        Some(None)
    } else {
        state.verdict
    }
}

/// Where the segment's line crosses the sides, to make room for it.
pub fn reach(WindowInput { window, segment }: &WindowInput) -> impl Iterator<Item = f64> {
    Edge::ALL.into_iter().map(|edge| {
        let [a1, a2] = [segment.p1, segment.p2].map(|p| along(p, edge.axis())[0]);
        (window.border(edge) - a1) / (a2 - a1)
    })
}

/// p, q and r of every side.
pub fn row_values(state: &State) -> Vec<WatchRow> {
    let of_edge = |edge| {
        let row = state.rows[edge as usize];
        let cells = vec![
            row.map(|row| Value::Number(row.p)),
            row.map(|row| Value::Number(row.q)),
            row.and_then(|row| Some(value_of(quotient(row.q, row.p, row.r?)))),
        ];
        let shown = WatchRow::table(edge_name(edge), cells).linked(edge_link(edge));
        match row {
            Some(row) => shown.noted(Value::Term(direction(row.p))),
            None => shown,
        }
    };
    Edge::ALL.map(of_edge).to_vec()
}

/// What has been worked out in the row of a side at this step.
struct Now {
    p_and_q: bool,
    r: bool,
}

/// Every row is there from the start; the current one is lit.
pub fn rows_table(step: &Step<'_, LiangBarsky>) -> Table {
    let word = |key| Formula::default().term(key);
    let symbol = |symbol: &'static str| Formula::default().sym(symbol);
    let mut above = [0.0, 1.0];
    let mut rows = vec![start_row()];
    for edge in Edge::ALL {
        rows.push(side_row(edge, step, above));
        let left = step.state.rows[edge as usize].and_then(|row| row.left);
        above = left.unwrap_or(above);
    }
    Table {
        header: vec![
            word("table-edge"),
            symbol("p"),
            symbol("q"),
            symbol("r = ").over(symbol("q"), symbol("p")),
            Formula::default(),
            symbol("u_min"),
            symbol("u_max"),
        ],
        rows,
        notes: notes(step),
    }
}

/// All of the segment.
fn start_row() -> TableRow {
    let mut cells = vec![Cell::new(Role::Ink, None::<Value>); 4];
    cells.extend([0.0, 1.0].map(|bound| Cell::new(Role::Ink, Some(bound))));
    TableRow {
        name: Value::Term("table-start"),
        cells,
        is_current: false,
        link: None,
    }
}

fn side_row(edge: Edge, step: &Step<'_, LiangBarsky>, above: [f64; 2]) -> TableRow {
    let row = step.state.rows[edge as usize];
    let is_current = edge_in_hand(step.state, step.event) == Some(edge);
    let now = Now {
        p_and_q: is_current && matches!(step.event, Some(Event::Row { .. })),
        r: is_current
            && matches!(
                step.event,
                Some(Event::Enter { .. } | Event::Leave { .. } | Event::Interval { .. })
            ),
    };
    let role = |is_now: bool| if is_now { Role::Signal } else { Role::Ink };
    let r = row.and_then(|row| Some(value_of(quotient(row.q, row.p, row.r?))));
    // Before the first row: what p and q are.
    let is_before = step.state.rows.iter().all(Option::is_none);
    let of_row = |i: usize, known: Option<f64>| match known {
        None if is_before => Cell::new(Role::Soft, Some(name(meaning(edge)[i]))),
        known => Cell::new(role(now.p_and_q), known),
    };
    let mut cells = vec![
        of_row(0, row.map(|row| row.p)),
        of_row(1, row.map(|row| row.q)),
        Cell::new(role(now.r), r),
        Cell::new(Role::Soft, row.map(|row| Value::Term(direction(row.p)))),
    ];
    cells.extend([0, 1].map(|i| bound_cell(i, row, step.state, above, now.r)));
    TableRow {
        name: Value::Term(side_key(edge)),
        cells,
        is_current,
        link: Some(edge_link(edge)),
    }
}

/// p and q of a side: u · p ≤ q says that P(u) is inside it.
const fn meaning(edge: Edge) -> [&'static str; 2] {
    match edge {
        Edge::Left => ["−Δx", "x₁ − x_min"],
        Edge::Right => ["Δx", "x_max − x₁"],
        Edge::Bottom => ["−Δy", "y₁ − y_min"],
        Edge::Top => ["Δy", "y_max − y₁"],
    }
}

/// u_min or u_max after a row: soft where it is what it was above.
fn bound_cell(i: usize, row: Option<Row>, state: &State, above: [f64; 2], is_now: bool) -> Cell {
    let Some(left) = row.and_then(|row| row.left) else {
        return Cell::new(Role::Soft, None::<Value>);
    };
    let value = Some(interval(state, None).shown.written(left[i]));
    if left[i] == above[i] {
        return Cell::new(Role::Soft, value);
    }
    Cell::new(if is_now { Role::Signal } else { Role::Ink }, value).strong()
}

/// The rules that make the bounds; that of the parallel only where the segment is parallel to two sides.
fn notes(step: &Step<'_, LiangBarsky>) -> Vec<TableNote> {
    let segment = &step.input.segment;
    let p = edge_in_hand(step.state, step.event)
        .and_then(|edge| step.state.rows[edge as usize])
        .map(|row| row.p);
    let note = |key, symbol: &str, applies| TableNote {
        text: Message::new(key).with("bound", name(symbol)),
        applies,
    };
    let mut notes = vec![
        note("lb-note-enter", "u_min", p.is_some_and(|p| p < 0.0)),
        note("lb-note-leave", "u_max", p.is_some_and(|p| p > 0.0)),
    ];
    if segment.p1.x() == segment.p2.x() || segment.p1.y() == segment.p2.y() {
        notes.push(TableNote {
            text: Message::new("lb-note-parallel"),
            applies: p == Some(0.0),
        });
    }
    notes
}
