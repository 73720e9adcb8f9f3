//! The methods of this lab. To add one: a file in `algo::cull`, its [`FrustumDemo`] here beside the others, one line below.

use crate::{
    algo::{
        cull::{
            BackFace, BoxCull, Funnel, PointPlanes, SphereCull,
            faulty::{AroundOrigin, Clockwise, ConstantView, FaultyFunnel, OneAngle, TurnsSign},
        },
        pipeline::{LineToPixels, ViewingPipeline},
        volume::{
            CohenSutherland3d, HomogeneousLine, HomogeneousTriangle, IntersectionPolygon,
            LiangBarsky3d, PlaneAtATime, PlaneLine,
            faulty::{
                AllSides, DividedLine, DividesFirst, DropsOnPlane, EdgeByEdge, KeepsPlaceInTexture,
                MissesEdge,
            },
        },
    },
    labs::{Listed, MethodCard},
    trace::{Counted, Counts},
};

use super::{MethodInfo, OnScene, Scene, demo::FrustumDemo, methods::WithTexture};

const fn info<A: FrustumDemo>() -> MethodInfo<Scene> {
    MethodInfo {
        card: MethodCard::of::<A>(),
        subject: A::SUBJECT,
        tells_faces: A::TELLS_FACES,
        record: A::record,
        face_fate: A::face_fate,
        cost: |scene| {
            let input = A::input(scene);
            Counts::of(|| A::run::<Counted>(&input, |_| {})).1
        },
    }
}

/// Every method, in the order in which they are taught; the mistakes last.
pub static METHODS: [MethodInfo<Scene>; 27] = [
    info::<OnScene<PointPlanes>>(),
    info::<OnScene<SphereCull>>(),
    info::<OnScene<BoxCull>>(),
    info::<OnScene<BackFace>>(),
    info::<OnScene<Funnel>>(),
    info::<OnScene<CohenSutherland3d>>(),
    info::<OnScene<LiangBarsky3d>>(),
    info::<OnScene<PlaneLine>>(),
    info::<OnScene<HomogeneousLine>>(),
    info::<OnScene<PlaneAtATime>>(),
    info::<OnScene<IntersectionPolygon>>(),
    info::<OnScene<IntersectionPolygon<WithTexture>>>(),
    info::<OnScene<HomogeneousTriangle<Option<[f64; 2]>>>>(),
    info::<OnScene<ViewingPipeline>>(),
    info::<OnScene<LineToPixels>>(),
    info::<OnScene<FaultyFunnel<OneAngle>>>(),
    info::<OnScene<FaultyFunnel<TurnsSign>>>(),
    info::<OnScene<FaultyFunnel<AroundOrigin>>>(),
    info::<OnScene<FaultyFunnel<Clockwise>>>(),
    info::<OnScene<FaultyFunnel<ConstantView>>>(),
    info::<OnScene<DividedLine>>(),
    info::<OnScene<PlaneAtATime<MissesEdge>>>(),
    info::<OnScene<IntersectionPolygon<DropsOnPlane>>>(),
    info::<OnScene<IntersectionPolygon<KeepsPlaceInTexture>>>(),
    info::<OnScene<IntersectionPolygon<EdgeByEdge>>>(),
    info::<OnScene<HomogeneousTriangle<Option<[f64; 2]>, AllSides>>>(),
    info::<OnScene<HomogeneousTriangle<Option<[f64; 2]>, DividesFirst>>>(),
];

impl Listed for MethodInfo<Scene> {
    fn all() -> &'static [Self] {
        &METHODS
    }

    fn card(&self) -> &MethodCard {
        &self.card
    }
}
