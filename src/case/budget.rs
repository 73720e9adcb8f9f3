//! How much work a case may be: counted, so that it is the same on every machine, and listed in the schema.

use crate::trace::Told;

/// The run has more steps than its algorithm's [`Solve::BUDGET`](super::Solve::BUDGET).
#[derive(Clone, Copy, Debug)]
pub struct OverBudget;

/// Counts the steps of a run, and stops it after too many.
#[derive(Clone, Copy, Debug)]
pub struct Meter {
    n_steps: u64,
    most: u64,
}

impl Meter {
    pub(super) const fn new(most: u64) -> Self {
        Self { n_steps: 0, most }
    }

    /// So many more.
    ///
    /// # Errors
    /// These are too many.
    pub const fn add(&mut self, n_steps: u64) -> Told<OverBudget> {
        self.n_steps = self.n_steps.saturating_add(n_steps);
        if self.n_steps > self.most {
            Told::Break(OverBudget)
        } else {
            Told::Continue(())
        }
    }
}
