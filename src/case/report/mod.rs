//! Cases for people: what is given, every step with its arithmetic, the answer and what it cost. As a table
//! for a terminal, as an answer key in Markdown, or with blanks as a worksheet.

mod columns;
mod markdown;
mod sheet;
mod steps;
mod text;

use crate::{
    figure::Run,
    input::Given,
    text::{Alike, Catalog, Message, Said},
    trace::Counts,
};

use super::{Case, Detail, Id, Numbers, Refused, refusal::short};

use columns::Cell;
use sheet::BLANK;

pub(super) use sheet::Sheet;

/// What is told of one case, whatever it is written as.
pub(super) struct Report {
    catalog: &'static Catalog,
    sheet: Sheet,
    name: String,
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

/// Over the columns of [`Report::steps`].
const STEP_HEAD: [&str; 4] = [
    "report-step",
    "report-what",
    "report-formula",
    "report-changed",
];

/// A run to be worked out on paper.
pub struct Worksheet {
    /// Over its columns.
    pub head: [String; 4],
    /// Number, decision, formulas and changes of each step, or room for them: paragraphs of each.
    pub rows: Vec<[Vec<String>; 4]>,
}

/// With the answers, or with blanks in their place.
pub fn worksheet(run: &dyn Run, is_answered: bool, catalog: &Catalog) -> Worksheet {
    let numbers = Numbers::OrInfinite;
    let mut alike = Alike::default();
    steps::see(run, numbers, &mut alike);
    let catalog = catalog.alike(alike.notation());
    let sheet = if is_answered {
        Sheet::Answers
    } else {
        Sheet::Questions
    };
    Worksheet {
        head: STEP_HEAD.map(|key| catalog.term(key)),
        rows: steps::rows(run, numbers, sheet, catalog),
    }
}

impl Report {
    /// `number` is how many cases came before it, and one.
    pub(super) fn new(
        number: usize,
        case: &Case,
        told: &[Given],
        (detail, sheet): (Detail, Sheet),
        catalog: &Catalog,
    ) -> Self {
        let Case {
            problem, solver, ..
        } = case;
        let run = (detail == Detail::Steps).then(|| problem.run());
        let verdict = problem.verdict();
        let mut alike = Alike::default();
        let given = told.iter().flat_map(|given| &given.values).map(Said::Value);
        let said = given.chain([Said::Message(&verdict)]);
        said.for_each(|said| alike.see(said));
        if let Some(run) = &run {
            steps::see(&**run, solver.numbers, &mut alike);
        }
        let catalog = catalog.alike(alike.notation());
        let Counts { add, mul, div, cmp } = problem.counts();
        let cost = [
            ("cost-additions", add),
            ("cost-multiplications", mul),
            ("cost-divisions", div),
            ("cost-comparisons", cmp),
            ("cost-total", add + mul + div + cmp),
        ];
        let found = |answer: String| match sheet {
            Sheet::Answers => answer,
            Sheet::Questions => BLANK.to_owned(),
        };
        let symbols = solver.symbols_key.filter(|_| run.is_some());
        let symbols = symbols.map(|key| [catalog.term("report-symbols"), catalog.term(key)]);
        let given = told.iter().map(|given| given_row(given, catalog));
        Self {
            catalog,
            sheet,
            name: case_name(number, &case.heading.id, catalog),
            algorithm: catalog.term(solver.card.name_key),
            source: solver.card.source,
            given: given.chain(symbols).collect(),
            steps: run.map(|run| steps::rows(&*run, solver.numbers, sheet, catalog)),
            verdict: found(catalog.message(&verdict)),
            cost: cost.map(|(key, n)| [catalog.term(key), found(n.to_string())]),
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
        let case = case_name(self.number, &self.refused.heading.id, catalog);
        let message = Message::new("trace-refused-at")
            .with("line", self.line)
            .with("case", case.to_lowercase())
            .with("problem", self.refused.refusal.sentence(catalog));
        catalog.message(&message)
    }
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
