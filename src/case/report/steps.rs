//! The steps of a case: what each decides, its formulas, and the values that it changes.

use std::ops::ControlFlow;

use crate::{
    case::Numbers,
    figure::{Choice, Run, WatchRow, WatchSection, mark_changes},
    text::{Alike, Catalog, Formula, Message, Said, Value},
};

use super::{
    columns::Cell,
    sheet::{BLANK, Sheet},
};

/// A step as it is told. Arithmetic that leaves the range of f64 on its way is left out.
struct Told<'a> {
    nth: usize,
    decision: &'a Message,
    formulas: Vec<&'a Formula>,
    changed: Vec<Changed<'a>>,
    options: Option<Choice>,
}

/// Of a row of the watch table the cells that the step has changed, each with what stands over it.
struct Changed<'a> {
    name: &'a Value,
    cells: Vec<(Option<&'a Value>, &'a Value)>,
    note: Option<&'a Value>,
}

/// Shows every step, the problem's statement at step 0 first.
fn visit(run: &dyn Run, numbers: Numbers, look: &mut dyn FnMut(&Told<'_>)) {
    let is_told = |value: &Value| value.is_all(|x| numbers.have(x));
    let mut before = None;
    run.visit([0, run.n_steps()], &mut |nth, shown| {
        let (caption, mut watch) = (shown.caption(), shown.watch());
        if let Some(before) = &before {
            mark_changes(&mut watch, before);
        }
        let rows = watch.iter();
        let rows = rows.flat_map(|section| section.rows.iter().map(move |row| (section, row)));
        let changed = rows.filter_map(|(section, row)| Changed::of(section, row));
        let formulas = caption.arithmetic.iter();
        look(&Told {
            nth,
            decision: &caption.decision,
            formulas: formulas
                .filter(|f| is_told(&Value::Formula((*f).clone())))
                .collect(),
            changed: changed
                .filter(|it| it.cells.iter().all(|(_, cell)| is_told(cell)))
                .collect(),
            options: shown.options(),
        });
        before = Some(watch);
        ControlFlow::Continue(())
    });
}

/// Sees the numbers of all steps.
pub(super) fn see(run: &dyn Run, numbers: Numbers, alike: &mut Alike) {
    visit(run, numbers, &mut |step| {
        alike.see(Said::Message(step.decision));
        step.formulas
            .iter()
            .for_each(|it| alike.see(Said::Formula(it)));
        let values = step.changed.iter().flat_map(Changed::values);
        values.for_each(|value| alike.see(Said::Value(value)));
    });
}

/// Number, decision, formulas and changes of each, or room for them.
pub(super) fn rows(
    run: &dyn Run,
    numbers: Numbers,
    sheet: Sheet,
    catalog: &Catalog,
) -> Vec<[Cell; 4]> {
    let mut rows = Vec::new();
    visit(run, numbers, &mut |step| {
        // The statement is not asked for.
        let is_told = sheet == Sheet::Answers || step.nth == 0;
        let [what, formulas, changed] = if is_told {
            step.told(catalog)
        } else {
            step.asked(catalog)
        };
        rows.push([vec![step.nth.to_string()], what, formulas, changed]);
    });
    rows
}

impl Told<'_> {
    fn told(&self, catalog: &Catalog) -> [Cell; 3] {
        let formulas = self.formulas.iter().map(|it| catalog.formula(it));
        let changed = self.changed.iter();
        let value = |cell: &Value| catalog.value(cell);
        let changed = changed.map(|it| it.noted(it.with(value, catalog), catalog));
        let decision = vec![catalog.message(self.decision)];
        [decision, formulas.collect(), changed.collect()]
    }

    /// What might come, each with a box to tick: then names of what is worked out would tell what does. Else these names.
    fn asked(&self, catalog: &Catalog) -> [Cell; 3] {
        let line = || BLANK.to_owned();
        let options = self.options.as_ref().map(|it| it.said(catalog));
        if let Some(options) = options.filter(|it| it.len() > 1) {
            let boxes = options.iter().map(|option| format!("☐ {option}"));
            let room = |is_empty: bool| (!is_empty).then(line).into_iter().collect();
            let [formulas, changed] = [self.formulas.is_empty(), self.changed.is_empty()];
            return [boxes.collect(), room(formulas), room(changed)];
        }
        let formulas = self.formulas.iter().map(|it| asked(&catalog.formula(it)));
        let changed = self.changed.iter().map(|it| it.with(|_| line(), catalog));
        [vec![line()], formulas.collect(), changed.collect()]
    }
}

