//! A list that grows at its end and is cheap to clone: for states that hold a polygon of thousands of vertices.
//!
//! ```text
//!   full  ┌──────┐ ┌──────┐ ┌──────┐      shared by all clones
//!         └──────┘ └──────┘ └──────┘
//!   tail  ┌───┐                           copied
//!         └───┘
//! ```

use std::{fmt, sync::Arc};

/// Elements to a shared chunk: a clone copies at most so many, and one pointer for each full chunk.
const CHUNK: usize = 128;

/// A list that shares its full chunks with its clones.
#[derive(Clone)]
pub struct Log<T> {
    full: Vec<Arc<[T]>>,
    tail: Vec<T>,
}

impl<T> Default for Log<T> {
    fn default() -> Self {
        Self {
            full: Vec::new(),
            tail: Vec::new(),
        }
    }
}

impl<T: Clone> Log<T> {
    /// At the end.
    pub fn push(&mut self, element: T) {
        self.tail.push(element);
        if self.tail.len() == CHUNK {
            self.full.push(Arc::from(std::mem::take(&mut self.tail)));
        }
    }

    /// How many there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.full.len() * CHUNK + self.tail.len()
    }

    /// Is there none?
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Element `idx`, where there is one.
    #[must_use]
    pub fn get(&self, idx: usize) -> Option<&T> {
        match self.full.get(idx / CHUNK) {
            Some(chunk) => chunk.get(idx % CHUNK),
            None => self.tail.get(idx - self.full.len() * CHUNK),
        }
    }

    /// The last element.
    #[must_use]
    pub fn last(&self) -> Option<&T> {
        self.get(self.len().checked_sub(1)?)
    }

    /// The last element, to be changed.
    pub fn last_mut(&mut self) -> Option<&mut T> {
        self.reopen();
        self.tail.last_mut()
    }

    /// Keeps the first `len` elements.
    pub fn truncate(&mut self, len: usize) {
        while self.len() > len {
            self.reopen();
            let n_full = self.full.len() * CHUNK;
            self.tail.truncate(len.saturating_sub(n_full));
        }
    }

    /// Elements in order.
    pub fn iter(&self) -> impl Iterator<Item = &T> {
        self.full
            .iter()
            .flat_map(|chunk| chunk.iter())
            .chain(&self.tail)
    }

    /// Makes the last full chunk the tail, where the tail is empty.
    fn reopen(&mut self) {
        if self.tail.is_empty()
            && let Some(chunk) = self.full.pop()
        {
            self.tail = chunk.to_vec();
        }
    }
}

impl<T: Clone + PartialEq> PartialEq for Log<T> {
    fn eq(&self, other: &Self) -> bool {
        self.len() == other.len() && self.iter().eq(other.iter())
    }
}

impl<T: Clone + fmt::Debug> fmt::Debug for Log<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(self.iter()).finish()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_the_list_that_it_seems_to_be() {
        let (mut log, mut list) = (Log::default(), Vec::new());
        let same = |log: &Log<usize>, list: &[usize]| {
            assert!(log.iter().eq(list), "{log:?}");
            assert_eq!((log.len(), log.last()), (list.len(), list.last()));
            assert_eq!(log.is_empty(), list.is_empty());
            for i in 0..list.len() + 2 {
                assert_eq!(log.get(i), list.get(i), "element {i}");
            }
        };
        same(&log, &list);
        for step in 0..900 {
            if step % 7 == 6 {
                if let (Some(a), Some(b)) = (log.last_mut(), list.last_mut()) {
                    (*a, *b) = (step, step);
                }
            } else if step % 301 == 300 {
                log.truncate(step / 3);
                list.truncate(step / 3);
            } else {
                log.push(step);
                list.push(step);
            }
            if step % 50 == 0 {
                same(&log, &list);
            }
        }
        let kept = log.clone();
        log.truncate(130);
        log.push(1);
        same(&kept, &list);
        list.truncate(130);
        list.push(1);
        same(&log, &list);
        log.truncate(0);
        same(&log, &[]);
    }
}
