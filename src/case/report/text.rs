//! A case for a terminal.

use std::io::{self, Write};

use unicode_width::UnicodeWidthStr;

use super::{
    Report, STEP_HEAD,
    columns::{Align, Cell, set},
};

/// Half a wide screen, and the whole of a narrow one.
const WIDTH: usize = 100;

impl Report {
    /// With an empty line after it.
    pub fn write_text(self, out: &mut impl Write) -> io::Result<()> {
        let term = |key| self.catalog.term(key);
        writeln!(out, "{} · {}", self.name, self.algorithm)?;
        let given = self.given.into_iter().map(cells).collect();
        put(set(given, [Align::Left; 2], WIDTH), out)?;
        writeln!(out)?;
        if let Some(mut steps) = self.steps {
            steps.insert(0, STEP_HEAD.map(|key| vec![term(key)]));
            put_ruled(steps, out)?;
            writeln!(out)?;
        }
        let answer = [term("report-answer"), self.verdict];
        put(set(vec![cells(answer)], [Align::Left; 2], WIDTH), out)?;
        let cost = self.cost.map(cells).to_vec();
        put(set(cost, [Align::Left, Align::Right], WIDTH), out)?;
        writeln!(out)
    }
}

fn cells<const N: usize>(texts: [String; N]) -> [Cell; N] {
    texts.map(|text| vec![text])
}

fn put(lines: impl Iterator<Item = String>, out: &mut impl Write) -> io::Result<()> {
    for line in lines {
        writeln!(out, "{line}")?;
    }
    Ok(())
}

/// The table of steps, a rule under its head, as wide as what follows.
fn put_ruled(rows: Vec<[Cell; 4]>, out: &mut impl Write) -> io::Result<()> {
    let align = [Align::Right, Align::Left, Align::Left, Align::Left];
    let mut lines = set(rows, align, WIDTH);
    let head = lines.next().unwrap_or_default();
    let (mut width, mut rest) = (head.width(), String::new());
    for line in lines {
        width = width.max(line.width());
        rest += &line;
        rest.push('\n');
    }
    write!(out, "{head}\n{}\n{rest}", "─".repeat(width))
}
