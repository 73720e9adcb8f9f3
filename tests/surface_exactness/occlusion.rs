//! Occlusion queries: whatever is skipped, the picture is the same.

use clipscope::{
    algo::surface::{
        DepthBuffer, DepthBufferInput, Occlusion, OcclusionInput, OcclusionObject, Surfaces,
    },
    trace::{Recording, laws, silent},
};
use proptest::prelude::*;

use super::soup::{ahead, cases, soup, surfaces, volume};

/// Objects of two triangles each, the first few of them occluders.
fn in_pairs(surfaces: Surfaces, n_occluders: usize) -> OcclusionInput {
    let n = surfaces.triangles().len() as u32;
    let object = |(i, first): (usize, u32)| OcclusionObject {
        first,
        n_triangles: 2.min(n - first),
        is_occluder: i < n_occluders,
    };
    let objects = (0..n).step_by(2).enumerate().map(object).collect();
    OcclusionInput { surfaces, objects }
}

proptest! {
    #![proptest_config(cases(300))]

    #[test]
    fn no_visible_pixel_is_dropped(
        triangles in prop_oneof![soup(16), prop::collection::vec(ahead(), 1..16)],
        n_occluders in 0..4_usize, culls in any::<bool>(),
    ) {
        let input = in_pairs(surfaces(&triangles, culls), n_occluders);
        let output = silent::<Occlusion>(&input);
        let all = silent::<DepthBuffer>(&DepthBufferInput::new(input.surfaces));
        prop_assert_eq!(output.depth, all.depth);
        prop_assert_eq!(output.drawn.len() + output.skipped.len(), input.objects.len());
    }
}

proptest! {
    #![proptest_config(cases(16))]

    #[test]
    fn the_laws(triangles in soup(10), n_occluders in 0..3_usize) {
        laws::check::<Occlusion>(&in_pairs(surfaces(&triangles, false), n_occluders));
    }
}

#[test]
fn what_stands_behind_a_wall_is_skipped_and_what_looks_out_is_not() {
    let wall =
        |x: f64, z: f64, size: f64| [[x - size, -size, z], [x + size, -size, z], [x, size, z]];
    // Behind the wall, beside it, before it, and around the eye.
    let others = [
        wall(0.0, -6.0, 0.3),
        wall(4.0, -6.0, 0.5),
        wall(0.0, -2.0, 0.3),
    ];
    let around = [[-1.0, -1.0, 1.0], [1.0, -1.0, 1.0], [0.0, 1.0, -9.0]];
    let triangles: Vec<_> = [wall(0.0, -3.0, 2.0)]
        .into_iter()
        .chain(others)
        .chain([around])
        .collect();
    let surfaces = Surfaces::new([32, 32], volume(), triangles, false).expect("finite");
    let object = |first| OcclusionObject {
        first,
        n_triangles: 1,
        is_occluder: first == 0,
    };
    let input = OcclusionInput {
        surfaces,
        objects: (0..5).map(object).collect(),
    };
    let recording = Recording::<Occlusion>::new(input);
    let held = recording.held();
    assert_eq!(held.drawn, [0, 2, 3, 4]);
    assert_eq!(held.skipped, [1]);
}
