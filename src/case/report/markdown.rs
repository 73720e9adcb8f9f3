//! A case as a page of an answer key.

use std::io::{self, Write};

use crate::text::as_markdown;

use super::{Report, STEP_HEAD, columns::Cell, sheet::Sheet};

impl Report {
    /// The title of the whole, and of a worksheet what is to be done.
    pub fn write_title(&self, out: &mut impl Write) -> io::Result<()> {
        let term = |key| self.catalog.term(key);
        match self.sheet {
            Sheet::Answers => write!(out, "# {}\n\n", term("report-title")),
            Sheet::Questions => {
                let [title, how] = ["worksheet-title", "worksheet-how"].map(term);
                write!(out, "# {title}\n\n{how}\n\n")
            }
        }
    }

    pub fn write_markdown(&self, out: &mut impl Write) -> io::Result<()> {
        let term = |key| self.catalog.term(key);
        write!(
            out,
            "## {} · {}\n\n",
            as_markdown(&self.name),
            self.algorithm
        )?;
        let source = [term("report-source"), self.source.to_owned()];
        for [name, values] in self.given.iter().chain([&source]) {
            writeln!(out, "- **{}** · {}", capitalised(name), as_markdown(values))?;
        }
        writeln!(out)?;
        if let Some(steps) = &self.steps {
            let head = STEP_HEAD.map(|key| capitalised(&term(key)));
            let rows = steps.iter().map(|row| row.each_ref().map(lines));
            write_table(&head, ["---:", "---", "---", "---"], rows, out)?;
        }
        let verdict = as_markdown(&self.verdict);
        write!(out, "**{}** {verdict}\n\n", term("report-answer"))?;
        let head = [capitalised(&term("panel-cost")), String::new()];
        let cost = self.cost.iter().cloned();
        write_table(&head, ["---", "---:"], cost, out)
    }
}

fn lines(cell: &Cell) -> String {
    let lines: Vec<String> = cell.iter().map(|line| as_markdown(line)).collect();
    lines.join("<br>")
}

fn write_table<const N: usize>(
    head: &[String; N],
    rule: [&str; N],
    rows: impl Iterator<Item = [String; N]>,
    out: &mut impl Write,
) -> io::Result<()> {
    writeln!(out, "| {} |\n|{}|", head.join(" | "), rule.join("|"))?;
    for row in rows {
        writeln!(out, "| {} |", row.join(" | "))?;
    }
    writeln!(out)
}

/// Words of a table's head and of labels begin with a capital where the script has them.
fn capitalised(text: &str) -> String {
    let mut chars = text.chars();
    chars.next().map_or_else(String::new, |first| {
        first.to_uppercase().chain(chars).collect()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_of_a_head_begin_with_a_capital() {
        assert_eq!(capitalised("étape"), "Étape");
    }
}
