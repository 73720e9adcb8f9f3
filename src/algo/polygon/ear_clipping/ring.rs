//! What is left of an outline: its vertices in a circle, from which any one can be taken in one step.

/// A doubly linked circle of vertex numbers.
#[derive(Clone, PartialEq, Debug)]
pub struct Ring {
    prev: Vec<usize>,
    next: Vec<usize>,
    first: usize,
    len: usize,
}

impl Ring {
    pub(super) fn through(order: &[usize]) -> Self {
        let n_numbers = order.iter().max().map_or(0, |highest| highest + 1);
        let (mut prev, mut next) = (vec![0; n_numbers], vec![0; n_numbers]);
        for (&here, &after) in order.iter().zip(order.iter().cycle().skip(1)) {
            (next[here], prev[after]) = (after, here);
        }
        Self {
            prev,
            next,
            first: order.first().copied().unwrap_or_default(),
            len: order.len(),
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

    /// Where it begins: at the first vertex that is left.
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

    /// Is it left?
    #[must_use]
    pub fn contains(&self, vertex_idx: usize) -> bool {
        self.next(self.prev(vertex_idx)) == vertex_idx
    }

    /// The corner at a vertex: the one before it, itself, the one after.
    #[must_use]
    pub fn corner(&self, vertex_idx: usize) -> [usize; 3] {
        [self.prev(vertex_idx), vertex_idx, self.next(vertex_idx)]
    }

    /// Every vertex that is left, from the first one on.
    pub fn iter(&self) -> impl Iterator<Item = usize> + '_ {
        let first = Some(self.first).filter(|_| self.len > 0);
        std::iter::successors(first, |&i| Some(self.next(i)).filter(|&i| i != self.first))
    }

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
        let mut ring = Ring::through(&[0, 5, 4, 2, 1]);
        ring.remove(4);
        ring.remove(1);
        assert_eq!(ring.iter().collect::<Vec<_>>(), [0, 5, 2]);
        assert_eq!(ring.corner(0), [2, 0, 5]);
        ring.remove(0);
        assert_eq!(ring.iter().collect::<Vec<_>>(), [5, 2]);
        assert_eq!(ring.len(), 2);
        let left: Vec<usize> = (0..6).filter(|&i| ring.contains(i)).collect();
        assert_eq!(left, [2, 5], "3 never was there");
    }
}
