//! The painter: where there is an order it is right, and where there is none there is a reason.

use clipscope::{
    algo::surface::{
        DepthBuffer, DepthBufferInput, Painter, PainterAnswer, Surfaces,
        faulty::{FaultyPainter, KeysOnly, NearestKeys},
    },
    geom::Solid,
    trace::{Recording, laws, silent},
};
use proptest::prelude::*;

use super::{
    oracle::{Seen, pixels, seen},
    soup::{Whole, ahead, cases, of_mesh, soup, surfaces, three_bars, volume, volumes},
};

/// Can the second be nearer than the first somewhere? The difference of 1/distance is linear over the screen, so it is the largest in a
/// corner of the area that both cover. None where that is too small to tell, or one of them reaches behind the eye.
fn can_hide(triangles: &[Whole], first: u32, second: u32) -> Option<bool> {
    let pair = super::soup::placed(&[first, second].map(|id| triangles[id as usize]));
    if pair.as_flattened().iter().any(|[_, _, z]| *z > -1e-9) {
        return None;
    }
    // Place on the screen, and 1/distance.
    let seen = |t: [[f64; 3]; 3]| t.map(|[x, y, z]| [x / -z, y / -z, -1.0 / z]);
    let [one, other] = [seen(pair[0]), seen(pair[1])];
    let turn =
        |[a, b, c]: [[f64; 3]; 3]| (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
    let mut common = one.to_vec();
    for i in 0..3 {
        let (from, to) = (other[i], other[(i + 1) % 3]);
        let inside = |p: [f64; 3]| turn([from, to, p]) * turn(other).signum();
        let next = common.iter().cycle().skip(1);
        let edges: Vec<_> = common.iter().zip(next).map(|(&p, &q)| (p, q)).collect();
        common = Vec::new();
        for (p, q) in edges {
            let (at_p, at_q) = (inside(p), inside(q));
            if at_p >= 0.0 {
                common.push(p);
            }
            if at_p * at_q < 0.0 {
                let t = at_p / (at_p - at_q);
                common.push([0, 1, 2].map(|i| p[i] + t * (q[i] - p[i])));
            }
        }
    }
    let inverse = |[x, y]: [f64; 2]| {
        let [a, b, c] = other;
        let p = [x, y, 0.0];
        let shares = [turn([p, b, c]), turn([a, p, c]), turn([a, b, p])];
        shares
            .iter()
            .zip([a, b, c])
            .map(|(share, v)| share * v[2])
            .sum::<f64>()
            / turn(other)
    };
    let nearer = common.iter().map(|&[x, y, own]| inverse([x, y]) - own);
    let most = nearer.reduce(f64::max)?;
    Some(most >= -1e-9)
}

proptest! {
    #![proptest_config(cases(300))]

    #[test]
    fn an_order_is_right_and_a_cycle_has_reasons(triangles in prop_oneof![
        soup(7), prop::collection::vec(ahead(), 1..5), prop::collection::vec(ahead(), 1..3)
    ], culls in any::<bool>()) {
        match silent::<Painter>(&surfaces(&triangles, culls)).answer {
            PainterAnswer::Order { order, picture } => {
                let mut ids = order;
                ids.sort_unstable();
                ids.dedup();
                prop_assert!(culls || ids.len() == triangles.len());
                for pixel in pixels() {
                    match seen(&triangles, culls, pixel) {
                        Seen::Unsure => {}
                        Seen::Nothing => prop_assert_eq!(picture.at(pixel), None, "{:?}", pixel),
                        Seen::Surface { id, .. } => prop_assert_eq!(picture.at(pixel), Some(id), "{:?}", pixel),
                    }
                }
            }
            PainterAnswer::Cycle { cycle } => {
                prop_assert!(cycle.len() >= 2 && cycle.iter().all(|id| *id >= cycle[0]));
                for (i, &before) in cycle.iter().enumerate() {
                    let after = cycle[(i + 1) % cycle.len()];
                    prop_assert!(can_hide(&triangles, before, after) != Some(false), "{before} {after} of {cycle:?}");
                }
            }
        }
    }
}

proptest! {
    #![proptest_config(cases(24))]

    #[test]
    fn the_laws(triangles in soup(6), culls in any::<bool>()) {
        let surfaces = surfaces(&triangles, culls);
        laws::check::<Painter>(&surfaces);
        laws::check::<FaultyPainter<KeysOnly>>(&surfaces);
        laws::check::<FaultyPainter<NearestKeys>>(&surfaces);
    }
}

/// All are as deep as each other, and apart on the screen: each asks all others, and the run rests at some of them.
#[test]
fn a_run_of_many_pairs_goes_on_from_each_of_its_rests() {
    let small = |i: i64| {
        let [x, y] = [3 * (i % 16) - 24, 3 * (i / 16) - 9];
        [[x, y, -61], [x + 2, y, -60], [x, y + 2, -62]]
    };
    let triangles: Vec<Whole> = (0..112).map(small).collect();
    let surfaces = surfaces(&triangles, false);
    let recording = Recording::<Painter>::new(surfaces.clone());
    assert!(recording.rests().len() > 4, "{}", recording.rests().len());
    laws::check::<Painter>(&surfaces);
}

/// Two walls, one behind the other and apart in depth, take no determinant of a plane; two that are as deep take some.
#[test]
fn the_signs_that_decide_a_pair_are_counted() {
    let wall = |z: i64| [[-9, -9, z], [9, -9, z], [0, 9, z]];
    let leaning = [[-9, -9, -40], [9, -9, -40], [0, 9, -20]];
    let cost = |triangles: &[Whole]| {
        Recording::<Painter>::new(surfaces(triangles, false)).counts_at(usize::MAX)
    };
    // A turn of each on the screen, nine products a turn; the key and the extents are comparisons.
    let apart = cost(&[wall(-20), wall(-40)]);
    assert_eq!((apart.mul, apart.add), (2 * 9, 2 * 6));
    // The eye and three corners by a plane: thirty products each.
    let asked = cost(&[wall(-30), leaning]);
    assert!(asked.mul >= apart.mul + 4 * 30, "{asked:?}");
}

/// They pierce each other in the last of a corner that is a needle: the difference of their depths is 0.018, 0.019, 0.009 and
/// −0.005 in the corners of the area that they share.
#[test]
fn two_that_pierce_each_other_in_a_needle_are_a_cycle() {
    let triangles = [
        [[15, 23, -62], [17, -17, -17], [9, 3, -24]],
        [[24, -12, -32], [0, -13, -52], [6, 33, -54]],
    ];
    let PainterAnswer::Cycle { cycle } = silent::<Painter>(&surfaces(&triangles, false)).answer
    else {
        panic!("each is nearer somewhere");
    };
    assert_eq!(cycle, [0, 1]);
}

#[test]
fn solids_have_an_order() {
    for solid in Solid::ALL {
        for volume in volumes() {
            for culls in [false, true] {
                let surfaces = of_mesh(solid, volume, [48, 32], culls);
                let depths = silent::<DepthBuffer>(&DepthBufferInput::new(surfaces.clone()));
                let painted = silent::<Painter>(&surfaces);
                let PainterAnswer::Order { picture, .. } = painted.answer else {
                    panic!("{solid:?} {culls}: {:?}", painted.answer);
                };
                assert_eq!(picture, depths.picture, "{solid:?} {culls}");
            }
        }
    }
}

#[test]
fn three_bars_have_no_order() {
    for turned in 0..3 {
        let mut bars = three_bars();
        bars.rotate_left(turned);
        let surfaces = Surfaces::new([16, 16], volume(), bars, false).expect("finite");
        let trace = Recording::<Painter>::new(surfaces.clone());
        let expected = PainterAnswer::Cycle {
            cycle: vec![0, 2, 1],
        };
        assert_eq!(trace.output().answer, expected);
        assert_eq!(trace.held().constraints.len(), 3);
        // Any two of them have one.
        for left_out in 0..3 {
            let mut two = bars.to_vec();
            two.remove(left_out);
            let surfaces = Surfaces::new([16, 16], volume(), two, false).expect("finite");
            let depths = silent::<DepthBuffer>(&DepthBufferInput::new(surfaces.clone()));
            let PainterAnswer::Order { picture, .. } = silent::<Painter>(&surfaces).answer else {
                panic!("two bars have an order");
            };
            assert_eq!(picture, depths.picture);
        }
    }
}

#[test]
fn two_that_pierce_are_a_cycle_of_two() {
    let one = [[-2.0, -1.0, -4.0], [2.0, -1.0, -6.0], [0.0, 2.0, -5.0]];
    let other = [[-2.0, -1.0, -6.0], [2.0, -1.0, -4.0], [0.0, 2.0, -5.0]];
    let surfaces = Surfaces::new([16, 16], volume(), [one, other], false).expect("finite");
    let cycle = vec![0, 1];
    assert_eq!(
        silent::<Painter>(&surfaces).answer,
        PainterAnswer::Cycle { cycle }
    );
}

#[test]
fn in_one_plane_the_lower_id_is_seen() {
    let wall = |x: f64| [[x - 2.0, -2.0, -4.0], [x + 2.0, -2.0, -4.0], [x, 2.0, -4.0]];
    for walls in [[wall(0.0), wall(0.5)], [wall(0.5), wall(0.0)]] {
        let surfaces = Surfaces::new([16, 16], volume(), walls, false).expect("finite");
        let depths = silent::<DepthBuffer>(&DepthBufferInput::new(surfaces.clone()));
        let PainterAnswer::Order { order, picture } = silent::<Painter>(&surfaces).answer else {
            panic!("a tie is no cycle");
        };
        assert_eq!(order, [1, 0]);
        assert_eq!(picture, depths.picture);
    }
}

#[test]
fn keys_alone_are_not_enough() {
    // A long floor, its farthest vertex beyond the wall that stands on it; the second wall's nearest is behind the floor's.
    let floor = [[-6.0, -1.0, -2.0], [6.0, -1.0, -2.0], [0.0, -1.0, -15.0]];
    let wall = [[-2.0, -2.5, -8.0], [2.0, -2.5, -8.0], [0.0, 2.0, -8.0]];
    let low = [[-1.0, -0.9, -4.0], [1.0, -0.9, -4.0], [0.0, 0.5, -4.0]];
    // Under the floor, and seen through nothing: it hangs deeper than the floor's middle.
    let surfaces = Surfaces::new([32, 32], volume(), [floor, low], false).expect("finite");
    let depths = silent::<DepthBuffer>(&DepthBufferInput::new(surfaces.clone()));
    let picture = |answer: PainterAnswer| match answer {
        PainterAnswer::Order { picture, .. } => picture,
        PainterAnswer::Cycle { cycle } => panic!("{cycle:?}"),
    };
    assert_eq!(picture(silent::<Painter>(&surfaces).answer), depths.picture);
    let by_farthest = picture(silent::<FaultyPainter<KeysOnly>>(&surfaces).answer);
    assert_eq!(by_farthest, depths.picture, "this time");
    let by_nearest = picture(silent::<FaultyPainter<NearestKeys>>(&surfaces).answer);
    assert_ne!(
        by_nearest, depths.picture,
        "the floor is painted over what stands on it"
    );
    // A wall whose foot is under the floor: its key is smaller, and the floor hides it.
    let under = [wall[0], wall[1], [0.0, -1.0, -8.0]];
    let surfaces = Surfaces::new([32, 32], volume(), [floor, under], false).expect("finite");
    let depths = silent::<DepthBuffer>(&DepthBufferInput::new(surfaces.clone()));
    assert_eq!(picture(silent::<Painter>(&surfaces).answer), depths.picture);
    assert_ne!(
        picture(silent::<FaultyPainter<KeysOnly>>(&surfaces).answer),
        depths.picture
    );
}
