//! What the lab knows of a method: the same whatever it runs on.

use crate::{figure::Run, labs::MethodCard};

/// How the subject is seen under a method's drawing, before its end.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum GivenSubject {
    /// As it is.
    Whole,
    /// As cut off, but for what the drawing outlines: the list that the method works on.
    CutOff,
}

/// What is known of a method without running it.
pub struct MethodInfo<S> {
    /// Names, source and pseudocode.
    pub card: MethodCard,
    /// Does it clip: against the window, or a clip polygon in its place?
    pub clips: bool,
    /// Does it carry texture coordinates along?
    pub carries_texture: bool,
    /// How the subject is seen while it works.
    pub given: GivenSubject,
    /// Does it know holes?
    pub knows_holes: bool,
    pub(super) record: fn(&S) -> Box<dyn Run>,
    pub(super) takes: fn(&S) -> bool,
}

impl<S> MethodInfo<S> {
    /// Can it take the scene?
    #[must_use]
    pub fn takes(&self, scene: &S) -> bool {
        (self.takes)(scene)
    }

    /// Runs it on the scene; where it cannot take it, the run has no steps and says why.
    #[must_use]
    pub fn record(&self, scene: &S) -> Box<dyn Run> {
        (self.record)(scene)
    }
}
