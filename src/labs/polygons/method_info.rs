//! What the lab knows of a method: the same whatever it runs on.

use crate::{figure::Run, geom::Point, labs::MethodCard};

/// How the subject is seen under a method's drawing, before its end.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum GivenSubject {
    /// As it is.
    Whole,
    /// As cut off, but for what the drawing outlines: the list that the method works on.
    CutOff,
}

/// What becomes of a vertex of the subject.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct VertexFate {
    /// The step that decided it.
    pub step: usize,
    /// Is it kept?
    pub is_kept: bool,
    /// The clip edge that was asked there, where one is asked at a time.
    pub border: Option<usize>,
}

/// Something that a run finds on its way, and the step at which it does.
#[derive(Clone, PartialEq, Debug)]
pub enum Found {
    /// An intersection.
    Crossing {
        /// At which step.
        step: usize,
        /// Where.
        at: Point,
    },
    /// A piece of the answer.
    Piece {
        /// At which step.
        step: usize,
        /// Around it.
        outline: Vec<Point>,
    },
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
    pub(super) fate: fn(&S, Point) -> Option<VertexFate>,
    pub(super) found: fn(&S) -> Vec<Found>,
}

impl<S> MethodInfo<S> {
    /// Can it take the scene?
    #[must_use]
    pub fn takes(&self, scene: &S) -> bool {
        (self.takes)(scene)
    }

    /// What becomes of a vertex of the subject that lies there.
    #[must_use]
    pub fn fate(&self, scene: &S, at: Point) -> Option<VertexFate> {
        (self.fate)(scene, at)
    }

    /// The intersections and the pieces that its run finds.
    #[must_use]
    pub fn found(&self, scene: &S) -> Vec<Found> {
        (self.found)(scene)
    }

    /// Runs it on the scene; where it cannot take it, the run has no steps and says why.
    #[must_use]
    pub fn record(&self, scene: &S) -> Box<dyn Run> {
        (self.record)(scene)
    }
}
