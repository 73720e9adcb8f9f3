//! Rays, with and without the boxes.

use clipscope::{
    algo::surface::{
        DepthBuffer, DepthBufferInput, Hierarchy, Meeting, Picture, RayCasting, RayCastingEvent,
        RayCastingInput, Rays, Surfaces,
    },
    algo::volume::signed_distance,
    geom::{Solid, ViewVolume},
    trace::{Recording, laws, silent},
};
use proptest::prelude::*;

use super::{
    oracle::{Seen, pixels, seen},
    soup::{FAR, NEAR, cases, of_mesh, placed, soup, surfaces, volume, volumes},
};

fn all(surfaces: Surfaces) -> RayCastingInput {
    RayCastingInput {
        surfaces,
        pixel: None,
    }
}

proptest! {
    #![proptest_config(cases(300))]

    #[test]
    fn every_middle_is_that_of_the_nearest(triangles in soup(12), culls in any::<bool>()) {
        let input = all(surfaces(&triangles, culls));
        let output = silent::<RayCasting>(&input);
        let depths = silent::<DepthBuffer>(&DepthBufferInput::new(input.surfaces.clone()));
        for pixel in pixels() {
            let place = output.picture.place(pixel);
            match seen(&triangles, culls, pixel) {
                Seen::Unsure => {}
                Seen::Nothing => prop_assert_eq!(output.picture.at(pixel), None, "{:?}", pixel),
                Seen::Surface { id, depth } => {
                    prop_assert_eq!(output.picture.at(pixel), Some(id), "{:?}", pixel);
                    prop_assert!((output.depth[place] - depth).abs() < 1e-9);
                    prop_assert!((output.depth[place] - depths.depth[place]).abs() < 1e-9);
                }
            }
        }
    }

    #[test]
    fn boxes_change_no_hit(triangles in soup(60), parallel in any::<bool>()) {
        let volume = if parallel { ViewVolume::parallel(12.0, 1.0, -1.0, 9.0).expect("a volume") } else { volume() };
        let surfaces = Surfaces::new([16, 16], volume, placed(&triangles), false).expect("finite");
        let without = silent::<RayCasting>(&all(surfaces.clone()));
        let with = Hierarchy::new(&surfaces).picture(&surfaces);
        prop_assert_eq!(with.picture, without.picture);
        prop_assert_eq!(with.depth, without.depth);
        prop_assert!(with.n_asked <= without.n_asked);
    }

    #[test]
    fn boxes_change_no_hit_at_any_scale(triangles in soup(20), parallel in any::<bool>(), power in -300..301_i32) {
        let scale = 2.0_f64.powi(power);
        let volume = if parallel {
            ViewVolume::parallel(12.0 * scale, 1.0, -scale, 9.0 * scale)
        } else {
            ViewVolume::perspective(90.0, 1.0, NEAR * scale, FAR * scale)
        };
        let scaled: Vec<_> = placed(&triangles).into_iter().map(|t| t.map(|v| v.map(|x| x * scale))).collect();
        let surfaces = Surfaces::new([16, 16], volume.expect("a volume"), scaled, false).expect("finite");
        let without = silent::<RayCasting>(&all(surfaces.clone()));
        let with = Hierarchy::new(&surfaces).picture(&surfaces);
        prop_assert_eq!(with.picture, without.picture);
        prop_assert_eq!(with.depth, without.depth);
    }
}

#[test]
#[expect(clippy::unreadable_literal, reason = "every bit counts")]
fn boxes_begin_before_what_is_told() {
    // A needle along the ray through the middle of pixel (9, 5), which meets it at 3.7008; its plane runs so near the eye that 3.6980 is told,
    // which is before it begins. So many walls are between that the needle gets a box of its own.
    let needle = [
        [0.6937499999999979, 1.1562500000000009, -3.699999999999997],
        [0.6937500000000023, 1.156249999999997, -3.6999999999999997],
        [0.6939374999999995, 1.1565625000000004, -3.7009999999999996],
    ];
    let wall = [
        [-90.0, -90.0, -3.699],
        [90.0, -90.0, -3.699],
        [0.0, 190.0, -3.699],
    ];
    let surfaces = Surfaces::new(
        [16, 16],
        volume(),
        [wall, wall, wall, wall, wall, needle],
        false,
    );
    let surfaces = surfaces.expect("finite");
    let without = silent::<RayCasting>(&all(surfaces.clone()));
    assert_eq!(without.picture.at([9, 5]), Some(5));
    let with = Hierarchy::new(&surfaces).picture(&surfaces);
    assert_eq!(with.picture, without.picture);
    assert_eq!(with.depth, without.depth);
}

