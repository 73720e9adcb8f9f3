//! What a method of this lab has beyond any other that can be shown.

use std::sync::Arc;

use crate::labs::{MethodEntry, prelude::*};

use super::{MethodInfo, Scene, SpaceLab, Subject, stage::Scenery};

pub trait SpaceTelling: Telling<Scenery = Scenery> {
    const SUBJECT: Subject = Subject::Object;

    /// Can it say what became of a face of the object in focus?
    const TELLS_FACES: bool = false;

    fn input(scene: &Scene) -> Self::Input;

    /// Its card, where this scene changes its pseudocode.
    fn card(_: &Scene) -> Option<&'static MethodCard> {
        None
    }

    /// Of a method that makes a picture: which triangle each pixel shows, row by row, less than 0 for none.
    fn ids<'a>(_: &Step<'a, Self>) -> Option<&'a [i32]> {
        None
    }

    /// What decided the fate of a part of what it clips, in a run of it.
    fn verdict(_: &Scene, _about: Link, _run: &dyn Run) -> Option<Verdict> {
        None
    }
}

/// A method; of one that is wrong on purpose a run knows where it first differs from that of `Right`.
pub(in crate::labs) const fn told<A, Right>(lab: &'static SpaceLab) -> MethodEntry<MethodInfo>
where
    A: SpaceTelling,
    Right: SpaceTelling<Input = A::Input, Event = A::Event>,
{
    let info = MethodInfo {
        lab,
        card_on: A::card,
        subject: A::SUBJECT,
        tells_faces: A::TELLS_FACES,
        record: |scene| {
            let scenery = Arc::new(Scenery::new(scene));
            Box::new(Recorded::<A>::beside::<Right>(
                A::input(scene),
                Some(scenery),
            ))
        },
        verdict: A::verdict,
        shown_at: |scene, (step, place)| {
            let recording = Recording::<A>::new(A::input(scene));
            recording.at(step, |step| A::ids(step)?.get(place).copied())
        },
    };
    let card = MethodCard::of::<A>();
    MethodEntry { card, info }
}
