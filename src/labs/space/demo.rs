//! What a method of this lab has beyond any other that can be shown.

use crate::{
    figure::{Link, Run},
    labs::{self, Demo, MethodCard, MethodEntry, Verdict},
};

use super::{FaceFate, MethodInfo, Scene, SpaceLab, Subject};

/// A method of this lab.
pub trait SpaceDemo: Demo {
    /// What it is about.
    const SUBJECT: Subject = Subject::Object;

    /// Can it say what became of a face of the object in focus?
    const TELLS_FACES: bool = false;

    /// Its input, from the scene.
    fn input(scene: &Scene) -> Self::Input;

    /// Its card, where this scene changes its pseudocode.
    fn card(_: &Scene) -> Option<&'static MethodCard> {
        None
    }

    /// The step that decided the fate of a face of the object in focus, and what was asked there.
    fn face_fate(_: &Scene, _face_idx: usize) -> Option<FaceFate> {
        None
    }

    /// What decided the fate of a part of what it clips, in a run of it.
    fn verdict(_: &Scene, _about: Link, _run: &dyn Run) -> Option<Verdict> {
        None
    }

    /// Records its run.
    fn record(scene: &Scene) -> Box<dyn Run> {
        labs::record::<Self>(Self::input(scene))
    }
}

/// The line of a method in the table of its lab.
pub(in crate::labs) const fn entry<A: SpaceDemo>(
    lab: &'static SpaceLab<Scene>,
) -> MethodEntry<MethodInfo> {
    let info = MethodInfo {
        lab,
        card_on: A::card,
        subject: A::SUBJECT,
        tells_faces: A::TELLS_FACES,
        record: A::record,
        face_fate: A::face_fate,
        verdict: A::verdict,
    };
    let card = MethodCard::of::<A>();
    MethodEntry { card, info }
}
