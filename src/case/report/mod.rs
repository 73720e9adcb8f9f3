//! Cases for people: what is given, every step with its arithmetic, the answer and what it cost. As a table
//! for a terminal, or as an answer key in Markdown.

mod columns;
mod markdown;
mod refusing;
mod text;

use std::ops::ControlFlow;

use crate::{
    figure::{Run, WatchRow, WatchSection, mark_changes},
    input::Given,
    text::{Catalog, Message},
    trace::Counts,
};

use super::{Id, refusal::short};

pub(super) use markdown::markdown;
pub use refusing::Refusing;
pub(super) use text::text;

/// One step, in words and numbers.
struct StepRow {
    step: usize,
    decision: String,
    formulas: Vec<String>,
    changed: Vec<String>,
}

/// Every step of a run, the problem's statement at step 0 first.
fn step_rows(run: &dyn Run, catalog: &Catalog) -> Vec<StepRow> {
    let (mut rows, mut before) = (Vec::new(), None);
    run.visit([0, run.n_steps()], &mut |step, shown| {
        let (caption, mut watch) = (shown.caption(), shown.watch());
        if let Some(before) = &before {
            mark_changes(&mut watch, before);
        }
        let changed = watch.iter().flat_map(|section| {
            let rows = section.rows.iter().filter(|row| row.has_changed());
            rows.map(|row| changed_row(section, row, catalog))
        });
        let arithmetic = caption.arithmetic.iter();
        rows.push(StepRow {
            step,
            decision: catalog.message(&caption.decision),
            formulas: arithmetic.map(|f| catalog.formula(f)).collect(),
            changed: changed.collect(),
        });
        before = Some(watch);
        ControlFlow::Continue(())
    });
    rows
}

/// `code₁ = 0001 (to the left)`, or `left edge: p = −4, q = −1, r = 1/4`.
fn changed_row(section: &WatchSection, row: &WatchRow, catalog: &Catalog) -> String {
    let name = catalog.value(&row.name);
    let cells = row
        .cells
        .iter()
        .map(|c| c.as_ref().map(|c| catalog.value(c)));
    let mut text = if section.header.is_empty() {
        let values: Vec<String> = cells.flatten().collect();
        format!("{name} = {}", values.join(catalog.lang().list_separator()))
    } else {
        let named = section.header.iter().zip(cells);
        let values: Vec<String> = named
            .filter_map(|(head, cell)| {
                let head = catalog.value(head);
                cell.map(|cell| format!("{head} = {cell}"))
            })
            .collect();
        let values = values.join(catalog.lang().list_separator());
        let row = Message::new("report-row").with("name", name);
        catalog.message(&row.with("values", values))
    };
    if let Some(note) = &row.note {
        let note = catalog.value(note);
        // "≠ 0" goes on with the equation, "= 0" would say it twice, and a word on the value stands aside.
        if note.starts_with('≠') {
            text = format!("{text} {note}");
        } else if !note.starts_with('=') {
            let noted = Message::new("report-noted").with("value", text);
            text = catalog.message(&noted.with("note", note));
        }
    }
    text
}

/// "Case 3", or "Case 3 (id)".
fn case_name(number: usize, id: &Id, catalog: &Catalog) -> String {
    let message = match id.name() {
        None => Message::new("report-case"),
        Some(id) => Message::new("report-case-id").with("id", short(&id)),
    };
    catalog.message(&message.with("number", number))
}

/// Name and values of what is given.
fn given_row(given: &Given, catalog: &Catalog) -> [String; 2] {
    let shown = given.values.iter();
    let mut values: Vec<String> = shown.map(|value| catalog.value(value)).collect();
    if given.n_values > values.len() {
        values.push(format!("… ({})", given.n_values));
    }
    [
        catalog.term(given.name_key),
        values.join(catalog.lang().list_separator()),
    ]
}

/// Name and number of each kind of operation, and of all together.
fn cost_rows(counts: Counts, catalog: &Catalog) -> [[String; 2]; 5] {
    let Counts { add, mul, div, cmp } = counts;
    [
        ("cost-additions", add),
        ("cost-multiplications", mul),
        ("cost-divisions", div),
        ("cost-comparisons", cmp),
        ("cost-total", add + mul + div + cmp),
    ]
    .map(|(key, n)| [catalog.term(key), n.to_string()])
}