proptest! {
    #![proptest_config(cases(12))]

    #[test]
    fn the_laws(triangles in soup(5), column in 0..5_u32) {
        let surfaces = Surfaces::new([5, 4], volume(), placed(&triangles), true).expect("finite");
        laws::check::<RayCasting>(&all(surfaces.clone()));
        laws::check::<RayCasting>(&RayCastingInput { surfaces, pixel: Some([column, 3]) });
    }
}

#[test]
fn solids_are_the_same_by_depths_and_by_rays() {
    for solid in Solid::ALL {
        for volume in volumes() {
            let surfaces = of_mesh(solid, volume, [48, 32], true);
            let depths = silent::<DepthBuffer>(&DepthBufferInput::new(surfaces.clone()));
            let rays = Hierarchy::new(&surfaces).picture(&surfaces);
            // Nothing here has an edge through a middle.
            assert_eq!(depths.picture, rays.picture, "{solid:?}");
            assert!(depths.tally.pixels > 100, "{solid:?}");
            for (one, other) in depths.depth.iter().zip(&rays.depth) {
                assert!(
                    one == other || (one - other).abs() < 1e-12,
                    "{solid:?}: {one} {other}"
                );
            }
        }
    }
}

#[test]
fn an_edge_belongs_to_one_of_its_two_triangles() {
    // Two halves of a square whose diagonal, left and top edges pass through middles.
    let at = |x: f64, y: f64| [x, y, -1.0];
    let [a, b, c, d] = [at(-0.5, -0.5), at(0.5, -0.5), at(0.5, 0.5), at(-0.5, 0.5)];
    let volume = ViewVolume::perspective(90.0, 1.0, 0.5, 4.0).expect("a volume");
    for halves in [[[a, b, c], [a, c, d]], [[a, c, b], [d, c, a]]] {
        let surfaces = Surfaces::new([2, 2], volume, halves, false).expect("finite");
        let depths = silent::<DepthBuffer>(&DepthBufferInput::new(surfaces.clone()));
        let rays = silent::<RayCasting>(&all(surfaces));
        assert_eq!(depths.picture, rays.picture);
        assert_eq!(
            depths
                .picture
                .ids()
                .iter()
                .filter(|&&id| id != Picture::BACKGROUND)
                .count(),
            1
        );
    }
}

#[test]
fn every_meeting_by_name() {
    use Meeting::*;
    let wall = |z: f64| [[-90.0, -90.0, z], [90.0, -90.0, z], [0.0, 190.0, z]];
    let beside = [[5.0, 5.0, -2.0], [6.0, 5.0, -2.0], [5.0, 6.0, -2.0]];
    // The middle pixel's ray runs along −z: a plane beside it never meets it.
    let parallel = [[1.0, 0.0, -2.0], [1.0, 0.0, -3.0], [1.0, 1.0, -2.0]];
    let back = [wall(-3.0)[0], wall(-3.0)[2], wall(-3.0)[1]];
    let triangles = [
        wall(-3.0),
        wall(1.0),
        wall(-0.5),
        wall(-9.5),
        beside,
        parallel,
        wall(-2.0),
        back,
    ];
    let volume = ViewVolume::perspective(60.0, 1.0, 1.0, 9.0).expect("a volume");
    let surfaces = Surfaces::new([3, 3], volume, triangles, false).expect("finite");
    let [turned, both] = [true, false]
        .map(|culls| Surfaces::new([3, 3], volume, surfaces.triangles(), culls).expect("finite"));
    let meetings = |surfaces: Surfaces| {
        let trace = Recording::<RayCasting>::new(RayCastingInput {
            surfaces,
            pixel: Some([1, 1]),
        });
        let nearest = trace.held().nearest;
        assert_eq!(nearest.map(|hit| (hit.id, hit.t)), Some((6, 2.0)));
        let asked = trace.events().iter().filter_map(|event| match event {
            RayCastingEvent::Ask { found, .. } => Some(found.meeting),
            _ => None,
        });
        asked.collect::<Vec<_>>()
    };
    let expected = [
        Hit, Behind, BeforeNear, BeyondFar, Beside, Parallel, Hit, Hit,
    ];
    assert_eq!(meetings(both), expected);
    assert_eq!(meetings(turned)[7], Culled);
}

