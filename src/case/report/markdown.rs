//! A case as a page of an answer key.

use std::fmt::Write;

use crate::{
    case::{Case, Detail, Refused},
    input::Given,
    text::Catalog,
};

use super::{StepRow, case_name, cost_rows, given_row, step_rows};

/// One case; before the first one the title of the whole.
pub fn markdown(
    number: usize,
    case: &Result<Case, Refused>,
    told: &[Given],
    detail: Detail,
    catalog: &Catalog,
) -> String {
    let mut page = String::new();
    if number == 1 {
        paragraph(&mut page, &format!("# {}", catalog.term("report-title")));
    }
    match case {
        Ok(case) => {
            let name = escaped(&case_name(number, &case.id, catalog));
            solved(&mut page, &name, case, told, detail, catalog);
        }
        Err(refused) => {
            let name = escaped(&case_name(number, &refused.id, catalog));
            paragraph(&mut page, &format!("## {name}"));
            let said = escaped(&refused.refusal.sentence(catalog));
            let label = catalog.term("report-refused");
            paragraph(&mut page, &format!("> **{label}** {said}"));
        }
    }
    page
}

fn solved(
    page: &mut String,
    name: &str,
    case: &Case,
    told: &[Given],
    detail: Detail,
    catalog: &Catalog,
) {
    let algorithm = catalog.term(case.solver.name_key());
    paragraph(page, &format!("## {name} · {algorithm}"));
    let rows = told.iter().map(|given| given_row(given, catalog));
    let mut rows: Vec<[String; 2]> = rows.collect();
    rows.push([
        catalog.term("report-source"),
        case.solver.source().to_owned(),
    ]);
    let list: Vec<String> = rows
        .iter()
        .map(|[name, values]| format!("- **{}** · {}", capitalised(name), escaped(values)))
        .collect();
    paragraph(page, &list.join("\n"));
    if detail == Detail::Steps {
        let run = case.problem.run();
        let head = [
            "report-step",
            "report-what",
            "report-formula",
            "report-changed",
        ]
        .map(|key| capitalised(&catalog.term(key)));
        let rows = step_rows(run.as_ref(), catalog).into_iter().map(step_cells);
        table(page, &head, ["---:", "---", "---", "---"], rows);
    }
    let verdict = escaped(&catalog.message(&case.problem.verdict()));
    paragraph(
        page,
        &format!("**{}** {verdict}", catalog.term("report-answer")),
    );
    let (_, counts) = case.problem.cost();
    let head = [capitalised(&catalog.term("panel-cost")), String::new()];
    table(
        page,
        &head,
        ["---", "---:"],
        cost_rows(counts, catalog).into_iter(),
    );
}

fn step_cells(row: StepRow) -> [String; 4] {
    let lines = |lines: Vec<String>| {
        let lines: Vec<String> = lines.iter().map(|line| escaped(line)).collect();
        lines.join("<br>")
    };
    [
        row.step.to_string(),
        escaped(&row.decision),
        lines(row.formulas),
        lines(row.changed),
    ]
}

fn table<const N: usize>(
    page: &mut String,
    head: &[String; N],
    rule: [&str; N],
    rows: impl Iterator<Item = [String; N]>,
) {
    let mut lines = vec![
        format!("| {} |", head.join(" | ")),
        format!("|{}|", rule.join("|")),
    ];
    lines.extend(rows.map(|row| format!("| {} |", row.join(" | "))));
    paragraph(page, &lines.join("\n"));
}

fn paragraph(page: &mut String, text: &str) {
    // Writing to a string does not fail.
    let _ = write!(page, "{text}\n\n");
}

/// Words of a table's head and of labels begin with a capital where the script has them.
fn capitalised(text: &str) -> String {
    let mut chars = text.chars();
    chars.next().map_or_else(String::new, |first| {
        first.to_uppercase().chain(chars).collect()
    })
}

/// Text in which nothing is markup. What is none is left alone, so that the page can be read as it is.
fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut before = ' ';
    let mut chars = text.chars().peekable();
    while let Some(c) = chars.next() {
        let after = chars.peek().copied().unwrap_or(' ');
        let is_markup = match c {
            '\\' | '|' | '`' | '*' | '[' | ']' | '~' | '$' => true,
            '_' => !(before.is_alphanumeric() && after.is_alphanumeric()),
            '<' => !after.is_whitespace(),
            '&' => after.is_alphanumeric() || after == '#',
            _ => false,
        };
        if is_markup {
            out.push('\\');
        }
        out.push(c);
        before = c;
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_given_is_taken_for_markup() {
        assert_eq!(
            escaped("a|b *c* <d> &lt; `e`"),
            r"a\|b \*c\* \<d> \&lt; \`e\`"
        );
        assert_eq!(escaped("u_min < u_max & _x_"), r"u_min < u_max & \_x\_");
        assert_eq!(capitalised("étape"), "Étape");
    }
}
