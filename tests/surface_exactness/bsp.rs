//! The tree of planes: there is always an order of its pieces.

use clipscope::{
    algo::surface::{
        Bsp, BspChoice, BspEvent, BspInput, BspTooLarge, DepthBuffer, DepthBufferInput, Painter,
        PainterAnswer, Surfaces,
    },
    geom::Solid,
    trace::{Recording, laws, silent},
};
use proptest::prelude::*;

use super::{
    oracle::{Seen, pixels, seen},
    soup::{cases, of_mesh, soup, surfaces, three_bars, volume, volumes},
};

fn input(surfaces: Surfaces, choice: BspChoice) -> BspInput {
    BspInput::new(surfaces, choice).expect("small")
}

fn choices() -> impl Strategy<Value = BspChoice> {
    prop::sample::select(vec![BspChoice::First, BspChoice::FewestCuts])
}

/// Twice a flat polygon's area.
fn double_area(polygon: &[[f64; 3]]) -> f64 {
    let fan = polygon[1..].windows(2).map(|pair| {
        let [u, v]: [[f64; 3]; 2] =
            [pair[0], pair[1]].map(|p| std::array::from_fn(|i| p[i] - polygon[0][i]));
        [
            u[1] * v[2] - u[2] * v[1],
            u[2] * v[0] - u[0] * v[2],
            u[0] * v[1] - u[1] * v[0],
        ]
    });
    let sum = fan.fold([0.0; 3], |sum, n| std::array::from_fn(|i| sum[i] + n[i]));
    sum.iter().map(|x| x * x).sum::<f64>().sqrt()
}

proptest! {
    #![proptest_config(cases(300))]

    #[test]
    fn every_middle_is_that_of_the_nearest(triangles in soup(14), culls in any::<bool>(), choice in choices()) {
        let output = silent::<Bsp>(&input(surfaces(&triangles, culls), choice));
        for pixel in pixels() {
            match seen(&triangles, culls, pixel) {
                Seen::Unsure => {}
                Seen::Nothing => prop_assert_eq!(output.picture.at(pixel), None, "{:?}", pixel),
                Seen::Surface { id, .. } => prop_assert_eq!(output.picture.at(pixel), Some(id), "{:?}", pixel),
            }
        }
    }

    #[test]
    fn pieces_are_the_triangles(triangles in soup(9), choice in choices()) {
        let trace = Recording::<Bsp>::new(input(surfaces(&triangles, false), choice));
        let painted: Vec<u32> = trace.events().iter().filter_map(|event| match *event {
            BspEvent::Paint { piece, .. } => Some(piece),
            _ => None,
        }).collect();
        prop_assert_eq!(painted.len(), trace.output().n_pieces);
        let mut areas = vec![0.0; triangles.len()];
        for piece in painted {
            let piece = &trace.held().pieces[piece as usize];
            areas[piece.id as usize] += double_area(&piece.polygon);
        }
        for (area, triangle) in areas.iter().zip(super::soup::placed(&triangles)) {
            let expected = double_area(&triangle);
            prop_assert!((area - expected).abs() < 1e-6 * expected.max(1.0), "{area} {expected}");
        }
    }
}

proptest! {
    #![proptest_config(cases(16))]

    #[test]
    fn the_laws(triangles in soup(6), choice in choices()) {
        laws::check::<Bsp>(&input(surfaces(&triangles, false), choice));
    }
}

#[test]
fn a_convex_solid_is_not_cut() {
    for solid in [Solid::Cube, Solid::Octahedron, Solid::Sphere] {
        for volume in volumes() {
            let surfaces = of_mesh(solid, volume, [48, 32], false);
            let depths = silent::<DepthBuffer>(&DepthBufferInput::new(surfaces.clone()));
            let n = surfaces.triangles().len();
            let output = silent::<Bsp>(&input(surfaces, BspChoice::First));
            assert_eq!(output.picture, depths.picture, "{solid:?}");
            // The faces of a ball have four corners that are not quite in one plane.
            assert!(
                solid == Solid::Sphere || output.n_pieces == n,
                "{solid:?} {}",
                output.n_pieces
            );
        }
    }
}

#[test]
fn all_solids_come_out_whole() {
    for solid in Solid::ALL {
        for volume in volumes() {
            let surfaces = of_mesh(solid, volume, [48, 32], true);
            let depths = silent::<DepthBuffer>(&DepthBufferInput::new(surfaces.clone()));
            let output = silent::<Bsp>(&input(surfaces, BspChoice::FewestCuts));
            assert_eq!(output.picture, depths.picture, "{solid:?}");
        }
    }
}

#[test]
fn cuts_resolve_the_cycle_of_three() {
    let surfaces = Surfaces::new([16, 16], volume(), three_bars(), false).expect("finite");
    assert!(matches!(
        silent::<Painter>(&surfaces).answer,
        PainterAnswer::Cycle { .. }
    ));
    let depths = silent::<DepthBuffer>(&DepthBufferInput::new(surfaces.clone()));
    let trace = Recording::<Bsp>::new(input(surfaces, BspChoice::FewestCuts));
    assert!(trace.output().n_pieces > 3);
    assert_eq!(trace.output().picture, depths.picture);
    let cuts = trace
        .events()
        .iter()
        .filter(|event| matches!(event, BspEvent::Ask { parts: Some(_), .. }));
    assert_eq!(cuts.count(), trace.output().n_pieces - 3);
}

#[test]
fn in_one_plane_the_lower_id_is_seen() {
    let wall = |x: f64| [[x - 2.0, -2.0, -4.0], [x + 2.0, -2.0, -4.0], [x, 2.0, -4.0]];
    let turned = |[a, b, c]: [[f64; 3]; 3]| [a, c, b];
    for walls in [[wall(0.0), wall(0.5)], [wall(0.5), turned(wall(0.0))]] {
        let surfaces = Surfaces::new([16, 16], volume(), walls, false).expect("finite");
        let depths = silent::<DepthBuffer>(&DepthBufferInput::new(surfaces.clone()));
        let output = silent::<Bsp>(&input(surfaces, BspChoice::First));
        assert_eq!((output.n_pieces, output.picture), (2, depths.picture));
    }
}

#[test]
fn what_grows_too_large_is_refused() {
    // Upright leaves about one axis, and as many about another: each of one kind is cut by each of the other.
    let leaves = |n: i32| {
        let leaf = move |i: i32| {
            let slope = f64::from(i) / f64::from(n);
            let far = 30.0;
            [
                [
                    [-far, slope * -far, -40.0],
                    [far, slope * far, -40.0],
                    [slope, 0.0, -2.0],
                ],
                [
                    [slope * -far, -far, -41.0],
                    [slope * far, far, -41.0],
                    [0.0, slope, -2.5],
                ],
            ]
        };
        (0..n).flat_map(leaf).collect::<Vec<_>>()
    };
    let small = Surfaces::new([8, 8], volume(), leaves(4), false).expect("finite");
    assert!(BspInput::new(small, BspChoice::First).is_ok());
    let large = Surfaces::new([8, 8], volume(), leaves(400), false).expect("finite");
    assert_eq!(BspInput::new(large, BspChoice::First), Err(BspTooLarge));
}
