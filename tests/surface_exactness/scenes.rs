//! Scenes of many triangles, by every algorithm: a cow, and a street of boxes.

use std::path::Path;

use clipscope::{
    algo::surface::{
        Bsp, BspChoice, BspInput, DepthBuffer, DepthBufferInput, Hierarchy, Occlusion,
        OcclusionInput, OcclusionObject, Painter, PainterAnswer, Surfaces,
    },
    geom::{Camera, ViewVolume},
    labs::space::street,
    lesson::read_obj,
    trace::silent,
};

const SIZE: [u32; 2] = [96, 64];
const N_BOXES: usize = 40;

/// Triangles of the world as a camera at this place sees them.
fn seen_from(position: [f64; 3], target: [f64; 3], triangles: &[[[f64; 3]; 3]]) -> Surfaces {
    let volume = ViewVolume::perspective(50.0, 1.5, 0.25, 60.0).expect("a volume");
    let camera = Camera::new(position, target, [0.0, 1.0, 0.0], volume).expect("a camera");
    let view_from_world = camera.view_from_world();
    let seen = triangles
        .iter()
        .map(|triangle| triangle.map(|at| view_from_world.point(at)));
    Surfaces::new(SIZE, volume, seen.collect::<Vec<_>>(), true).expect("finite")
}

fn spot() -> Surfaces {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/meshes/spot/spot.obj");
    let bytes = std::fs::read(path).expect("the mesh is in the repository");
    let mesh = read_obj("spot.obj", &bytes).expect("a mesh").mesh.fitted();
    let faces = mesh.faces().iter().map(|&face| mesh.corners(face));
    seen_from([1.5, 0.9, -2.4], [0.0; 3], &faces.collect::<Vec<_>>())
}

fn boxes(seed: u64) -> Surfaces {
    let objects = street(N_BOXES, seed);
    let triangles: Vec<_> = objects
        .iter()
        .flat_map(|object| (0..12).filter_map(|face_idx| object.face(face_idx)))
        .collect();
    assert_eq!(triangles.len(), 12 * N_BOXES);
    seen_from([0.3, 1.7, 7.0], [-0.4, 0.8, -20.0], &triangles)
}

#[test]
fn rays_find_what_the_depth_buffer_keeps() {
    for surfaces in [spot(), boxes(5)] {
        let depths = silent::<DepthBuffer>(&DepthBufferInput::new(surfaces.clone()));
        let rays = Hierarchy::new(&surfaces).picture(&surfaces);
        // No edge of these passes through a middle, and none is as deep as another there.
        assert_eq!(depths.picture, rays.picture);
        assert!(depths.tally.pixels > 1000);
        for (one, other) in depths.depth.iter().zip(&rays.depth) {
            assert!(one == other || (one - other).abs() < 1e-12);
        }
    }
}

#[test]
fn an_order_paints_them() {
    let surfaces = boxes(5);
    let depths = silent::<DepthBuffer>(&DepthBufferInput::new(surfaces.clone()));
    let PainterAnswer::Order { picture, .. } = silent::<Painter>(&surfaces).answer else {
        panic!("boxes that stand apart have an order");
    };
    assert_eq!(picture, depths.picture);
    // A cow folds over herself: where there is an order, it is right.
    let surfaces = spot();
    let depths = silent::<DepthBuffer>(&DepthBufferInput::new(surfaces.clone()));
    match silent::<Painter>(&surfaces).answer {
        PainterAnswer::Order { picture, .. } => assert_eq!(picture, depths.picture),
        PainterAnswer::Cycle { cycle } => assert!(cycle.len() > 1),
    }
}

/// The two triangles of a box's side have planes that are one but for rounding. What the first has cut lies on the second with its
/// new corners, and once was put on the side on which rounding left more of them.
#[test]
fn a_tree_paints_streets() {
    for seed in 0..8 {
        let surfaces = boxes(seed);
        let depths = silent::<DepthBuffer>(&DepthBufferInput::new(surfaces.clone()));
        for choice in [BspChoice::First, BspChoice::FewestCuts] {
            let input = BspInput::new(surfaces.clone(), choice).expect("few enough");
            let picture = silent::<Bsp>(&input).picture;
            assert_eq!(picture, depths.picture, "street {seed}, {choice:?}");
        }
    }
}

#[test]
fn the_boxes_of_a_street_that_are_skipped_are_seen_nowhere() {
    let surfaces = boxes(5);
    let object = |i: usize| OcclusionObject {
        first: 12 * i as u32,
        n_triangles: 12,
        is_occluder: i < 8,
    };
    let objects: Vec<_> = (0..N_BOXES).map(object).collect();
    let all = silent::<DepthBuffer>(&DepthBufferInput::new(surfaces.clone()));
    let output = silent::<Occlusion>(&OcclusionInput { surfaces, objects });
    assert_eq!(output.depth, all.depth);
    assert!(!output.skipped.is_empty(), "some stand behind others");
}
