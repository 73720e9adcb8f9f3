//! What the lab knows of a method: the same whatever it runs on.

use crate::{figure::Run, labs::MethodCard, trace::Counts};

use super::Subject;

/// What is known of a method without running it.
pub struct MethodInfo<S> {
    /// Names, source and pseudocode.
    pub card: MethodCard,
    /// What it is about.
    pub subject: Subject,
    pub(super) record: fn(&S) -> Box<dyn Run>,
    pub(super) cost: fn(&S) -> Counts,
}

impl<S> MethodInfo<S> {
    /// Runs it on a scene.
    #[must_use]
    pub fn record(&self, scene: &S) -> Box<dyn Run> {
        (self.record)(scene)
    }

    /// How many operations it takes, without recording the steps.
    #[must_use]
    pub fn cost(&self, scene: &S) -> Counts {
        (self.cost)(scene)
    }
}
