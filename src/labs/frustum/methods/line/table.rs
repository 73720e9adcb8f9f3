//! The rows of a line clipper: two numbers of each plane, where the line crosses it, and what is left after it.

use crate::{
    algo::volume::{LineRow, LineState},
    figure::{Cell, Role, Side, Table, TableNote, TableRow, WatchRow},
    labs::{
        interval::{ShownCrossing, ShownInterval, direction, value_of},
        words::name,
    },
    text::{Formula, Message, Value},
};

use super::{
    super::super::stage::Scenery,
    look::{Event, LineLook, PlaneLook, ShownLine, ratio},
};

/// The plane that the step is about; while the interval is looked at, the last one.
pub fn plane_in_hand<P: Copy, const N: usize>(
    state: &LineState<P, N>,
    event: Option<Event<P, N>>,
) -> Option<P> {
    match event? {
        Event::Row { plane, .. }
        | Event::Parallel { plane, .. }
        | Event::Enter { plane, .. }
        | Event::Leave { plane, .. } => Some(plane),
        Event::Reject { plane } => plane,
        Event::Interval { .. } => state.rows.last().map(|row| row.plane),
        Event::Delta { .. } | Event::Depths { .. } | Event::Put { .. } | Event::Accept { .. } => {
            None
        }
    }
}

/// What is left of the parameter in a state; `event` tells which plane is the step's.
pub fn interval<const N: usize, B: LineLook<N>>(
    state: &LineState<B::Plane, N>,
    event: Option<Event<B::Plane, N>>,
    scenery: Option<&Scenery>,
) -> ShownInterval {
    let current = plane_in_hand(state, event);
    let crossings = state.rows.iter().filter_map(|row| {
        let at = row.r?;
        Some(ShownCrossing {
            at,
            quotient: ratio::<N, B>(row, at),
            side: Side::of(row.p),
            holds: state.set_by.contains(&Some(row.plane)),
            current: current == Some(row.plane),
            name: row.plane.name(scenery),
            link: row.plane.link(),
        })
    });
    let is_outside = matches!(event, Some(Event::Parallel { inside: false, .. }));
    ShownInterval {
        symbol: B::SYMBOLS[0],
        bounds: state.interval,
        crossings: crossings.collect(),
        is_rejected: is_outside || state.verdict == Some(None),
    }
}

/// The numbers of every plane that has been asked.
pub fn row_values<const N: usize, B: LineLook<N>>(
    shown: &ShownLine<'_, N, B>,
    scenery: Option<&Scenery>,
) -> Vec<WatchRow> {
    let rows = shown.state.rows.iter().map(|row| {
        let [a, b] = shown.input.bounds.numbers(&shown.state.ends, row);
        let r = row.r.map(|r| value_of(ratio::<N, B>(row, r)));
        let cells = vec![Some(Value::Number(a)), Some(Value::Number(b)), r];
        WatchRow::table(row.plane.name(scenery), cells)
            .linked(row.plane.link())
            .noted(Value::Term(direction(row.p)))
    });
    rows.collect()
}

/// What has been worked out in a row at this step.
struct Now {
    numbers: bool,
    r: bool,
}

/// Every row is there from the start; the current one is lit.
pub fn rows_table<const N: usize, B: LineLook<N>>(
    shown: &ShownLine<'_, N, B>,
    event: Option<Event<B::Plane, N>>,
    scenery: Option<&Scenery>,
) -> Table {
    let symbol = |symbol: &'static str| Formula::default().sym(symbol);
    let bound = |suffix| Formula::default().sym(format!("{}_{suffix}", B::SYMBOLS[0]));
    let mut above = [0.0, 1.0];
    let mut rows = Vec::new();
    for (nth, plane) in shown.input.bounds.planes().enumerate() {
        let row = shown.state.rows.get(nth);
        rows.push(plane_row(plane, row, shown, event, (above, scenery)));
        above = row.and_then(|row| row.left).unwrap_or(above);
    }
    let [first, second] = B::HEADER.map(symbol);
    Table {
        header: vec![
            Formula::default().term("column-plane"),
            first,
            second,
            symbol(B::SYMBOLS[1]),
            Formula::default(),
            bound("min"),
            bound("max"),
        ],
        rows,
        notes: notes::<N, B>(shown),
    }
}

fn plane_row<const N: usize, B: LineLook<N>>(
    plane: B::Plane,
    row: Option<&LineRow<B::Plane>>,
    shown: &ShownLine<'_, N, B>,
    event: Option<Event<B::Plane, N>>,
    (above, scenery): ([f64; 2], Option<&Scenery>),
) -> TableRow {
    let is_current = shown.in_hand == Some(plane);
    let now = Now {
        numbers: is_current && matches!(event, Some(Event::Row { .. })),
        r: is_current
            && matches!(
                event,
                Some(Event::Enter { .. } | Event::Leave { .. } | Event::Interval { .. })
            ),
    };
    let role = |is_now: bool| if is_now { Role::Signal } else { Role::Ink };
    let numbers = row.map(|row| shown.input.bounds.numbers(&shown.state.ends, row));
    // Before the first row: what the numbers are.
    let meaning = B::meaning(plane).filter(|_| shown.state.rows.is_empty());
    let number = |i: usize| match (&numbers, &meaning) {
        (None, Some(meaning)) => Cell::new(Role::Soft, Some(name(meaning[i].clone()))),
        (numbers, _) => Cell::new(role(now.numbers), numbers.map(|numbers| numbers[i])),
    };
    let r = row.and_then(|row| Some(value_of(ratio::<N, B>(row, row.r?))));
    let mut cells = vec![
        number(0),
        number(1),
        Cell::new(role(now.r), r),
        Cell::new(Role::Soft, row.map(|row| Value::Term(direction(row.p)))),
    ];
    cells.extend([0, 1].map(|i| {
        let Some(left) = row.and_then(|row| row.left) else {
            return Cell::new(Role::Soft, None::<Value>);
        };
        let value = Some(shown.interval.written(left[i]));
        if left[i] == above[i] {
            return Cell::new(Role::Soft, value);
        }
        Cell::new(role(now.r), value).strong()
    }));
    TableRow {
        name: plane.name(scenery),
        cells,
        is_current,
        link: Some(plane.link()),
    }
}

/// The rules that make the bounds.
fn notes<const N: usize, B: LineLook<N>>(shown: &ShownLine<'_, N, B>) -> Vec<TableNote> {
    let p = shown.in_hand.and(shown.state.rows.last()).map(|row| row.p);
    let note = |key, suffix, applies| TableNote {
        text: Message::new(key)
            .with("bound", name(format!("{}_{suffix}", B::SYMBOLS[0])))
            .with("crossing", name(B::SYMBOLS[1]))
            .with("first", name(B::HEADER[0]))
            .with("second", name(B::HEADER[1])),
        applies,
    };
    let [enter, leave] = if B::HEADER[0] == "p" {
        ["lb-note-enter", "lb-note-leave"]
    } else {
        ["space-line-note-enter", "space-line-note-leave"]
    };
    vec![
        note(enter, "min", p.is_some_and(|p| p < 0.0)),
        note(leave, "max", p.is_some_and(|p| p > 0.0)),
    ]
}
