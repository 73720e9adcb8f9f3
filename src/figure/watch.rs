//! The watch table: the values that are alive at a step.

use crate::text::Value;

use super::{role::Link, view::ViewId};

#[derive(Clone, PartialEq, Debug)]
pub struct WatchRow {
    pub name: Value,
    pub cells: Vec<Option<Value>>,
    pub note: Option<Value>,
    /// Of each cell: did it change at this step? Empty where none did.
    pub changed: Vec<bool>,
    pub link: Option<Link>,
}

impl WatchRow {
    pub fn new(name: impl Into<Value>, cell: Option<Value>) -> Self {
        Self::table(name, vec![cell])
    }

    pub fn table(name: impl Into<Value>, cells: Vec<Option<Value>>) -> Self {
        Self {
            name: name.into(),
            cells,
            note: None,
            changed: Vec::new(),
            link: None,
        }
    }

    pub fn has_changed(&self) -> bool {
        self.changed.contains(&true)
    }

    pub fn noted(mut self, note: impl Into<Value>) -> Self {
        self.note = Some(note.into());
        self
    }

    pub fn linked(mut self, link: impl Into<Link>) -> Self {
        self.link = Some(link.into());
        self
    }
}

#[derive(Clone, PartialEq, Debug, Default)]
pub struct WatchSection {
    /// Titles of the columns, one of them for the names where there is one more; empty for a plain list of names and values.
    pub header: Vec<Value>,
    pub rows: Vec<WatchRow>,
    /// The view that shows these values: the inspector leaves them out, an answer key tells them all the same.
    pub seen_in: Option<ViewId>,
    /// Where its rows stand in a list of which they are a part; none where they are all of it.
    pub part: Option<ListPart>,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ListPart {
    pub first: usize,
    pub of: usize,
}

impl WatchSection {
    pub const fn list(rows: Vec<WatchRow>) -> Self {
        Self::titled(Vec::new(), rows)
    }

    pub fn table(header: Vec<&'static str>, rows: Vec<WatchRow>) -> Self {
        let symbol = |symbol: &str| Value::Name(symbol.to_owned());
        Self::titled(header.into_iter().map(symbol).collect(), rows)
    }

    pub const fn titled(header: Vec<Value>, rows: Vec<WatchRow>) -> Self {
        Self {
            header,
            rows,
            seen_in: None,
            part: None,
        }
    }

    pub const fn part(mut self, first: usize, of: usize) -> Self {
        self.part = Some(ListPart { first, of });
        self
    }

    fn is_new(&self, row_idx: usize, before: Option<&Self>) -> bool {
        let place = self.part.map_or(0, |part| part.first) + row_idx;
        match before {
            // All of a list has begun; a part that shares no row with what was seen is another page of it.
            None => self.part.is_none_or(|part| part.of == self.rows.len()),
            Some(before) => before.part.is_none_or(|part| place >= part.of),
        }
    }

    pub const fn seen_in(mut self, view: &'static str) -> Self {
        self.seen_in = Some(ViewId(view));
        self
    }
}

pub type Watch = Vec<WatchSection>;

pub fn unseen(watch: &Watch) -> Watch {
    let unseen = |section: &&WatchSection| section.seen_in.is_none();
    watch.iter().filter(unseen).cloned().collect()
}

/// Marks the cells that differ from the step before: those of a row of the same name, under the same header.
pub fn mark_changes(now: &mut Watch, before: &Watch) {
    for section in now {
        let same = || before.iter().filter(|old| old.header == section.header);
        let was = |row: &WatchRow| {
            let mut olds = same().flat_map(|section| &section.rows);
            olds.find(|old| old.name == row.name)
        };
        let old = same().find(|old| {
            let mut rows = old.rows.iter();
            rows.any(|old| section.rows.iter().any(|row| row.name == old.name))
        });
        let changed = section.rows.iter().enumerate().map(|(i, row)| {
            let was = was(row);
            let is_new = was.is_none() && section.is_new(i, old);
            let cells = row.cells.iter().enumerate();
            let has_changed = |(i, cell): (usize, &Option<Value>)| {
                let differs = was.map_or(is_new, |was| was.cells.get(i) != Some(cell));
                cell.is_some() && differs
            };
            cells.map(has_changed).collect()
        });
        let changed: Vec<Vec<bool>> = changed.collect();
        for (row, changed) in section.rows.iter_mut().zip(changed) {
            row.changed = changed;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn list(names: &[&'static str]) -> WatchSection {
        let row = |name: &&'static str| {
            WatchRow::new(Value::Name((*name).to_owned()), Some(Value::Count(1)))
        };
        WatchSection::list(names.iter().map(row).collect())
    }

    fn changed(now: WatchSection, before: &WatchSection) -> Vec<usize> {
        let mut watch = vec![now];
        mark_changes(&mut watch, &vec![before.clone()]);
        let rows = watch[0].rows.iter().enumerate();
        let changed = rows.filter(|(_, row)| row.has_changed());
        changed.map(|(i, _)| i).collect()
    }

    #[test]
    fn only_the_cells_that_differ_are_marked() {
        let row = |cells: [usize; 2]| {
            let cells = cells.map(|n| Some(Value::Count(n)));
            let row = WatchRow::table(Value::Name("left".to_owned()), cells.to_vec());
            vec![WatchSection::table(vec!["p", "q"], vec![row])]
        };
        let mut now = row([1, 3]);
        mark_changes(&mut now, &row([1, 2]));
        assert_eq!(now[0].rows[0].changed, [false, true]);
        mark_changes(&mut now, &row([1, 3]));
        // The last step did not change it.
        assert!(!now[0].rows[0].has_changed());
    }

    #[test]
    fn what_comes_into_sight_is_not_new() {
        let before = list(&["V1", "V2", "V3"]).part(0, 4);
        for (now, before, new) in [
            (list(&["V2", "V3", "V4"]).part(1, 4), &before, vec![]),
            (list(&["V3", "V4", "V5"]).part(2, 5), &before, vec![2]),
            // The first of all.
            (list(&["V1"]).part(0, 1), &list(&[]).part(0, 0), vec![0]),
            // Another page.
            (list(&["V7", "V8"]).part(6, 9), &before, vec![]),
            // All of a list.
            (list(&["V1", "V4"]), &list(&["V1"]), vec![1]),
        ] {
            assert_eq!(changed(now.clone(), before), new, "{now:?}");
        }
    }
}
