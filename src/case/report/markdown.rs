//! A case as a page of an answer key.

use std::io::{self, Write};

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
        write!(out, "## {} · {}\n\n", escaped(&self.name), self.algorithm)?;
        let source = [term("report-source"), self.source.to_owned()];
        for [name, values] in self.given.iter().chain([&source]) {
            writeln!(out, "- **{}** · {}", capitalised(name), escaped(values))?;
        }
        writeln!(out)?;
        if let Some(steps) = &self.steps {
            let head = STEP_HEAD.map(|key| capitalised(&term(key)));
            let rows = steps.iter().map(|row| row.each_ref().map(lines));
            write_table(&head, ["---:", "---", "---", "---"], rows, out)?;
        }
        let verdict = escaped(&self.verdict);
        write!(out, "**{}** {verdict}\n\n", term("report-answer"))?;
        let head = [capitalised(&term("panel-cost")), String::new()];
        let cost = self.cost.iter().cloned();
        write_table(&head, ["---", "---:"], cost, out)
    }
}

fn lines(cell: &Cell) -> String {
    let lines: Vec<String> = cell.iter().map(|line| escaped(line)).collect();
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
