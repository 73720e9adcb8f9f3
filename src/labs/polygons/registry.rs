//! The methods of this lab. To add one: a file in `algo::polygon`, its [`PolygonDemo`] beside the others, one
//! line below.

use crate::{
    algo::polygon,
    labs::{Carded, Listed, MethodCard},
};

use super::{
    MethodInfo, PolygonDemo, PolygonTelling, Scene,
    methods::faulty,
    verdict::{fate, fate_told, found, found_told},
};

const fn info<A: PolygonDemo>() -> MethodInfo<Scene> {
    MethodInfo {
        card: MethodCard::of::<A>(),
        clips: A::CLIPS,
        carries_texture: A::CARRIES_TEXTURE,
        given: A::GIVEN,
        knows_holes: A::KNOWS_HOLES,
        record: |scene| A::record(scene).unwrap_or_else(|refusal| refusal.run(scene, A::SUBJECT)),
        takes: |scene| A::input(scene).is_ok(),
        fate: fate::<A>,
        found: found::<A>,
    }
}

const fn told<M: PolygonTelling>() -> MethodInfo<Scene> {
    MethodInfo {
        card: MethodCard::told::<M>(),
        clips: M::CLIPS,
        carries_texture: M::CARRIES_TEXTURE,
        given: M::GIVEN,
        knows_holes: M::KNOWS_HOLES,
        record: |scene| M::record(scene).unwrap_or_else(|refusal| refusal.run(scene, M::SUBJECT)),
        takes: |scene| M::input(scene).is_ok(),
        fate: fate_told::<M>,
        found: found_told::<M>,
    }
}

/// Every method, in the order in which they are taught.
pub static METHODS: [MethodInfo<Scene>; 10] = [
    told::<polygon::SutherlandHodgman>(),
    told::<polygon::Pipeline>(),
    info::<polygon::weiler_atherton::WeilerAtherton>(),
    info::<polygon::EarClipping>(),
    info::<polygon::TriangulateAndClip>(),
    told::<faulty::OnBorder>(),
    told::<faulty::Open>(),
    told::<faulty::Clockwise>(),
    told::<faulty::Twice>(),
    told::<faulty::EndBeforeCrossing>(),
];

impl Carded for MethodInfo<Scene> {
    fn card(&self) -> &MethodCard {
        &self.card
    }
}

impl Listed for MethodInfo<Scene> {
    fn all() -> &'static [Self] {
        &METHODS
    }
}
