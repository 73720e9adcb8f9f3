//! The lab and its methods. To add one: a file in `algo::polygon`, its [`PolygonTelling`] beside the others, one
//! line below.

use crate::{
    algo::{
        polygon::{
            EarClipping, Pipeline, SutherlandHodgman, TriangulateAndClip,
            faulty::{CutsTwice, DropsOnBorder, EndFirst, Faulty, LeavesOpen, WalksClockwise},
            weiler_atherton::WeilerAtherton,
        },
        why::{Bridge, Why},
    },
    labs::{Lab, Listed, MethodCard, MethodEntry, window_handles},
};

use super::{
    Method, MethodInfo, PolygonTelling, Scene,
    change::OUTLINES,
    verdict::{fate, found},
};

pub static LAB: &Lab = &Lab {
    id: "polygons",
    name_key: "lab-polygons",
    about_key: "lab-polygons-about",
    recording_key: "recording-vertices",
    methods: || Method::all().map(Method::card).collect(),
    first_scene: || Scene::first().into(),
    smallest_scene: || Scene::smallest().into(),
    lock_groups: &["polygon", window_handles::GROUP, "clip"],
    controls: Vec::new,
    adopt: |_| None,
    outlines: &OUTLINES,
};

const fn info<M: PolygonTelling>() -> MethodEntry<MethodInfo> {
    MethodEntry {
        card: MethodCard::of::<M>(),
        info: MethodInfo {
            clips: M::CLIPS,
            carries_texture: M::CARRIES_TEXTURE,
            given: M::GIVEN,
            knows_holes: M::KNOWS_HOLES,
            record: |scene| {
                M::record(scene).unwrap_or_else(|refusal| refusal.run(scene, M::SUBJECT))
            },
            takes: |scene| M::input(scene).is_ok(),
            unfit_hole: |scene| M::input(scene).err()?.hole(),
            fate: fate::<M>,
            found: found::<M>,
        },
    }
}

/// Every method, in the order in which they are taught.
pub static METHODS: [MethodEntry<MethodInfo>; 11] = [
    info::<SutherlandHodgman>(),
    info::<Pipeline>(),
    info::<WeilerAtherton>(),
    info::<EarClipping>(),
    info::<TriangulateAndClip>(),
    info::<Why<Bridge>>(),
    info::<Faulty<DropsOnBorder>>(),
    info::<Faulty<LeavesOpen>>(),
    info::<Faulty<WalksClockwise>>(),
    info::<Faulty<CutsTwice>>(),
    info::<Faulty<EndFirst>>(),
];

impl Listed for MethodInfo {
    fn all() -> &'static [MethodEntry<Self>] {
        &METHODS
    }
}
