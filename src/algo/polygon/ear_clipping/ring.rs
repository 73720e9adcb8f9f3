//! What is left of an outline: its vertices in a circle, from which any one can be taken in one step.

/// A doubly linked circle of vertex numbers.
#[derive(Clone, PartialEq, Debug)]
pub struct Ring {
    prev: Vec<usize>,
    next: Vec<usize>,
    /// The lowest number that is left.
    first: usize,
    len: usize,
}

impl Ring {
    /// 0, 1, … n − 1 and back to 0.
    pub(super) fn new(n: usize) -> Self {
        Self {
            prev: (0..n).map(|i| i.checked_sub(1).unwrap_or(n - 1)).collect(),
            next: (1..=n).map(|i| i % n).collect(),
            first: 0,
            len: n,
        }
    }

    /// How many vertices are left.
    #[must_use]
    pub const fn len(&self) -> usize {
        self.len
    }

    /// Is nothing left?
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// The lowest number that is left.
    #[must_use]
    pub const fn first(&self) -> usize {
        self.first
    }

    /// The one before.
    #[must_use]
    pub fn prev(&self, vertex_idx: usize) -> usize {
        self.prev[vertex_idx]
    }

    /// The one after.
    #[must_use]
    pub fn next(&self, vertex_idx: usize) -> usize {
        self.next[vertex_idx]
    }

    /// The corner at a vertex: the one before it, itself, the one after.
    #[must_use]
    pub fn corner(&self, vertex_idx: usize) -> [usize; 3] {
        [self.prev(vertex_idx), vertex_idx, self.next(vertex_idx)]
    }

    /// Every vertex that is left, in order of number.
    pub fn iter(&self) -> impl Iterator<Item = usize> + '_ {
        let first = Some(self.first).filter(|_| self.len > 0);
        std::iter::successors(first, |&i| Some(self.next(i)).filter(|&i| i != self.first))
    }

    /// Takes a vertex out.
    pub(super) fn remove(&mut self, vertex_idx: usize) {
        let [prev, _, next] = self.corner(vertex_idx);
        self.next[prev] = next;
        self.prev[next] = prev;
        self.len -= 1;
        if vertex_idx == self.first {
            self.first = next;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn neighbours_join_over_what_is_taken_out() {
        let mut ring = Ring::new(5);
        ring.remove(2);
        ring.remove(4);
        assert_eq!(ring.iter().collect::<Vec<_>>(), [0, 1, 3]);
        assert_eq!(ring.corner(0), [3, 0, 1]);
        ring.remove(0);
        assert_eq!(ring.iter().collect::<Vec<_>>(), [1, 3]);
        assert_eq!(ring.len(), 2);
    }
}