#[test]
fn near_and_far_are_closed() {
    for [near, far] in [[0.1, 0.7], [0.3, 100.1], [1.7, 1.9]] {
        let volume = ViewVolume::perspective(70.0, 1.25, near, far).expect("a volume");
        let seen_at = |distance: f64| {
            let (z, wide) = (-distance, 9.0 * distance);
            let wall = [[-wide, -wide, z], [wide, -wide, z], [0.0, 2.0 * wide, z]];
            let surfaces = Surfaces::new([5, 4], volume, [wall], false).expect("finite");
            let output = silent::<RayCasting>(&all(surfaces));
            (output.picture.ids() == [0; 20]).then_some(output.depth[0])
        };
        assert!(seen_at(near).is_some_and(|depth| depth.abs() < 1e-12));
        assert!(seen_at(far).is_some_and(|depth| (depth - 1.0).abs() < 1e-12));
        assert_eq!([near.next_down(), far.next_up()].map(seen_at), [None; 2]);
    }
}

#[test]
fn t_is_one_on_the_raster_and_depth_says_how_far() {
    for volume in [
        volume(),
        ViewVolume::parallel(4.0, 1.0, -2.0, 6.0).expect("a volume"),
    ] {
        let surfaces = Surfaces::new([4, 4], volume, [], false).expect("no triangle");
        let rays = Rays::of(&surfaces);
        for (t, distance, depth) in [(1.0, volume.near(), 0.0), (rays.far(), volume.far(), 1.0)] {
            assert!((rays.through([1, 2]).at(t)[2] + distance).abs() < 1e-12);
            assert!((rays.depth(t) - depth).abs() < 1e-12);
            assert!((rays.t_at(depth) - t).abs() < 1e-9);
            assert!((rays.distance(t) - distance).abs() < 1e-12);
            assert!((rays.t_of(distance) - t).abs() < 1e-12);
        }
    }
}

/// What lies in the shadow is met behind the triangle by the line of sight through it, and nothing else is.
#[test]
fn in_the_shadow_is_what_a_ray_meets_later() {
    let triangle = |z: f64| [[-1.0, -1.0, z], [1.5, -0.5, z - 0.5], [0.0, 1.25, z]];
    let wall = [[-20.0, -20.0, -8.0], [20.0, -20.0, -8.0], [0.0, 40.0, -8.0]];
    for volume in [
        ViewVolume::perspective(60.0, 1.0, 1.0, 12.0),
        ViewVolume::parallel(5.0, 1.0, 1.0, 12.0),
    ] {
        let volume = volume.expect("a volume");
        let surfaces = Surfaces::new([24, 24], volume, [triangle(-4.0), wall], false);
        let surfaces = surfaces.expect("finite");
        let planes = surfaces.behind(0).expect("it has an area");
        let rays = Rays::of(&surfaces);
        let mut n_hidden = 0;
        for pixel in (0..24).flat_map(|row| (0..24).map(move |column| [column, row])) {
            let ray = rays.through(pixel);
            let at = |id| silent::<RayCasting>(&one(&surfaces.part(id..id + 1), pixel)).depth;
            let place = (pixel[1] * 24 + pixel[0]) as usize;
            let [own, far] = [0, 1].map(|id| at(id)[place]);
            let met = ray.at(rays.t_at(far));
            let distances = planes.map(|plane| signed_distance::<f64>(&plane, met));
            let least = distances.into_iter().fold(f64::INFINITY, f64::min);
            if least.abs() > 1e-9 {
                assert_eq!(least > 0.0, own.is_finite(), "{pixel:?} {distances:?}");
            }
            n_hidden += usize::from(own.is_finite());
        }
        assert!(n_hidden > 20);
    }
}

fn one(surfaces: &Surfaces, pixel: [u32; 2]) -> RayCastingInput {
    let (surfaces, pixel) = (surfaces.clone(), Some(pixel));
    RayCastingInput { surfaces, pixel }
}
