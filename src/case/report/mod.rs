//! Cases for people: what is given, every step with its arithmetic, the answer and what it cost. As a table
//! for a terminal, or as an answer key in Markdown.

mod columns;
mod markdown;
mod text;

use std::ops::ControlFlow;

use crate::{
    figure::{Run, WatchRow, WatchSection, mark_changes},
    input::Given,
    text::{Catalog, Message, Value},
    trace::Counts,
};

use super::{Case, Detail, Id, Numbers, Refused, refusal::short};

use columns::Cell;

/// What is told of one case, whatever it is written as.
pub(super) struct Report<'c> {
    catalog: &'c Catalog,
    /// How many cases came before it, and one.
    number: usize,
    name: String,
    /// Or why it is refused.
    solved: Result<Solved, String>,
}

struct Solved {
    algorithm: String,
    source: &'static str,
    /// Name and values of what is given.
    given: Vec<[String; 2]>,
    /// Number, decision, formulas and changes of each.
    steps: Option<Vec<[Cell; 4]>>,
    verdict: String,
    /// Name and number of each kind of operation, and of all together.
    cost: [[String; 2]; 5],
}

/// Over the columns of [`Solved::steps`].
const STEP_HEAD: [&str; 4] = [
    "report-step",
    "report-what",
    "report-formula",
    "report-changed",
];

impl<'c> Report<'c> {
    pub(super) fn new(
        number: usize,
        case: &Result<Case, Refused>,
        told: &[Given],
        detail: Detail,
        catalog: &'c Catalog,
    ) -> Self {
        let (id, solved) = match case {
            Ok(case) => (&case.id, Ok(Solved::new(case, told, detail, catalog))),
            Err(refused) => (&refused.id, Err(refused.refusal.sentence(catalog))),
        };
        Self {
            catalog,
            number,
            name: case_name(number, id, catalog),
            solved,
        }
    }
}

impl Solved {
    fn new(case: &Case, told: &[Given], detail: Detail, catalog: &Catalog) -> Self {
        let has_steps = detail == Detail::Steps;
        let Counts { add, mul, div, cmp } = case.problem.counts();
        let cost = [
            ("cost-additions", add),
            ("cost-multiplications", mul),
            ("cost-divisions", div),
            ("cost-comparisons", cmp),
            ("cost-total", add + mul + div + cmp),
        ];
        Self {
            algorithm: catalog.term(case.solver.card.name_key),
            source: case.solver.card.source,
            given: told.iter().map(|given| given_row(given, catalog)).collect(),
            steps: has_steps.then(|| step_rows(&*case.problem.run(), case.solver.numbers, catalog)),
            verdict: catalog.message(&case.problem.verdict()),
            cost: cost.map(|(key, n)| [catalog.term(key), n.to_string()]),
        }
    }
}

/// A case that was refused, for those who keep count.
#[derive(Clone, Copy, Debug)]
pub struct Refusing<'a> {
    /// The line that it stands in, from 1; empty lines count.
    pub line: usize,
    /// How many cases came before it, and one.
    pub number: usize,
    /// Which, and why.
    pub refused: &'a Refused,
}

impl Refusing<'_> {
    /// Where it stands, which it is, and why it is refused, for people.
    #[must_use]
    pub fn sentence(&self, catalog: &Catalog) -> String {
        let case = case_name(self.number, &self.refused.id, catalog);
        let message = Message::new("trace-refused-at")
            .with("line", self.line)
            .with("case", case.to_lowercase())
            .with("problem", self.refused.refusal.sentence(catalog));
        catalog.message(&message)
    }
}

/// The problem's statement at step 0 first. Arithmetic that leaves the range of f64 on its way is left out.
fn step_rows(run: &dyn Run, numbers: Numbers, catalog: &Catalog) -> Vec<[Cell; 4]> {
    let is_told = |value: &Value| value.is_all(|x| numbers.have(x));
    let (mut rows, mut before) = (Vec::new(), None);
    run.visit([0, run.n_steps()], &mut |step, shown| {
        let (caption, mut watch) = (shown.caption(), shown.watch());
        if let Some(before) = &before {
            mark_changes(&mut watch, before);
        }
        let changed = watch.iter().flat_map(|section| {
            let rows = section.rows.iter().filter(|row| row.has_changed());
            rows.filter_map(|row| changed_row(section, row, is_told, catalog))
        });
        let arithmetic = caption.arithmetic.iter();
        rows.push([
            vec![step.to_string()],
            vec![catalog.message(&caption.decision)],
            arithmetic
                .filter(|f| is_told(&Value::Formula((*f).clone())))
                .map(|f| catalog.formula(f))
                .collect(),
            changed.collect(),
        ]);
        before = Some(watch);
        ControlFlow::Continue(())
    });
    rows
}

/// `code₁ = 0001 (to the left)`, or `left edge: p = −4, q = −1, r = 1/4`.
fn changed_row(
    section: &WatchSection,
    row: &WatchRow,
    is_told: impl Fn(&Value) -> bool,
    catalog: &Catalog,
) -> Option<String> {
    if row.cells.iter().flatten().any(|cell| !is_told(cell)) {
        return None;
    }
    let name = catalog.value(&row.name);
    let said = |cell: &Option<Value>| cell.as_ref().map(|cell| catalog.value(cell));
    let cells = row.cells.iter().map(said);
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
    Some(text)
}

/// "Case 3", or "Case 3 (id)".
fn case_name(number: usize, id: &Id, catalog: &Catalog) -> String {
    let message = match id.name() {
        None => Message::new("report-case"),
        Some(id) => Message::new("report-case-id").with("id", short(&id)),
    };
    catalog.message(&message.with("number", number))
}

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
