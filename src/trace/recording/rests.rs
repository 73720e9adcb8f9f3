//! Copies of a run's memory at some of the places where it rests.

/// So many copies are kept at most, however long the run.
const MOST_KEPT: usize = 32;

/// Copies of what a run held at each `stride`-th of its rests, with the number of events that were past.
#[derive(Clone, Debug)]
pub struct Rests<H> {
    stride: usize,
    n_offered: usize,
    kept: Vec<(usize, H)>,
}

impl<H> Default for Rests<H> {
    fn default() -> Self {
        Self {
            stride: 1,
            n_offered: 0,
            kept: Vec::new(),
        }
    }
}

impl<H: Clone> Rests<H> {
    /// Keeps a copy where one is due. Of 32 copies every other one is dropped, and the stride doubles.
    pub fn offer(&mut self, n_events: usize, held: &H) {
        self.n_offered += 1;
        if !self.n_offered.is_multiple_of(self.stride) {
            return;
        }
        if self.kept.len() == MOST_KEPT {
            let mut i = 0;
            self.kept.retain(|_| {
                i += 1;
                i % 2 == 0
            });
            self.stride *= 2;
            // The one that is offered stands between two that would be kept now.
            return;
        }
        self.kept.push((n_events, held.clone()));
    }

    /// The last copy after no more than `n_events`.
    pub fn before(&self, n_events: usize) -> Option<&(usize, H)> {
        let n = self.kept.partition_point(|(at, _)| *at <= n_events);
        self.kept[..n].last()
    }

    /// All copies, in the order in which they were taken.
    pub fn kept(&self) -> &[(usize, H)] {
        &self.kept
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn however_many_are_offered_32_at_most_are_kept_evenly() {
        let mut rests = Rests::default();
        for n in 1..=5000 {
            rests.offer(n, &n);
            assert!(rests.kept().len() <= MOST_KEPT, "after {n}");
        }
        let at: Vec<usize> = rests.kept().iter().map(|(n, _)| *n).collect();
        assert!(at.len() >= MOST_KEPT / 2, "{at:?}");
        assert!(
            at.windows(2).all(|pair| pair[1] - pair[0] == rests.stride),
            "{at:?}"
        );
        assert_eq!(rests.before(at[3] + 1), Some(&(at[3], at[3])));
        assert_eq!(rests.before(at[0] - 1), None);
    }
}
