//! Any finite numbers, however large, small or close together.

use clipscope::{
    algo::polygon::{ClipRegion, SutherlandHodgman, Textured},
    geom::{ConvexPolygon, Point, Window},
    trace::silent,
};
use proptest::prelude::*;

use super::{check_clipper, check_promises, input};

/// A few units in the last place away.
fn nudged(x: f64, ulps: i32) -> f64 {
    let step = if ulps < 0 {
        f64::next_down
    } else {
        f64::next_up
    };
    let x = (0..ulps.abs()).fold(x, |x, _| step(x));
    x.clamp(f64::MIN, f64::MAX)
}

/// Numbers of every size, ordinary ones more often.
fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        6 => -3.0..3.0_f64,
        2 => (-4..=4_i32).prop_map(f64::from),
        2 => (-2..=2_i32, -3..=3_i32).prop_map(|(x, ulps)| nudged(f64::from(x), ulps)),
        1 => prop::num::f64::NORMAL | prop::num::f64::ZERO | prop::num::f64::SUBNORMAL,
        1 => (0..4_usize).prop_map(|i| [f64::MAX, f64::MIN, 1e308, -1e308][i]),
    ]
}

fn ring() -> impl Strategy<Value = Vec<Point>> {
    prop::collection::vec([coordinate(), coordinate()], 0..10)
        .prop_map(|outline| super::points(&outline))
}

/// Of any length, about the 64 vertices that the clipper looks at together too, with a place in a texture each.
fn long_ring() -> impl Strategy<Value = Vec<Textured>> {
    let vertex = || [coordinate(), coordinate(), coordinate(), coordinate()];
    let n = prop_oneof![0..12_usize, 60..70_usize, 124..200_usize];
    let textured = |[x, y, u, v]: [f64; 4]| Textured {
        at: Point::new(x, y).expect("finite"),
        uv: [u, v],
    };
    n.prop_flat_map(move |n| prop::collection::vec(vertex(), n))
        .prop_map(move |ring| ring.into_iter().map(textured).collect())
}

fn window() -> impl Strategy<Value = ClipRegion> {
    let interval = || {
        (coordinate(), coordinate()).prop_map(|(a, b)| {
            if a < b {
                [a, b]
            } else if b < a {
                [b, a]
            } else {
                [nudged(a, -1), nudged(a, 1)]
            }
        })
    };
    (interval(), interval()).prop_map(|([xmin, xmax], [ymin, ymax])| {
        Window::new(xmin, ymin, xmax, ymax).expect("ordered").into()
    })
}

/// A regular polygon, of any size and turned by any angle.
fn regular() -> impl Strategy<Value = ClipRegion> {
    let radius = prop_oneof![3 => 0.2..3.0_f64, 1 => (-900..1000_i32).prop_map(|e| 2f64.powi(e))];
    (
        3..20_usize,
        radius,
        0.0..std::f64::consts::TAU,
        -1.0..1.0_f64,
    )
        .prop_map(|(n, radius, angle, x)| {
            let corner = |i: usize| {
                let (sin, cos) = libm::sincos(angle + std::f64::consts::TAU * i as f64 / n as f64);
                [radius * (x + cos), radius * sin]
            };
            let outline: Vec<[f64; 2]> = (0..n).map(corner).collect();
            ConvexPolygon::new(&outline).expect("convex").into()
        })
}

/// Any triangle, slivers and all.
fn triangle() -> impl Strategy<Value = ClipRegion> {
    prop::array::uniform3([coordinate(), coordinate()])
        .prop_filter_map("a triangle", |outline| ConvexPolygon::new(&outline).ok())
        .prop_map(ClipRegion::from)
}

proptest! {
    #[test]
    fn the_clipper_leaves_what_is_taught_of_a_ring_of_any_length(
        region in prop_oneof![window(), regular(), triangle()],
        ring in long_ring(),
    ) {
        let taught = silent::<SutherlandHodgman<Textured>>(&input(&region, ring.clone()));
        check_clipper(&region, &ring, &taught, |ring: &[Textured]| {
            let numbers = |v: &Textured| [v.at.x(), v.at.y(), v.uv[0], v.uv[1]];
            ring.iter().map(|v| numbers(v).map(f64::to_bits)).collect()
        });
    }

    #[test]
    fn promises_against_a_window(region in window(), ring in ring()) {
        check_promises(&region, &ring);
    }

    #[test]
    fn promises_against_a_regular_polygon(region in regular(), ring in ring()) {
        check_promises(&region, &ring);
    }

    #[test]
    fn promises_against_a_triangle(region in triangle(), ring in ring()) {
        check_promises(&region, &ring);
    }
}
