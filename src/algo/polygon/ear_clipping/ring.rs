//! What is left of an outline: its vertices in a circle, from which any but the first can be taken in one step.

/// A doubly linked circle of vertex numbers.
#[derive(Clone, PartialEq, Debug)]
pub struct Ring {
    prev: Vec<usize>,
    next: Vec<usize>,
    len: usize,
}

impl Ring {
    /// 0, 1, … n − 1 and back to 0.
    pub(super) fn new(n: usize) -> Self {
        Self {
            prev: (0..n).map(|i| i.checked_sub(1).unwrap_or(n - 1)).collect(),
            next: (1..=n).map(|i| i % n).collect(),
            len: n,
        }
    }

    /// How many vertices are left.
    #[must_use]
    pub const fn len(&self) -> usize {
        self.len
    }

    /// Is nothing left? Never: the first vertex stays.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.len == 0
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

    /// Every vertex that is left, from vertex 0 on.
    pub fn iter(&self) -> impl Iterator<Item = usize> + '_ {
        std::iter::successors(Some(0), |&i| Some(self.next(i)).filter(|&i| i != 0))
    }

    /// Takes a vertex out; vertex 0 stays.
    pub(super) fn remove(&mut self, vertex_idx: usize) {
        let [prev, _, next] = self.corner(vertex_idx);
        self.next[prev] = next;
        self.prev[next] = prev;
        self.len -= 1;
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
        assert_eq!(ring.len(), 3);
    }
}
