//! A case as a page of an answer key.

use std::fmt::Write;

use super::{Report, STEP_HEAD, Solved, columns::Cell};

impl Report<'_> {
    /// Before the first one stands the title of the whole.
    pub fn markdown(&self) -> String {
        let mut page = String::new();
        if self.number == 1 {
            let title = self.catalog.term("report-title");
            paragraph(&mut page, &format!("# {title}"));
        }
        let name = escaped(&self.name);
        match &self.solved {
            Ok(solved) => {
                paragraph(&mut page, &format!("## {name} · {}", solved.algorithm));
                self.solved_markdown(solved, &mut page);
            }
            Err(said) => {
                paragraph(&mut page, &format!("## {name}"));
                let label = self.catalog.term("report-refused");
                paragraph(&mut page, &format!("> **{label}** {}", escaped(said)));
            }
        }
        page
    }

    fn solved_markdown(&self, solved: &Solved, page: &mut String) {
        let term = |key| self.catalog.term(key);
        let source = [term("report-source"), solved.source.to_owned()];
        let list: Vec<String> = solved
            .given
            .iter()
            .chain([&source])
            .map(|[name, values]| format!("- **{}** · {}", capitalised(name), escaped(values)))
            .collect();
        paragraph(page, &list.join("\n"));
        if let Some(steps) = &solved.steps {
            let head = STEP_HEAD.map(|key| capitalised(&term(key)));
            let rows = steps.iter().map(|row| row.each_ref().map(lines));
            table(page, &head, ["---:", "---", "---", "---"], rows);
        }
        let verdict = escaped(&solved.verdict);
        paragraph(page, &format!("**{}** {verdict}", term("report-answer")));
        let head = [capitalised(&term("panel-cost")), String::new()];
        let cost = solved.cost.iter().cloned();
        table(page, &head, ["---", "---:"], cost);
    }
}

fn lines(cell: &Cell) -> String {
    let lines: Vec<String> = cell.iter().map(|line| escaped(line)).collect();
    lines.join("<br>")
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
