//! The document and its past: every change can be undone, a whole gesture at once.

use std::{cell::OnceCell, rc::Rc};

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

/// A file that the document is of.
#[derive(Clone, PartialEq, Debug)]
pub struct OnDisk<S> {
    pub path: String,
    /// What is in it, if that is known.
    pub document: Option<S>,
}

/// A document as it was, and what goes back with it.
#[derive(Clone, Debug)]
struct Version<S> {
    document: S,
    file: Option<Rc<OnDisk<S>>>,
    /// The step of the run that was seen when another document took its place.
    left_at: Option<usize>,
}

#[derive(Clone, Debug)]
pub struct History<S> {
    now: Version<S>,
    past: Vec<Version<S>>,
    future: Vec<Version<S>>,
    open: Option<(UndoGroup, f64)>,
    revision: u64,
    unsaved: OnceCell<bool>,
}

impl<S: Clone + PartialEq> History<S> {
    pub const fn new(document: S) -> Self {
        Self {
            now: Version {
                document,
                file: None,
                left_at: None,
            },
            past: Vec::new(),
            future: Vec::new(),
            open: None,
            revision: 0,
            unsaved: OnceCell::new(),
        }
    }

    pub const fn now(&self) -> &S {
        &self.now.document
    }

    pub fn file(&self) -> Option<&str> {
        self.now.file.as_deref().map(|file| &*file.path)
    }

    /// Is the document another one than its file holds?
    pub fn is_unsaved(&self) -> bool {
        let file = self.now.file.as_deref();
        let differs = |file: &OnDisk<S>| file.document.as_ref() != Some(self.now());
        *self.unsaved.get_or_init(|| file.is_some_and(differs))
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
        self.now.left_at = None;
        change(&mut self.now.document)?;
        if self.now.document == before.document {
            return Ok(false);
        }
        if !continues {
            self.past.push(before);
            let most = (MAX_KEPT_UNITS / size.max(1)).clamp(MIN_UNDO, MAX_UNDO);
            self.past.drain(..self.past.len().saturating_sub(most));
        }
        self.open = gesture.map(|gesture| (gesture, time));
        self.future.clear();
        self.changed();
        Ok(true)
    }

    /// Puts other documents in the place of some, whenever they were there.
    pub fn exchange(&mut self, exchange: impl Fn(&S) -> Option<S>) {
        let past_and_future = self.past.iter_mut().chain(&mut self.future);
        for version in past_and_future.chain([&mut self.now]) {
            if let Some(document) = exchange(&version.document) {
                version.document = document;
                self.revision += 1;
            }
        }
    }

    pub fn replace(&mut self, document: S) {
        if document != self.now.document {
            let file = self.now.file.clone();
            self.put(document, file);
        }
    }

    /// Shows what a file holds in the place of what is shown.
    pub fn open(&mut self, path: &str, document: S) {
        let file = OnDisk {
            path: path.to_owned(),
            document: Some(document.clone()),
        };
        self.put(document, Some(Rc::new(file)));
    }

    /// Shows what was kept from the last time. Only that is of its file: what comes back by undo would overwrite it.
    pub fn restore(&mut self, document: S, file: Option<OnDisk<S>>) {
        self.replace(document);
        self.now.file = file.map(Rc::new);
        self.unsaved = OnceCell::new();
    }

    fn put(&mut self, document: S, file: Option<Rc<OnDisk<S>>>) {
        let now = Version {
            document,
            file,
            left_at: None,
        };
        self.past.push(std::mem::replace(&mut self.now, now));
        self.future.clear();
        self.moved();
    }

    /// Changes what a version says besides: that is undone with its own change.
    pub fn amend(&mut self, change: impl FnOnce(&mut S)) {
        change(&mut self.now.document);
        self.changed();
    }

    /// The document has been written into this file: so are all versions that had the same.
    pub fn saved(&mut self, path: String) {
        let document = Some(self.now().clone());
        let new = Some(Rc::new(OnDisk { path, document }));
        let old = self.now.file.clone();
        let versions = self.past.iter_mut().chain(&mut self.future);
        for version in versions.chain([&mut self.now]) {
            if version.file.as_ref().map(Rc::as_ptr) == old.as_ref().map(Rc::as_ptr) {
                version.file.clone_from(&new);
            }
        }
        self.unsaved = OnceCell::new();
    }

