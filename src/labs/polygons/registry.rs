//! The lab and its methods. To add one: a file in `algo::polygon`, its [`PolygonDemo`] beside the others, one
//! line below.

use crate::{
    algo::polygon,
    labs::{self, Lab, Listed, MethodCard, MethodEntry, OutlineKind, window_handles},
};

use super::{
    Method, MethodInfo, PolygonDemo, Scene,
    change::OUTLINES,
    methods::faulty,
    verdict::{fate, found},
};

/// A polygon against a window or another polygon.
pub static LAB: &dyn Lab = &Polygons;

struct Polygons;

impl Lab for Polygons {
    fn id(&self) -> &'static str {
        "polygons"
    }

    fn name_key(&self) -> &'static str {
        "lab-polygons"
    }

    fn about_key(&self) -> &'static str {
        "lab-polygons-about"
    }

    fn methods(&self) -> Vec<&'static MethodCard> {
        Method::all().map(Method::card).collect()
    }

    fn first_scene(&self) -> labs::Scene {
        Scene::first().into()
    }

    fn lock_groups(&self) -> &'static [&'static str] {
        &["polygon", window_handles::GROUP, "clip"]
    }

    fn outlines(&self) -> &'static [OutlineKind] {
        &OUTLINES
    }
}

const fn info<A: PolygonDemo>() -> MethodEntry<MethodInfo> {
    MethodEntry {
        card: MethodCard::of::<A>(),
        info: MethodInfo {
            clips: A::CLIPS,
            carries_texture: A::CARRIES_TEXTURE,
            given: A::GIVEN,
            knows_holes: A::KNOWS_HOLES,
            record: |scene| {
                A::record(scene).unwrap_or_else(|refusal| refusal.run(scene, A::SUBJECT))
            },
            takes: |scene| A::input(scene).is_ok(),
            fate: fate::<A>,
            found: found::<A>,
        },
    }
}

/// Every method, in the order in which they are taught.
pub static METHODS: [MethodEntry<MethodInfo>; 10] = [
    info::<polygon::SutherlandHodgman>(),
    info::<polygon::Pipeline>(),
    info::<polygon::weiler_atherton::WeilerAtherton>(),
    info::<polygon::EarClipping>(),
    info::<polygon::TriangulateAndClip>(),
    info::<faulty::OnBorder>(),
    info::<faulty::Open>(),
    info::<faulty::Clockwise>(),
    info::<faulty::Twice>(),
    info::<faulty::EndBeforeCrossing>(),
];

impl Listed for MethodInfo {
    fn all() -> &'static [MethodEntry<Self>] {
        &METHODS
    }
}