/// `y = …`: what is worked out; of a formula that begins with anything but a name nothing but room for it.
fn asked(formula: &str) -> String {
    let relations = ['=', '≈', '<', '>', '≤', '≥', '≠'];
    let name = formula
        .split_once(relations)
        .map(|(name, _)| name.trim_end());
    let is_name = |name: &&str| !name.contains(|c: char| c.is_ascii_digit());
    let is_equal = |name: &&str| formula[name.len()..].trim_start().starts_with(['=', '≈']);
    match name.filter(is_name).filter(is_equal) {
        Some(name) => format!("{name} = {BLANK}"),
        None => BLANK.to_owned(),
    }
}

impl<'a> Changed<'a> {
    fn of(section: &'a WatchSection, row: &'a WatchRow) -> Option<Self> {
        let cells = row.cells.iter().zip(&row.changed).enumerate();
        let cells = cells.filter_map(|(i, (cell, has_changed))| {
            let cell = cell.as_ref().filter(|_| *has_changed)?;
            Some((section.header.get(i), cell))
        });
        let cells: Vec<_> = cells.collect();
        (!cells.is_empty()).then_some(Self {
            name: &row.name,
            cells,
            note: row.note.as_ref(),
        })
    }

    fn values(&self) -> impl Iterator<Item = &'a Value> {
        let cells = self.cells.iter().map(|(_, cell)| *cell);
        cells.chain([self.name]).chain(self.note)
    }

    /// `code₁ = 0001`, or `left edge: p = −4, q = −1, r = 1/4`.
    fn with(&self, said: impl Fn(&Value) -> String, catalog: &Catalog) -> String {
        let name = catalog.value(self.name);
        let cells = self.cells.iter().map(|(head, cell)| match head {
            Some(head) => format!("{} = {}", catalog.value(head), said(cell)),
            None => said(cell),
        });
        let values: Vec<String> = cells.collect();
        let values = values.join(catalog.lang().list_separator());
        if self.cells.iter().all(|(head, _)| head.is_none()) {
            return format!("{name} = {values}");
        }
        let row = Message::new("report-row").with("name", name);
        catalog.message(&row.with("values", values))
    }

    /// "≠ 0" goes on with the equation, "= 0" would say it twice, and a word on the value stands aside.
    fn noted(&self, text: String, catalog: &Catalog) -> String {
        match self.note.map(|note| catalog.value(note)) {
            Some(note) if note.starts_with('≠') => format!("{text} {note}"),
            Some(note) if !note.starts_with('=') => {
                let noted = Message::new("report-noted").with("value", text);
                catalog.message(&noted.with("note", note))
            }
            Some(_) | None => text,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_worked_out_is_asked_for_by_its_name() {
        for (formula, expected) in [
            ("y = (0 · 2 + 0 · 1) / 3 = 0", "y = …………"),
            ("V₁: x = 0 ≥ −1", "V₁: x = …………"),
            ("a₁ = 2 > 0 > −4 = a₂", "a₁ = …………"),
            ("−1 ≤ y = 0 ≤ 1", BLANK),
            ("0001 OR 0010 = 0011", BLANK),
            ("t < u", BLANK),
        ] {
            assert_eq!(asked(formula), expected);
        }
    }
}
