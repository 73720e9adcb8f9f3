//! Small integers, on which coincidences are common, against exact areas.

use clipscope::{
    algo::polygon::{ClipRegion, RingOutcome, SutherlandHodgman, Textured},
    geom::{ConvexPolygon, Point, Window},
    trace::silent,
};
use proptest::prelude::*;

use super::{check_promises, clip, input, oracle, points, twice_area};

const K: i64 = 6;

fn outline(n: impl Into<prop::collection::SizeRange>) -> impl Strategy<Value = Vec<[i64; 2]>> {
    prop::collection::vec([-K..=K, -K..=K], n)
}

fn window() -> impl Strategy<Value = Vec<[i64; 2]>> {
    (-4..=2_i64, 1..5_i64, -4..=2_i64, 1..5_i64)
        .prop_map(|(x, w, y, h)| vec![[x, y], [x + w, y], [x + w, y + h], [x, y + h]])
}

/// Counter-clockwise: the hull of a few points.
fn convex() -> impl Strategy<Value = Vec<[i64; 2]>> {
    outline(3..9)
        .prop_map(hull)
        .prop_filter("has an area", |hull| hull.len() >= 3)
}

/// A. M. Andrew, "Another efficient algorithm for convex hulls in two dimensions", Information Processing
/// Letters 9(5), 1979.
fn hull(mut points: Vec<[i64; 2]>) -> Vec<[i64; 2]> {
    points.sort_unstable();
    points.dedup();
    let half = |points: &mut dyn Iterator<Item = [i64; 2]>| {
        let mut chain: Vec<[i64; 2]> = Vec::new();
        for p in points {
            while let [.., a, b] = chain[..]
                && (b[0] - a[0]) * (p[1] - a[1]) <= (b[1] - a[1]) * (p[0] - a[0])
            {
                chain.pop();
            }
            chain.push(p);
        }
        chain.pop();
        chain
    };
    let lower = half(&mut points.iter().copied());
    let upper = half(&mut points.iter().rev().copied());
    [lower, upper].concat()
}

/// Three to six vertices in any order that does not make the outline cross or touch itself.
fn simple() -> impl Strategy<Value = Vec<[i64; 2]>> {
    let any = prop_oneof![outline(3), outline(4), outline(5), outline(6)];
    any.prop_filter("simple", |ring| is_simple(ring))
}

fn is_simple(ring: &[[i64; 2]]) -> bool {
    let n = ring.len();
    let edge = |i: usize| [ring[i % n], ring[(i + 1) % n]];
    let turn = |a: [i64; 2], b: [i64; 2], c: [i64; 2]| {
        ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).signum()
    };
    let within = |[a, b]: [[i64; 2]; 2], p: [i64; 2]| {
        turn(a, b, p) == 0 && (0..2).all(|i| a[i].min(b[i]) <= p[i] && p[i] <= a[i].max(b[i]))
    };
    let meet = |e: [[i64; 2]; 2], f: [[i64; 2]; 2]| {
        let crossing = turn(e[0], e[1], f[0]) * turn(e[0], e[1], f[1]) < 0
            && turn(f[0], f[1], e[0]) * turn(f[0], f[1], e[1]) < 0;
        crossing || f.iter().any(|&p| within(e, p)) || e.iter().any(|&p| within(f, p))
    };
    let neighbours_part = (0..n).all(|i| {
        let ([a, b], [_, c]) = (edge(i), edge(i + 1));
        a != b && !within([a, b], c) && !within([b, c], a)
    });
    let others_miss = |i: usize| (i + 2..n.min(i + n - 1)).all(|j| !meet(edge(i), edge(j)));
    neighbours_part && (0..n).all(others_miss)
}

fn floats(outline: &[[i64; 2]]) -> Vec<[f64; 2]> {
    outline.iter().map(|p| p.map(|k| k as f64)).collect()
}

fn region_of(outline: &[[i64; 2]]) -> ClipRegion {
    ConvexPolygon::new(&floats(outline)).expect("convex").into()
}

/// As a window, whose edges clip in another order.
fn window_of(corners: &[[i64; 2]]) -> ClipRegion {
    let [min, max] = [corners[0], corners[2]].map(|p| p.map(|k| k as f64));
    Window::new(min[0], min[1], max[0], max[1])
        .expect("ordered")
        .into()
}

fn check_area(region: &ClipRegion, corners: &[[i64; 2]], ring: &[[i64; 2]]) {
    let clipped = clip(region, &points(&floats(ring)));
    let area = 0.5 * twice_area(&clipped.vertices);
    let expected = oracle::common_area(ring, corners);
    assert!(
        (area - expected).abs() < 1e-12,
        "{ring:?} against {corners:?} leaves {clipped:?} of area {area}, not {expected}"
    );
}

proptest! {
    #[test]
    fn promises_against_a_window(corners in window(), ring in outline(0..12)) {
        check_promises(&window_of(&corners), &points(&floats(&ring)));
    }

    #[test]
    fn promises_against_a_convex_polygon(corners in convex(), ring in outline(0..12)) {
        check_promises(&region_of(&corners), &points(&floats(&ring)));
    }

    #[test]
    fn the_area_is_that_in_common_with_a_window(corners in window(), ring in outline(3..12)) {
        check_area(&window_of(&corners), &corners, &ring);
    }

    #[test]
    fn the_area_is_that_in_common_with_a_convex_polygon(corners in convex(), ring in outline(3..10)) {
        check_area(&region_of(&corners), &corners, &ring);
    }

    #[test]
    fn degenerate_is_what_has_no_area(corners in window(), ring in simple()) {
        let clipped = clip(&window_of(&corners), &points(&floats(&ring)));
        let has_area = oracle::common_area(&ring, &corners) != 0.0;
        let is_cut = matches!(clipped.outcome, RingOutcome::Cut | RingOutcome::Whole);
        assert_eq!(is_cut, has_area, "{ring:?} against {corners:?}: {clipped:?}");
    }

    #[test]
    fn what_goes_with_a_vertex_is_mixed_as_its_place_is(corners in convex(), ring in outline(3..10)) {
        let textured = |p: &Point| Textured { at: *p, uv: p.to_array() };
        let ring: Vec<Textured> = points(&floats(&ring)).iter().map(textured).collect();
        let clipped = silent::<SutherlandHodgman<Textured>>(&input(&region_of(&corners), ring));
        for vertex in clipped.vertices {
            let [[x, y], [u, v]] = [vertex.at.to_array(), vertex.uv];
            // A crossing near a needle's tip is moved by more than a few ulps to be inside both of its sides.
            assert!((x - u).abs() < 1e-12 && (y - v).abs() < 1e-12, "{vertex:?}");
        }
    }
}
