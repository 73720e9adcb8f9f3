//! A case for a terminal.

use unicode_width::UnicodeWidthStr;

use crate::{
    case::{Case, Detail, Refused},
    input::Given,
    text::Catalog,
};

use super::{
    case_name,
    columns::{Align, Cell, set},
    cost_rows, given_row, step_rows,
};

/// Half a wide screen, and the whole of a narrow one.
const WIDTH: usize = 100;

/// One case, with an empty line after it.
pub fn text(
    number: usize,
    case: &Result<Case, Refused>,
    told: &[Given],
    detail: Detail,
    catalog: &Catalog,
) -> String {
    let lines = match case {
        Ok(case) => solved(number, case, told, detail, catalog),
        Err(refused) => {
            let said = refused.refusal.sentence(catalog);
            let refused_term = catalog.term("report-refused");
            let row = [
                vec![case_name(number, &refused.id, catalog)],
                vec![refused_term],
                vec![said],
            ];
            set(&[row], [Align::Left; 3], WIDTH)
        }
    };
    lines.join("\n") + "\n\n"
}

fn solved(
    number: usize,
    case: &Case,
    told: &[Given],
    detail: Detail,
    catalog: &Catalog,
) -> Vec<String> {
    let name = case_name(number, &case.id, catalog);
    let mut lines = vec![format!("{name} · {}", catalog.term(case.solver.name_key()))];
    let rows: Vec<[Cell; 2]> = told
        .iter()
        .map(|given| given_row(given, catalog).map(|text| vec![text]))
        .collect();
    lines.extend(set(&rows, [Align::Left; 2], WIDTH));
    lines.push(String::new());
    if detail == Detail::Steps {
        lines.extend(steps(case, catalog));
        lines.push(String::new());
    }
    let answer = [
        vec![catalog.term("report-answer")],
        vec![catalog.message(&case.problem.verdict())],
    ];
    lines.extend(set(&[answer], [Align::Left; 2], WIDTH));
    let (_, counts) = case.problem.cost();
    let cost = cost_rows(counts, catalog).map(|row| row.map(|text| vec![text]));
    lines.extend(set(&cost, [Align::Left, Align::Right], WIDTH));
    lines
}

/// The table of steps, a rule under its head.
fn steps(case: &Case, catalog: &Catalog) -> Vec<String> {
    let head = [
        "report-step",
        "report-what",
        "report-formula",
        "report-changed",
    ];
    let mut rows: Vec<[Cell; 4]> = vec![head.map(|key| vec![catalog.term(key)])];
    let run = case.problem.run();
    rows.extend(step_rows(run.as_ref(), catalog).into_iter().map(|row| {
        let step = vec![row.step.to_string()];
        [step, vec![row.decision], row.formulas, row.changed]
    }));
    let align = [Align::Right, Align::Left, Align::Left, Align::Left];
    let mut lines = set(&rows, align, WIDTH);
    let width = lines.iter().map(|line| line.width()).max().unwrap_or(0);
    lines.insert(1, "─".repeat(width));
    lines
}
