//! What the lab knows of a method: the same whatever it runs on.

use crate::{figure::Run, geom::VolumeSide, labs::MethodCard, trace::Counts};

use super::Subject;

/// What was asked of a face when its fate was decided.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum FaceTest {
    /// The sphere of its object, which was culled whole.
    Sphere,
    /// Its corners: all of them lie beyond this plane.
    Corners(VolumeSide),
    /// Its corners: it crosses planes, and nothing of it was left when they had cut it.
    Cut,
    /// Which side it shows.
    Facing,
}

/// The step that decided a face's fate.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct FaceFate {
    /// Where in the run.
    pub step: usize,
    /// What was asked there.
    pub test: FaceTest,
}

/// What is known of a method without running it.
pub struct MethodInfo<S> {
    /// Names, source and pseudocode.
    pub card: MethodCard,
    /// What it is about.
    pub subject: Subject,
    /// Can it say what became of a face of the object in focus?
    pub tells_faces: bool,
    pub(super) record: fn(&S) -> Box<dyn Run>,
    pub(super) cost: fn(&S) -> Counts,
    pub(super) face_fate: fn(&S, usize) -> Option<FaceFate>,
}

impl<S> MethodInfo<S> {
    /// Runs it on a scene.
    #[must_use]
    pub fn record(&self, scene: &S) -> Box<dyn Run> {
        (self.record)(scene)
    }

    /// The step that decided the fate of a face of the object in focus.
    #[must_use]
    pub fn face_fate(&self, scene: &S, face_idx: usize) -> Option<FaceFate> {
        (self.face_fate)(scene, face_idx)
    }

    /// How many operations it takes, without recording the steps.
    #[must_use]
    pub fn cost(&self, scene: &S) -> Counts {
        (self.cost)(scene)
    }
}
