//! A case for a terminal.

use unicode_width::UnicodeWidthStr;

use super::{
    Report, STEP_HEAD, Solved,
    columns::{Align, Cell, set},
};

/// Half a wide screen, and the whole of a narrow one.
const WIDTH: usize = 100;

impl Report<'_> {
    /// With an empty line after it.
    pub fn text(&self) -> String {
        let lines = match &self.solved {
            Ok(solved) => self.solved_text(solved),
            Err(said) => {
                let row = [&self.name, &self.catalog.term("report-refused"), said];
                set(&[cells(row)], [Align::Left; 3], WIDTH)
            }
        };
        lines.join("\n") + "\n\n"
    }

    fn solved_text(&self, solved: &Solved) -> Vec<String> {
        let mut lines = vec![format!("{} · {}", self.name, solved.algorithm)];
        let given = solved.given.iter().map(|row| cells(row.each_ref()));
        let given: Vec<_> = given.collect();
        lines.extend(set(&given, [Align::Left; 2], WIDTH));
        lines.push(String::new());
        if let Some(steps) = &solved.steps {
            let head = STEP_HEAD.map(|key| vec![self.catalog.term(key)]);
            lines.extend(ruled(&[&[head], &steps[..]].concat()));
            lines.push(String::new());
        }
        let answer = [&self.catalog.term("report-answer"), &solved.verdict];
        lines.extend(set(&[cells(answer)], [Align::Left; 2], WIDTH));
        let cost = solved.cost.each_ref().map(|row| cells(row.each_ref()));
        lines.extend(set(&cost, [Align::Left, Align::Right], WIDTH));
        lines
    }
}

fn cells<const N: usize>(texts: [&String; N]) -> [Cell; N] {
    texts.map(|text| vec![text.clone()])
}

/// The table of steps, a rule under its head.
fn ruled(rows: &[[Cell; 4]]) -> Vec<String> {
    let align = [Align::Right, Align::Left, Align::Left, Align::Left];
    let mut lines = set(rows, align, WIDTH);
    let width = lines.iter().map(|line| line.width()).max().unwrap_or(0);
    lines.insert(1, "─".repeat(width));
    lines
}
