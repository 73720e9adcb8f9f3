//! What a method of this lab has beyond any other that can be shown.

use std::sync::Arc;

use crate::{
    figure::Caption,
    labs::{Document, MethodEntry, prelude::*, refused::RefusedRun},
};

use super::{
    MethodInfo, Scene, SpaceLab, Subject,
    stage::{Fate, Scenery},
};

pub trait SpaceTelling: Telling<Scenery = Scenery> {
    const SUBJECT: Subject = Subject::Object;

    /// The key of the heading under which lists have it, if it is neither a known mistake nor a proof.
    const GROUP_KEY: Option<&'static str> = Self::SUBJECT.group_key();

    /// Can it say what became of a face of the object in focus?
    const TELLS_FACES: bool = false;

    /// Of more faces it takes none: its work grows too fast with them.
    const MOST_FACES: usize = usize::MAX;

    fn input(scene: &Scene) -> Self::Input;

    /// Where it draws an end of the segment that lies at `at`.
    fn drawn(_: &Scene, at: [f64; 3]) -> [f64; 3] {
        at
    }

    /// Its card, where this scene changes its pseudocode.
    fn card(_: &Scene) -> Option<&'static MethodCard> {
        None
    }

    /// Of a method that makes a picture: which triangle a pixel of it shows, less than 0 for none.
    fn shown(_: &Step<'_, Self>, _place: usize) -> Option<i32> {
        None
    }

    /// What decided the fate of a part of what it clips, in a run of it.
    fn verdict(_: &Scene, _about: Link, _run: &dyn Run) -> Option<Verdict> {
        None
    }
}

fn too_many_faces(scenery: &Scenery, most: usize) -> RefusedRun {
    let message = Message::new("refused-too-many-faces").with("most", most);
    let message = message.with("triangles", scenery.scene().size());
    RefusedRun {
        code: "too-large",
        caption: Caption::new(message),
        views: vec![scenery.observer(|_| Fate::ToCome, Vec::new())],
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
        most_faces: A::MOST_FACES,
        record: |scene| {
            let scenery = Arc::new(Scenery::new(scene));
            if scene.size() > A::MOST_FACES {
                return Box::new(too_many_faces(&scenery, A::MOST_FACES));
            }
            Box::new(Recorded::<A>::beside::<Right>(
                A::input(scene),
                Some(scenery),
            ))
        },
        drawn: A::drawn,
        verdict: A::verdict,
        shown_at: |scene, (step, place)| {
            if scene.size() > A::MOST_FACES {
                return None;
            }
            let recording = Recording::<A>::new(A::input(scene));
            recording.at(step, |step| A::shown(step, place))
        },
    };
    let mut card = MethodCard::of::<A>();
    if card.group_key.is_none() {
        card.group_key = A::GROUP_KEY;
    }
    MethodEntry { card, info }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        labs::{space::street, surfaces},
        text::{Catalog, Lang},
    };

    #[test]
    fn a_scene_of_too_many_faces_is_refused_with_their_number_by_methods_of_pairs() {
        let mut scene = surfaces::first_scene();
        scene.set_objects(street(26, 1)).expect("not too many");
        for (id, is_taken) in [("painter", false), ("bsp", false), ("ray-casting", true)] {
            scene.set_method(id);
            assert_eq!(scene.takes(id), is_taken, "{id}");
            let run = scene.record().swap_remove(0);
            assert_eq!(run.is_refused(), !is_taken, "{id}");
            if !is_taken {
                let caption = run.frame(0).caption;
                let said = Catalog::of(Lang::En).message(&caption.decision);
                assert!(said.contains("312") && said.contains("300"), "{said}");
            }
        }
    }
}
