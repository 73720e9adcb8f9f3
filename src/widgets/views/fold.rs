//! What is seen of many: the neighbourhood of the one that matters.

use std::ops::Range;

use crate::text::Message;

#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Fold {
    pub before: usize,
    pub shown: Range<usize>,
    pub after: usize,
}

impl Fold {
    /// Of `n` rows those about `focus`; a line that says what is folded takes a row of its own.
    pub fn about(n: usize, focus: Option<usize>, room: usize) -> Self {
        if n <= room {
            return Self::of(n, 0..n);
        }
        let focus = focus.unwrap_or(0).min(n - 1);
        // At either end there is one line that says so, elsewhere there are two.
        let at_end = room.saturating_sub(1).max(1);
        if focus + 1 < at_end || at_end == 1 && focus == 0 {
            return Self::of(n, 0..at_end);
        }
        if n - focus < at_end {
            return Self::of(n, n - at_end..n);
        }
        let inside = room.saturating_sub(2).max(1);
        let start = focus.saturating_sub(inside / 2).min(n - inside);
        Self::of(n, start..start + inside)
    }

    /// Of `n` so many, the focus as near to their middle as it can be; what is folded has room of its own.
    pub fn about_middle(n: usize, focus: usize, room: usize) -> Self {
        let room = room.clamp(1, n.max(1)).min(n);
        let start = focus.saturating_sub(room / 2).min(n - room);
        Self::of(n, start..start + room)
    }

    const fn of(n: usize, shown: Range<usize>) -> Self {
        Self {
            before: shown.start,
            after: n - shown.end,
            shown,
        }
    }

    pub fn n_rows(&self) -> usize {
        self.shown.len() + usize::from(self.before > 0) + usize::from(self.after > 0)
    }

    pub fn first_row(&self) -> usize {
        usize::from(self.before > 0)
    }

    pub fn row_of(&self, idx: usize) -> Option<usize> {
        let row = || idx - self.shown.start + self.first_row();
        self.shown.contains(&idx).then(row)
    }
}

pub fn more(count: usize) -> Message {
    Message::new("view-more").with("count", count)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_are_shown_or_counted_and_the_focus_is_seen() {
        for (n, room) in (0..60).flat_map(|n| (1..20).map(move |room| (n, room))) {
            for focus in 0..n {
                let check = |fold: &Fold| {
                    assert_eq!(fold.before + fold.shown.len() + fold.after, n);
                    assert!(fold.shown.contains(&focus), "{n} {focus} {room}: {fold:?}");
                };
                if room >= 3 {
                    let fold = Fold::about(n, Some(focus), room);
                    check(&fold);
                    assert!(fold.n_rows() <= room, "{n} {focus} {room}: {fold:?}");
                    assert!(n > room || fold.shown == (0..n));
                }
                let fold = Fold::about_middle(n, focus, room);
                check(&fold);
                assert_eq!(fold.shown.len(), room.min(n));
            }
        }
    }

    #[test]
    fn nothing_is_folded_where_there_is_room_else_neighbours_are_seen_on_both_sides() {
        assert_eq!(Fold::about(5, Some(4), 5).shown, 0..5);
        assert_eq!(Fold::about(0, None, 5).shown, 0..0);
        let fold = Fold::about(200, Some(100), 12);
        assert_eq!(fold.shown, 95..105);
        assert_eq!((fold.before, fold.after), (95, 95));
        assert_eq!(fold.row_of(100), Some(6));
    }
}