    /// Another document is about to take this one's place: its run stands at this step.
    pub const fn leave(&mut self, position: usize) {
        self.now.left_at = Some(position);
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

    /// One version back, from a run at this step; the step at which that version's run was left, where another document had
    /// taken its place.
    pub fn undo(&mut self, position: usize) -> Option<usize> {
        let before = self.past.pop()?;
        let left = self.turn(before, position);
        self.future.push(left);
        self.now.left_at.take()
    }

    /// The same forward.
    pub fn redo(&mut self, position: usize) -> Option<usize> {
        let after = self.future.pop()?;
        let left = self.turn(after, position);
        self.past.push(left);
        self.now.left_at.take()
    }

    /// Shows this version; the one that was shown.
    fn turn(&mut self, to: Version<S>, position: usize) -> Version<S> {
        let mut left = std::mem::replace(&mut self.now, to);
        left.left_at = self.now.left_at.is_some().then_some(position);
        self.moved();
        left
    }

    fn changed(&mut self) {
        self.revision += 1;
        self.unsaved = OnceCell::new();
    }

    fn moved(&mut self) {
        self.open = None;
        self.changed();
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
        document.undo(0);
        assert_eq!(*document.now(), 3);
        document.undo(0);
        assert_eq!((*document.now(), document.can_undo()), (0, false));
        document.redo(0);
        document.redo(0);
        assert_eq!((*document.now(), document.can_redo()), (4, false));
    }

    #[test]
    fn key_presses_are_undone_together_until_there_is_a_pause() {
        let mut document = History::new(0);
        set(&mut document, Some(UndoGroup::Nudge(1)), 0.0, 1);
        set(&mut document, Some(UndoGroup::Nudge(1)), 0.5, 2);
        set(&mut document, Some(UndoGroup::Nudge(1)), 3.0, 3);
        document.undo(0);
        assert_eq!(*document.now(), 2);
        document.undo(0);
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
        document.undo(0);
        set(&mut document, None, 0.0, 2);
        assert!(!document.can_redo());
    }

    #[test]
    fn the_file_and_the_moment_go_back_with_the_document() {
        let mut document = History::new(0);
        document.open("a", 1);
        set(&mut document, None, 0.0, 2);
        assert!(document.is_unsaved());
        document.leave(7);
        document.open("b", 3);
        assert_eq!((document.file(), document.is_unsaved()), (Some("b"), false));
        assert_eq!(document.undo(4), Some(7), "where its run had been");
        assert_eq!((document.file(), document.is_unsaved()), (Some("a"), true));
        document.saved("c".to_owned());
        assert_eq!(document.undo(0), None, "an edit stays at its moment");
        assert_eq!((*document.now(), document.file()), (1, Some("c")));
        assert!(document.is_unsaved());
        document.redo(0);
        assert!(!document.is_unsaved());
        assert_eq!(document.redo(9), Some(4));
        assert_eq!((*document.now(), document.file()), (3, Some("b")));
        assert_eq!(document.undo(4), Some(9));
    }

    #[test]
    fn what_was_kept_is_of_its_file_and_what_undo_brings_is_not() {
        let mut document = History::new(0);
        let file = |document| OnDisk {
            path: "a".to_owned(),
            document: Some(document),
        };
        document.restore(1, Some(file(1)));
        assert_eq!((document.file(), document.is_unsaved()), (Some("a"), false));
        document.undo(0);
        assert_eq!((*document.now(), document.file()), (0, None));
        document.redo(0);
        assert_eq!(document.file(), Some("a"));
        // The same as at first: there is nothing to undo.
        let mut document = History::new(0);
        document.restore(0, Some(file(2)));
        assert_eq!((document.file(), document.is_unsaved()), (Some("a"), true));
        assert!(!document.can_undo());
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
