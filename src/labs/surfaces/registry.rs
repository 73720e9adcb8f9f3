//! The lab and its methods. To add one: a file in `algo::surface`, its [`SpaceTelling`] in `methods/` beside the others, one
//! line below.

use std::sync::Arc;

use crate::{
    algo::{
        surface::{
            Bsp, DepthBuffer, Occlusion, Painter, RayCasting,
            faulty::{
                ClearsToNear, KeysOnly, NearestKeys, StraightDistance, TurnsComparison,
                WritesAlways,
            },
        },
        why::{CrossesOnce, Fence, Why},
    },
    geom::{Mesh, Orbit},
    labs::{
        Lab, MethodEntry,
        space::{
            Method, MethodInfo, Model, NamedMesh, Object, Opening, Scene, SpaceLab, SpaceTelling,
            TaughtCamera, controls, demo,
        },
    },
};

use super::verdict::verdict;

pub static SURFACES: SpaceLab = SpaceLab {
    lab: Lab {
        id: "surfaces",
        name_key: "lab-surfaces",
        about_key: "lab-surfaces-about",
        recording_key: "recording-triangles",
        methods: || SURFACES.all().map(Method::card).collect(),
        first_scene: || first_scene().into(),
        smallest_scene: || first_scene().alone().into(),
        lock_groups: &["camera", "volume", "object"],
        controls: || controls::ids(&["camera", "object", "raster"]),
        adopt: |scene| SURFACES.adopted(scene),
        outlines: &[],
    },
    // One of each way to find who is in front.
    most_beside: 2,
    methods: || &METHODS,
    verdict,
};

pub static LAB: &Lab = &SURFACES.lab;

const fn told<M: SpaceTelling>() -> MethodEntry<MethodInfo> {
    demo::told::<M, M>(&SURFACES)
}

const fn wrong<M: SpaceTelling, Right>() -> MethodEntry<MethodInfo>
where
    Right: SpaceTelling<Input = M::Input, Event = M::Event>,
{
    demo::told::<M, Right>(&SURFACES)
}

pub static METHODS: [MethodEntry<MethodInfo>; 13] = [
    told::<DepthBuffer>(),
    told::<RayCasting>(),
    told::<Painter>(),
    told::<Bsp>(),
    told::<Occlusion>(),
    told::<Why<Fence>>(),
    told::<Why<CrossesOnce>>(),
    wrong::<DepthBuffer<ClearsToNear>, DepthBuffer>(),
    wrong::<DepthBuffer<TurnsComparison>, DepthBuffer>(),
    wrong::<DepthBuffer<WritesAlways>, DepthBuffer>(),
    wrong::<DepthBuffer<StraightDistance>, DepthBuffer>(),
    wrong::<Painter<NearestKeys>, Painter>(),
    wrong::<Painter<KeysOnly>, Painter>(),
];

/// What the lab opens on where there is no lesson: two triangles, one through the other.
///
/// # Panics
/// Never: its numbers are valid.
pub fn first_scene() -> Scene {
    let method = SURFACES.method("depth-buffer").expect("in the registry");
    let camera = TaughtCamera::new(
        [[0.0, 0.0, 6.0], [0.0; 3], [0.0, 1.0, 0.0]],
        Opening::FovY(40.0),
        4.0 / 3.0,
        [3.0, 9.0],
    );
    let eye = Orbit::new([0.0, 0.0, 1.0], [52.0, 22.0], 20.0, 26.0);
    let triangle = |name: &str, corners: [[f32; 3]; 3]| {
        let mesh = Mesh::new(corners.to_vec(), Vec::new(), vec![[0, 1, 2]]).expect("a triangle");
        let named = NamedMesh {
            name: name.to_owned(),
            mesh,
            picture: None,
        };
        Object::new(Model::Mesh(Arc::new(named)), [0.0; 3], [0.0; 3], 1.0).expect("finite")
    };
    let objects = vec![
        triangle(
            "A",
            [[-2.0, -1.5, 1.0], [1.5, -1.0, -2.0], [-1.0, 1.75, -1.0]],
        ),
        triangle(
            "B",
            [[-1.75, 0.25, -1.5], [2.0, -1.25, 1.0], [1.75, 1.5, 1.0]],
        ),
    ];
    let camera = camera.expect("constants that are valid");
    Scene::new(method, camera, eye, objects).expect("objects")
}
