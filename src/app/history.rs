//! The document and its past: every change can be undone, a whole gesture at once.

const MAX_UNDO: usize = 100;
const MIN_UNDO: usize = 4;
/// Units of documents (segments, say) kept at most for undo: some hundred megabytes.
const MAX_KEPT_UNITS: usize = 4_000_000;
/// Key presses of the same kind that follow each other within this time are undone together.
const PAUSE_SECS: f64 = 1.0;

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum UndoGroup {
    /// A drag of this handle, until the pointer lets go.
    Drag(usize),
    /// Presses of arrow keys on this handle, until there is a pause.
    Nudge(usize),
    /// This number of a menu, dragged or typed, until there is a pause.
    Number(usize),
}

#[derive(Clone, Debug)]
pub struct History<S> {
    now: S,
    past: Vec<S>,
    future: Vec<S>,
    open: Option<(UndoGroup, f64)>,
    revision: u64,
}

impl<S: Clone + PartialEq> History<S> {
    pub const fn new(now: S) -> Self {
        Self {
            now,
            past: Vec::new(),
            future: Vec::new(),
            open: None,
            revision: 0,
        }
    }

    pub const fn now(&self) -> &S {
        &self.now
    }

    /// Another number after every change: what is cached under it is still true.
    pub const fn revision(&self) -> u64 {
        self.revision
    }

    /// Changes the document. Changes of one gesture become one step of undo; `time` is in seconds and
    /// `size` the document's in units. Says whether anything changed.
    ///
    /// # Errors
    /// What `change` answers; it has to leave the document as it was then.
    pub fn edit<E>(
        &mut self,
        gesture: Option<UndoGroup>,
        time: f64,
        size: usize,
        change: impl FnOnce(&mut S) -> Result<(), E>,
    ) -> Result<bool, E> {
        let continues = match (gesture, self.open) {
            (Some(now @ UndoGroup::Drag(_)), Some((open, _))) => now == open,
            (Some(now @ (UndoGroup::Nudge(_) | UndoGroup::Number(_))), Some((open, at))) => {
                now == open && time - at <= PAUSE_SECS
            }
            _ => false,
        };
        let before = self.now.clone();
        change(&mut self.now)?;
        if self.now == before {
            return Ok(false);
        }
        if !continues {
            self.past.push(before);
            let most = (MAX_KEPT_UNITS / size.max(1)).clamp(MIN_UNDO, MAX_UNDO);
            self.past.drain(..self.past.len().saturating_sub(most));
        }
        self.open = gesture.map(|gesture| (gesture, time));
        self.future.clear();
        self.revision += 1;
        Ok(true)
    }

    pub fn replace(&mut self, now: S) {
        if now != self.now {
            self.past.push(std::mem::replace(&mut self.now, now));
            self.future.clear();
            self.moved();
        }
    }

    pub const fn is_in_gesture(&self) -> bool {
        matches!(self.open, Some((UndoGroup::Drag(_), _)))
    }

    pub const fn end_gesture(&mut self) {
        self.open = None;
    }

    pub const fn can_undo(&self) -> bool {
        !self.past.is_empty()
    }

    pub const fn can_redo(&self) -> bool {
        !self.future.is_empty()
    }

    pub fn undo(&mut self) {
        if let Some(before) = self.past.pop() {
            self.future.push(std::mem::replace(&mut self.now, before));
            self.moved();
        }
    }

    pub fn redo(&mut self) {
        if let Some(after) = self.future.pop() {
            self.past.push(std::mem::replace(&mut self.now, after));
            self.moved();
        }
    }

    const fn moved(&mut self) {
        self.open = None;
        self.revision += 1;
    }
}

#[cfg(test)]
mod tests {
    use std::convert::Infallible;

    use super::*;

    fn set(document: &mut History<i32>, gesture: Option<UndoGroup>, time: f64, to: i32) {
        let changed: Result<bool, Infallible> = document.edit(gesture, time, 1, |now| {
            *now = to;
            Ok(())
        });
        changed.expect("cannot fail");
    }

    #[test]
    fn a_drag_is_undone_as_one() {
        let mut document = History::new(0);
        for to in [1, 2, 3] {
            set(&mut document, Some(UndoGroup::Drag(0)), 0.0, to);
        }
        document.end_gesture();
        set(&mut document, Some(UndoGroup::Drag(0)), 0.1, 4);
        document.undo();
        assert_eq!(*document.now(), 3);
        document.undo();
        assert_eq!((*document.now(), document.can_undo()), (0, false));
        document.redo();
        document.redo();
        assert_eq!((*document.now(), document.can_redo()), (4, false));
    }

    #[test]
    fn key_presses_are_undone_together_until_there_is_a_pause() {
        let mut document = History::new(0);
        set(&mut document, Some(UndoGroup::Nudge(1)), 0.0, 1);
        set(&mut document, Some(UndoGroup::Nudge(1)), 0.5, 2);
        set(&mut document, Some(UndoGroup::Nudge(1)), 3.0, 3);
        document.undo();
        assert_eq!(*document.now(), 2);
        document.undo();
        assert_eq!(*document.now(), 0);
    }

    #[test]
    fn a_change_that_changes_nothing_or_fails_leaves_no_trace() {
        let mut document = History::new(7);
        set(&mut document, None, 0.0, 7);
        let refused: Result<bool, ()> = document.edit(None, 0.0, 1, |_| Err(()));
        assert!(refused.is_err());
        assert!(!document.can_undo());
        assert_eq!(document.revision(), 0);
    }

    #[test]
    fn a_new_change_forgets_what_was_undone() {
        let mut document = History::new(0);
        set(&mut document, None, 0.0, 1);
        document.undo();
        set(&mut document, None, 0.0, 2);
        assert!(!document.can_redo());
    }

    #[test]
    fn the_past_is_bounded_by_the_size_of_what_is_kept() {
        let mut document = History::new(0);
        for to in 1..200 {
            set(&mut document, None, 0.0, to);
        }
        assert_eq!(document.past.len(), MAX_UNDO);
        for to in 200..300 {
            let changed: Result<bool, Infallible> = document.edit(None, 0.0, 1_000_000, |now| {
                *now = to;
                Ok(())
            });
            changed.expect("cannot fail");
        }
        assert_eq!(document.past.len(), MIN_UNDO);
    }
}
