//! Vertex lists beside each other, and what links them.

use std::ops::Range;

use crate::text::Value;

use super::role::{Link, Role};

/// Lists side by side, from left to right.
#[derive(Clone, PartialEq, Debug)]
pub struct Lists {
    /// At least one.
    pub lists: Vec<ListColumn>,
    /// Between entries of neighbouring lists.
    pub links: Vec<ListLink>,
    /// Under them: what the marks before entries mean. The same at every step.
    pub legend: Vec<(ItemMarker, Value)>,
}

/// One list, from top to bottom.
#[derive(Clone, PartialEq, Debug)]
pub struct ListColumn {
    /// Over it: "Subject list".
    pub title: Value,
    /// Over the entries' details: `(x, y)`, `d`. None where no entry has any.
    pub columns: Vec<Value>,
    /// All of a short list, of a long one those about the focus ([`ListColumn::reach`]); a view folds what it has no room
    /// for, and says so.
    pub entries: Vec<ListRow>,
    /// How many more come before them.
    pub n_before: usize,
    /// How many more come after them.
    pub n_after: usize,
    /// Does the last lead back to the first?
    pub is_ring: bool,
    /// Entries with which another ring begins, as a polygon's hole does: each ring leads back to its own first entry.
    pub breaks: Vec<usize>,
    /// The entry that must be seen: where the step is.
    pub focus: Option<usize>,
}

impl ListColumn {
    /// Of a longer list no more entries than these are given.
    const MOST: usize = 40;

    /// All of these entries, of which none leads back.
    pub const fn new(title: Value, entries: Vec<ListRow>) -> Self {
        Self {
            title,
            columns: Vec::new(),
            entries,
            n_before: 0,
            n_after: 0,
            is_ring: false,
            breaks: Vec::new(),
            focus: None,
        }
    }

    /// Of a list of `len` the entries about `focus`.
    pub fn about(
        title: Value,
        len: usize,
        focus: Option<usize>,
        entry: impl FnMut(usize) -> ListRow,
    ) -> Self {
        let reach = Self::reach(len, focus);
        Self {
            n_before: reach.start,
            n_after: len - reach.end,
            focus: focus.map(|at| at - reach.start),
            ..Self::new(title, reach.map(entry).collect())
        }
    }

    /// The places of a list of `len` that are to be given as entries: those about `focus`, or its first ones.
    pub fn reach(len: usize, focus: Option<usize>) -> Range<usize> {
        let first = focus.unwrap_or(0).saturating_sub(Self::MOST / 2);
        let first = first.min(len.saturating_sub(Self::MOST));
        first..len.min(first + Self::MOST)
    }
}

/// One entry.
#[derive(Clone, PartialEq, Debug)]
pub struct ListRow {
    /// `S₃`, `I₁`.
    pub name: Value,
    /// What is said of it, one a column, each column set flush: its place, a distance, a word; none as long as it is
    /// not known.
    pub details: Vec<Option<Value>>,
    /// The mark that the same thing has in the drawing.
    pub marker: Option<ItemMarker>,
    /// [`Role::Signal`] for this step's, [`Role::Accent`] for what has been walked or kept so far, [`Role::Accepted`]
    /// for what is in the answer, [`Role::Discarded`] for what is dropped, [`Role::Ink`] for what counts,
    /// [`Role::Faint`] for what is still to come, else [`Role::Soft`].
    pub role: Role,
    /// What it is about.
    pub link: Option<Link>,
}

/// The mark before an entry, as in the drawing.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ItemMarker {
    /// Filled: entering, inside, convex.
    Dot,
    /// Hollow: leaving, outside, reflex.
    Ring,
    /// Neither: touching, not known yet.
    Cross,
    /// Both: where two borders pinch.
    CrossedRing,
}

/// From an entry to one of another list: each `[list, entry]`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ListLink {
    /// Where it begins.
    pub from: [usize; 2],
    /// Where it ends.
    pub to: [usize; 2],
    /// [`Role::Signal`] for the one that is taken now: a thick arrow; else a dashed hairline.
    pub role: Role,
}

impl ListRow {
    /// An entry of little weight.
    pub fn new(name: impl Into<Value>) -> Self {
        Self {
            name: name.into(),
            details: Vec::new(),
            marker: None,
            role: Role::Soft,
            link: None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_list_is_given_about_its_focus() {
        assert_eq!(ListColumn::reach(7, Some(6)), 0..7, "all of a short one");
        assert_eq!(ListColumn::reach(100, None), 0..40);
        assert_eq!(ListColumn::reach(100, Some(50)), 30..70);
        assert_eq!(ListColumn::reach(100, Some(99)), 60..100);
    }
}
