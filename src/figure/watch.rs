//! The watch table: the values that are alive at a step.

use crate::text::Value;

use super::{Link, ViewId};

/// A row: a name and its values.
#[derive(Clone, PartialEq, Debug)]
pub struct WatchRow {
    /// `code₁`, `u_min`, or an edge's name.
    pub name: Value,
    /// One value, or one a column of the section's header.
    pub cells: Vec<Option<Value>>,
    /// A word on the value: "left", "≠ 0".
    pub note: Option<Value>,
    /// Did it change at this step?
    pub changed: bool,
    /// What it is about.
    pub link: Option<Link>,
}

impl WatchRow {
    /// A name and one value.
    #[must_use]
    pub fn new(name: impl Into<Value>, cell: Option<Value>) -> Self {
        Self::table(name, vec![cell])
    }

    /// A name and several values.
    #[must_use]
    pub fn table(name: impl Into<Value>, cells: Vec<Option<Value>>) -> Self {
        Self {
            name: name.into(),
            cells,
            note: None,
            changed: false,
            link: None,
        }
    }

    /// With a word on the value.
    #[must_use]
    pub fn noted(mut self, note: impl Into<Value>) -> Self {
        self.note = Some(note.into());
        self
    }

    /// About `link`.
    #[must_use]
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
}

impl WatchSection {
    /// A plain list.
    #[must_use]
    pub const fn list(rows: Vec<WatchRow>) -> Self {
        Self::titled(Vec::new(), rows)
    }

    /// A table whose columns are headed by symbols, the same in every language: `t`, `n·D`.
    #[must_use]
    pub fn table(header: Vec<&'static str>, rows: Vec<WatchRow>) -> Self {
        let symbol = |symbol: &str| Value::Name(symbol.to_owned());
        Self::titled(header.into_iter().map(symbol).collect(), rows)
    }

    /// A table whose columns are headed by words of the catalogue, or anything else that can be said.
    #[must_use]
    pub const fn titled(header: Vec<Value>, rows: Vec<WatchRow>) -> Self {
        Self {
            header,
            rows,
            seen_in: None,
        }
    }

    /// Shown in the view of this name.
    #[must_use]
    pub const fn seen_in(mut self, view: &'static str) -> Self {
        self.seen_in = Some(ViewId(view));
        self
    }
}

/// Sections from top to bottom.
pub type Watch = Vec<WatchSection>;

/// What stands in no view.
#[must_use]
pub fn unseen(watch: &Watch) -> Watch {
    let unseen = |section: &&WatchSection| section.seen_in.is_none();
    watch.iter().filter(unseen).cloned().collect()
}

/// Marks the rows whose values differ from the step before: those of a name, under the same header.
pub fn mark_changes(now: &mut Watch, before: &Watch) {
    for section in now {
        let same = before.iter().filter(|old| old.header == section.header);
        let old: Vec<&WatchRow> = same.flat_map(|section| &section.rows).collect();
        for row in &mut section.rows {
            let was = old.iter().find(|old| old.name == row.name);
            row.changed = row.cells.iter().enumerate().any(|(i, cell)| {
                cell.is_some() && was.is_none_or(|was| was.cells.get(i) != Some(cell))
            });
        }
    }
}
