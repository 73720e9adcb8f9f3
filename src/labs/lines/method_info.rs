//! What the lab knows of a method: the same whatever it runs on.

use crate::{
    algo::line::Visible,
    figure::Run,
    geom::{HalfPlane, Segment},
    labs::MethodCard,
    text::Value,
    trace::Counts,
};

/// What is known of a method without running it.
pub struct MethodInfo<S> {
    /// Names, source and pseudocode.
    pub card: MethodCard,
    /// Can it clip against any convex polygon?
    pub takes_polygon: bool,
    /// Does it write outcodes, so that the order of their bits matters?
    pub writes_codes: bool,
    pub(super) record: fn(&S, Segment) -> Box<dyn Run>,
    pub(super) clip: fn(&S, Segment) -> Visible,
    pub(super) cost: fn(&S, Segment) -> (Visible, Counts),
    pub(super) decided: fn(&S, Segment) -> Decided,
    pub(super) pass: fn(&S, &[Segment]) -> Pass,
}

/// What decided a segment's fate in one method's run.
#[derive(Clone, PartialEq, Debug)]
pub struct Decided {
    /// The step of the test that decided it.
    pub step: usize,
    /// The border that rejects it.
    pub rejected_by: Option<usize>,
    /// The borders that it comes in and goes out by, where it comes in only after it has gone out.
    pub between: Option<[Value; 2]>,
    /// The borders of what this method clips against, and their names.
    pub borders: Vec<(HalfPlane, Value)>,
}

/// Clips a batch, the same one each time it is called; the number of segments that are visible.
pub type Pass = Box<dyn FnMut() -> usize>;

impl<S> MethodInfo<S> {
    /// Runs it on one segment of the scene.
    #[must_use]
    pub fn record(&self, scene: &S, segment: Segment) -> Box<dyn Run> {
        (self.record)(scene, segment)
    }

    /// Its answer for one segment of the scene, as a program would ask for it.
    #[must_use]
    pub fn clip(&self, scene: &S, segment: Segment) -> Visible {
        (self.clip)(scene, segment)
    }

    /// The same answer and how many operations it took, without recording the steps.
    #[must_use]
    pub fn cost(&self, scene: &S, segment: Segment) -> (Visible, Counts) {
        (self.cost)(scene, segment)
    }

    /// The test that decided one segment's fate.
    #[must_use]
    pub fn decided(&self, scene: &S, segment: Segment) -> Decided {
        (self.decided)(scene, segment)
    }

    /// Clips all `segments` silently each time it is called; the number of those that are visible.
    #[must_use]
    pub fn pass(&self, scene: &S, segments: &[Segment]) -> Pass {
        (self.pass)(scene, segments)
    }
}
