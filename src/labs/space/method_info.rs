//! What the lab knows of a method: the same whatever it runs on.

use crate::{
    figure::{Link, Run},
    geom::VolumeSide,
    labs::{Carded, MethodCard, Verdict},
};

use super::{Scene, SpaceDemo, SpaceLab, Subject};

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
pub struct MethodInfo {
    /// Whose it is.
    pub lab: &'static SpaceLab,
    /// Names, source and pseudocode.
    pub card: MethodCard,
    /// What it is about.
    pub subject: Subject,
    /// Can it say what became of a face of the object in focus?
    pub tells_faces: bool,
    /// Runs it on a scene.
    pub record: fn(&Scene) -> Box<dyn Run>,
    /// The step that decided the fate of a face of the object in focus.
    pub face_fate: fn(&Scene, usize) -> Option<FaceFate>,
    /// What decided the fate of something, in a run of it; none where only the lab knows.
    pub verdict: fn(&Scene, Link, &dyn Run) -> Option<Verdict>,
}

impl MethodInfo {
    /// Of a method of this lab.
    pub(in crate::labs) const fn of<A: SpaceDemo>(lab: &'static SpaceLab) -> Self {
        Self {
            lab,
            card: MethodCard::of::<A>(),
            subject: A::SUBJECT,
            tells_faces: A::TELLS_FACES,
            record: A::record,
            face_fate: A::face_fate,
            verdict: A::verdict,
        }
    }
}

impl Carded for MethodInfo {
    fn card(&self) -> &MethodCard {
        &self.card
    }
}
