//! The lab and its methods. To add one: a file in `algo::cull` or `algo::volume`, its [`SpaceTelling`] in `methods/` beside
//! the others, one line below.

use crate::{
    algo::{
        cull::{
            BoxCull, Funnel, PointPlanes, SphereCull,
            faulty::{AroundOrigin, Clockwise, ConstantView, OneAngle, TurnsSign},
        },
        pipeline::{LineToPixels, ViewingPipeline},
        volume::{
            CohenSutherland3d, HomogeneousLine, LiangBarsky3d, PlaneLine,
            faulty::{
                AllSides, DividedLine, DividesFirst, DropsOnPlane, EdgeByEdge, KeepsPlaceInTexture,
                MissesEdge,
            },
        },
        why::{ErrorTerm, Facing, ProjectionRow, QuarterTurn, Shadow, Similar, Why},
    },
    geom::{Orbit, Solid},
    labs::{
        Lab, MethodEntry,
        frustum::prelude::*,
        space::{
            Method, MethodInfo, Model, Object, Opening, SpaceLab, TaughtCamera, controls, demo,
        },
    },
};

use super::{
    methods::{EvenOnScreen, WithTexture},
    verdict::verdict,
};

pub static FRUSTUM: SpaceLab = SpaceLab {
    lab: Lab {
        id: "frustum",
        name_key: "lab-frustum",
        about_key: "lab-frustum-about",
        recording_key: "recording-triangles",
        methods: || FRUSTUM.all().map(Method::card).collect(),
        first_scene: || first_scene().into(),
        smallest_scene: || first_scene().alone().into(),
        lock_groups: &["camera", "volume", "object", "point", "segment", "triangle"],
        controls: || controls::ids(&["camera", "object", "point", "segment", "triangle"]),
        adopt: |scene| FRUSTUM.adopted(scene),
        outlines: &[],
    },
    most_beside: 1,
    methods: || &METHODS,
    verdict,
};

pub static LAB: &Lab = &FRUSTUM.lab;

/// A triangle in clip space, where its texture is a part of the scene.
type Triangle<L = Right> = HomogeneousTriangle<Option<[f64; 2]>, L>;

const fn told<M: SpaceTelling>() -> MethodEntry<MethodInfo> {
    demo::told::<M, M>(&FRUSTUM)
}

const fn wrong<M: SpaceTelling, Right>() -> MethodEntry<MethodInfo>
where
    Right: SpaceTelling<Input = M::Input, Event = M::Event>,
{
    demo::told::<M, Right>(&FRUSTUM)
}

/// Every method, in the order in which they are taught; the mistakes last.
pub static METHODS: [MethodEntry<MethodInfo>; 34] = [
    told::<PointPlanes>(),
    told::<SphereCull>(),
    told::<BoxCull>(),
    told::<BackFace>(),
    told::<Funnel>(),
    told::<CohenSutherland3d>(),
    told::<LiangBarsky3d>(),
    told::<PlaneLine>(),
    told::<HomogeneousLine>(),
    told::<PlaneAtATime>(),
    told::<IntersectionPolygon>(),
    told::<IntersectionPolygon<WithTexture>>(),
    told::<IntersectionPolygon<EvenOnScreen>>(),
    told::<Triangle>(),
    told::<ViewingPipeline>(),
    told::<LineToPixels>(),
    told::<Why<QuarterTurn>>(),
    told::<Why<Shadow>>(),
    told::<Why<Similar>>(),
    told::<Why<ProjectionRow>>(),
    told::<Why<Facing>>(),
    told::<Why<ErrorTerm>>(),
    wrong::<Funnel<OneAngle>, Funnel>(),
    wrong::<Funnel<TurnsSign>, Funnel>(),
    wrong::<Funnel<AroundOrigin>, Funnel>(),
    wrong::<Funnel<Clockwise>, Funnel>(),
    wrong::<Funnel<ConstantView>, Funnel>(),
    wrong::<DividedLine, HomogeneousLine>(),
    wrong::<PlaneAtATime<MissesEdge>, PlaneAtATime>(),
    wrong::<IntersectionPolygon<DropsOnPlane>, IntersectionPolygon>(),
    wrong::<IntersectionPolygon<KeepsPlaceInTexture>, IntersectionPolygon>(),
    wrong::<IntersectionPolygon<EdgeByEdge>, IntersectionPolygon>(),
    wrong::<Triangle<AllSides>, Triangle>(),
    wrong::<Triangle<DividesFirst>, Triangle>(),
];

/// # Panics
/// Never: its numbers are valid.
pub fn first_scene() -> Scene {
    let method = FRUSTUM.method("funnel").expect("in the registry");
    let camera = TaughtCamera::new(
        [[0.0, 2.0, 6.0], [0.0, 1.0, -2.0], [0.0, 1.0, 0.0]],
        Opening::FovY(40.0),
        1.6,
        [2.0, 13.0],
    );
    let eye = Orbit::new([0.6, 1.2, -1.2], [34.0, 25.0], 33.0, 26.0);
    let object = |solid, at, turn, size| {
        Object::new(Model::Solid(solid), at, [0.0, turn, 0.0], size).expect("finite")
    };
    let objects = vec![
        object(Solid::Cube, [-0.4, 0.9, 0.2], 20.0, 0.6),
        object(Solid::Octahedron, [1.6, 2.4, -2.5], 0.0, 0.9),
        object(Solid::Cube, [3.0, 0.75, -1.5], 10.0, 0.75),
        object(Solid::Tetrahedron, [-1.8, 1.4, -6.6], 30.0, 0.8),
        object(Solid::Cube, [-6.5, 0.8, 0.5], 35.0, 0.8),
        object(Solid::Octahedron, [3.2, 1.0, 8.0], 15.0, 0.8),
    ];
    let camera = camera.expect("constants that are valid");
    Scene::new(method, camera, eye, objects).expect("objects")
}
