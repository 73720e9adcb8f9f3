//! The rows of a clipper by inequalities: two numbers of each plane, where the line crosses it, and what is left after it.

use super::{
    line_step::{LineLook, LineStep, ratio},
    prelude::*,
};

/// The numbers of every plane, or of those that have been asked.
pub fn row_values<const N: usize, B: LineLook<N>>(
    shown: &LineStep<'_, N, B>,
    scenery: Option<&B::Scenery>,
) -> Vec<WatchRow> {
    let [all, says_direction] = B::WATCHES;
    let bounds = shown.input.bounds();
    let rows = bounds.planes().enumerate().map(|(nth, plane)| {
        let row = shown.rows.get(nth);
        let numbers = row.map(|row| bounds.numbers(&shown.ends, row));
        let number = |i: usize| numbers.map(|numbers| Value::Number(numbers[i]));
        let r = row.and_then(|row| Some(value_of(ratio(row, row.r?))));
        let cells = vec![number(0), number(1), r];
        let named = B::plane(plane, scenery);
        let word = row.filter(|_| says_direction);
        WatchRow {
            link: named.link,
            note: word.map(|row| Value::Term(direction(row.p()))),
            ..WatchRow::table(named.value.unwrap_or_else(|| name("")), cells)
        }
    });
    let n_rows = if all { usize::MAX } else { shown.rows.len() };
    rows.take(n_rows).collect()
}

pub fn rows_table<const N: usize, B: LineLook<N>>(
    shown: &LineStep<'_, N, B>,
    scenery: Option<&B::Scenery>,
) -> Table {
    let bound = |suffix| sym(format!("{}_{suffix}", B::SYMBOLS[0]));
    let mut above = [0.0, 1.0];
    let mut rows = Vec::new();
    if B::STARTS_WHOLE {
        rows.push(start_row());
    }
    for (nth, plane) in shown.input.bounds().planes().enumerate() {
        rows.push(plane_row(nth, plane, shown, above, scenery));
        let left = shown.rows.get(nth).and_then(|row| row.left);
        above = left.unwrap_or(above);
    }
    let [first, second] = B::HEADER.map(sym);
    Table {
        header: vec![
            Formula::default().term(B::PLANES),
            first,
            second,
            B::quotient_header(),
            Formula::default(),
            bound("min"),
            bound("max"),
        ],
        rows,
        notes: notes(shown),
    }
}

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

fn plane_row<const N: usize, B: LineLook<N>>(
    nth: usize,
    plane: B::Plane,
    shown: &LineStep<'_, N, B>,
    above: [f64; 2],
    scenery: Option<&B::Scenery>,
) -> TableRow {
    use LineEvent::{Enter, Interval, Leave};

    let row = shown.rows.get(nth);
    let is_current = shown.in_hand() == Some(plane);
    let [numbers_role, r_role] = match shown.event.filter(|_| is_current) {
        Some(LineEvent::Row { .. }) => [Role::Signal, Role::Ink],
        Some(Enter { .. } | Leave { .. } | Interval { .. }) => [Role::Ink, Role::Signal],
        _ => [Role::Ink; 2],
    };
    let bounds = shown.input.bounds();
    let numbers = row.map(|row| bounds.numbers(&shown.ends, row));
    // Before the first row: what the numbers are.
    let meaning = B::meaning(plane).filter(|_| shown.rows.is_empty());
    let number = |i: usize| match (&numbers, &meaning) {
        (None, Some(meaning)) => Cell::new(Role::Soft, Some(name(meaning[i].clone()))),
        (numbers, _) => Cell::new(numbers_role, numbers.map(|numbers| numbers[i])),
    };
    let r = row.and_then(|row| Some(value_of(ratio(row, row.r?))));
    let mut cells = vec![
        number(0),
        number(1),
        Cell::new(r_role, r),
        Cell::new(Role::Soft, row.map(|row| Value::Term(direction(row.p())))),
    ];
    cells.extend([0, 1].map(|i| {
        let Some(left) = row.and_then(|row| row.left) else {
            return Cell::new(Role::Soft, None::<Value>);
        };
        let value = Some(shown.interval(scenery).written(left[i]));
        if left[i] == above[i] {
            return Cell::new(Role::Soft, value);
        }
        Cell::new(r_role, value).strong()
    }));
    TableRow {
        name: B::plane_in_table(plane, scenery).unwrap_or_else(|| name("")),
        cells,
        is_current,
        link: B::plane(plane, scenery).link,
    }
}

fn notes<const N: usize, B: LineLook<N>>(shown: &LineStep<'_, N, B>) -> Vec<TableNote> {
    let row = shown.in_hand().and(shown.rows.last());
    let applies = |of: fn(f64) -> bool| row.is_some_and(|row| of(row.p()));
    let note = |key, suffix, applies| TableNote {
        text: Message::new(key)
            .with("bound", name(format!("{}_{suffix}", B::SYMBOLS[0])))
            .with("crossing", name(B::SYMBOLS[1]))
            .with("first", name(B::HEADER[0]))
            .with("second", name(B::HEADER[1])),
        applies,
    };
    let [enter, leave] = B::NOTES;
    let mut notes = vec![
        note(enter, "min", applies(|p| p < 0.0)),
        note(leave, "max", applies(|p| p > 0.0)),
    ];
    notes.extend(B::other_notes(shown));
    notes
}
