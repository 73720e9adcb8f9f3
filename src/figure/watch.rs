//! The watch table: the values that are alive at a step.

use crate::text::Value;

use super::{role::Link, view::ViewId};

/// A row: a name and its values.
#[derive(Clone, PartialEq, Debug)]
pub struct WatchRow {
    /// `code₁`, `u_min`, or an edge's name.
    pub name: Value,
    /// One value, or one a column of the section's header.
    pub cells: Vec<Option<Value>>,
    /// A word on the value: "left", "≠ 0".
    pub note: Option<Value>,
    /// Of each cell: did it change at this step? Empty where none did.
    pub changed: Vec<bool>,
    /// What it is about.
    pub link: Option<Link>,
}

impl WatchRow {
    /// A name and one value.
    pub fn new(name: impl Into<Value>, cell: Option<Value>) -> Self {
        Self::table(name, vec![cell])
    }

    /// A name and several values.
    pub fn table(name: impl Into<Value>, cells: Vec<Option<Value>>) -> Self {
        Self {
            name: name.into(),
            cells,
            note: None,
            changed: Vec::new(),
            link: None,
        }
    }

    /// Did any of its cells change at this step?
    pub fn has_changed(&self) -> bool {
        self.changed.contains(&true)
    }

    /// With a word on the value.
    pub fn noted(mut self, note: impl Into<Value>) -> Self {
        self.note = Some(note.into());
        self
    }

    /// About `link`.
    pub fn linked(mut self, link: impl Into<Link>) -> Self {
        self.link = Some(link.into());
        self
    }
}

/// Rows that belong together.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct WatchSection {
    /// Titles of the columns, one of them for the names where there is one more; empty for a plain list of names and values.
    pub header: Vec<Value>,
    /// Top to bottom.
    pub rows: Vec<WatchRow>,
    /// The view that shows these values: the inspector leaves them out, an answer key tells them all the same.
    pub seen_in: Option<ViewId>,
    /// Where its rows stand in a list of which they are a part; none where they are all of it.
    pub part: Option<ListPart>,
}

/// Some entries of a longer list, which come into sight and leave it without being new.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ListPart {
    /// The place of the first of them.
    pub first: usize,
    /// How long the list is.
    pub of: usize,
}

impl WatchSection {
    /// A plain list.
    pub const fn list(rows: Vec<WatchRow>) -> Self {
        Self::titled(Vec::new(), rows)
    }

    /// A table whose columns are headed by symbols, the same in every language: `t`, `n·D`.
    pub fn table(header: Vec<&'static str>, rows: Vec<WatchRow>) -> Self {
        let symbol = |symbol: &str| Value::Name(symbol.to_owned());
        Self::titled(header.into_iter().map(symbol).collect(), rows)
    }

    /// A table whose columns are headed by words of the catalogue, or anything else that can be said.
    pub const fn titled(header: Vec<Value>, rows: Vec<WatchRow>) -> Self {
        Self {
            header,
            rows,
            seen_in: None,
            part: None,
        }
    }

    /// As a part of a list of `of` entries, from the one at `first`.
    pub const fn part(mut self, first: usize, of: usize) -> Self {
        self.part = Some(ListPart { first, of });
        self
    }

    /// Was the row at this place not there yet, in the section as it was before?
    fn is_new(&self, row_idx: usize, before: Option<&Self>) -> bool {
        let place = self.part.map_or(0, |part| part.first) + row_idx;
        match before {
            // All of a list has begun; a part that shares no row with what was seen is another page of it.
            None => self.part.is_none_or(|part| part.of == self.rows.len()),
            Some(before) => before.part.is_none_or(|part| place >= part.of),
        }
    }

    /// Shown in the view of this name.
    pub const fn seen_in(mut self, view: &'static str) -> Self {
        self.seen_in = Some(ViewId(view));
        self
    }
}

/// Sections from top to bottom.
pub type Watch = Vec<WatchSection>;

/// What stands in no view.
pub fn unseen(watch: &Watch) -> Watch {
    let unseen = |section: &&WatchSection| section.seen_in.is_none();
    watch.iter().filter(unseen).cloned().collect()
}

/// Marks the cells that differ from the step before: those of a row of the same name, under the same header.
pub fn mark_changes(now: &mut Watch, before: &Watch) {
    for section in now {
        let same = before.iter().filter(|old| old.header == section.header);
        let same: Vec<&WatchSection> = same.collect();
        let was = |row: &WatchRow| {
            let mut olds = same.iter().flat_map(|section| &section.rows);
            olds.find(|old| old.name == row.name)
        };
        let old = same.iter().copied().find(|old| {
            let mut rows = old.rows.iter();
            rows.any(|old| section.rows.iter().any(|row| row.name == old.name))
        });
        let changed: Vec<Vec<bool>> = section
            .rows
            .iter()
            .enumerate()
            .map(|(i, row)| {
                let was = was(row);
                let is_new = was.is_none() && section.is_new(i, old);
                let cells = row.cells.iter().enumerate();
                let has_changed = |(i, cell): (usize, &Option<Value>)| {
                    let differs = was.map_or(is_new, |was| was.cells.get(i) != Some(cell));
                    cell.is_some() && differs
                };
                cells.map(has_changed).collect()
            })
            .collect();
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

    fn changed(mut now: WatchSection, before: &WatchSection) -> Vec<usize> {
        let mut watch = vec![std::mem::take(&mut now)];
        mark_changes(&mut watch, &vec![before.clone()]);
        let rows = watch[0].rows.iter().enumerate();
        rows.filter(|(_, row)| row.has_changed())
            .map(|(i, _)| i)
            .collect()
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
        assert!(
            !now[0].rows[0].has_changed(),
            "the last step did not change it"
        );
    }

    #[test]
    fn what_comes_into_sight_is_not_new() {
        let before = list(&["V1", "V2", "V3"]).part(0, 4);
        assert_eq!(
            changed(list(&["V2", "V3", "V4"]).part(1, 4), &before),
            [0; 0]
        );
        let grown = list(&["V3", "V4", "V5"]).part(2, 5);
        assert_eq!(changed(grown, &before), [2], "V5 is new");
        let begun = list(&["V1"]).part(0, 1);
        assert_eq!(changed(begun, &list(&[]).part(0, 0)), [0], "the first");
        assert_eq!(
            changed(list(&["V7", "V8"]).part(6, 9), &before),
            [0; 0],
            "another page"
        );
        assert_eq!(
            changed(list(&["V1", "V4"]), &list(&["V1"])),
            [1],
            "all of a list"
        );
    }
}
