//! Named cases.

use clipscope::{
    algo::line::{
        BitOrder, CyrusBeck, CyrusBeckInput, LiangBarsky, LiangBarskyEvent, Outcode, WindowInput,
    },
    geom::{ConvexPolygon, Segment, Window},
    trace::{Recording, silent},
};

use super::{all_clippers, floats};

type Numbers = [f64; 4];
type Outline = [[f64; 2]];

const UNIT: Numbers = [-1.0, -1.0, 1.0, 1.0];

fn window(numbers: Numbers) -> Window {
    Window::try_from(numbers).expect("a window")
}

fn segment(numbers: Numbers) -> Segment {
    Segment::try_from(numbers).expect("finite")
}

/// In the unit window, by all clippers and in both directions.
fn check(name: &str, numbers: Numbers, expected: Option<Numbers>) {
    let (given, expected) = (segment(numbers), expected.map(segment));
    for (clipper, clip) in all_clippers() {
        assert_eq!(
            clip(&window(UNIT), &given),
            expected,
            "{name}, by {clipper}"
        );
        assert_eq!(
            clip(&window(UNIT), &given.reversed()),
            expected.map(Segment::reversed),
            "{name}, reversed, by {clipper}"
        );
    }
}

#[test]
fn every_pair_of_regions() {
    let middle = [-2.0, 0.0, 2.0];
    for (i, j, k, l) in (0..81).map(|n| (n % 3, n / 3 % 3, n / 9 % 3, n / 27)) {
        let numbers = [middle[i], middle[j], middle[k], middle[l]];
        let name = format!("from region {i}{j} to {k}{l}");
        check(&name, numbers, quarters(numbers));
    }
}

/// Ends on the grid −2, 0, 2 meet the borders ±1 at quarters: the visible ones are counted by hand.
fn quarters([x1, y1, x2, y2]: Numbers) -> Option<Numbers> {
    let at = |quarter: u8| {
        let u = f64::from(quarter) / 4.0;
        [x1 + u * (x2 - x1), y1 + u * (y2 - y1)]
    };
    let is_inside = |p: &[f64; 2]| p.iter().all(|x| x.abs() <= 1.0);
    let visible: Vec<[f64; 2]> = (0..=4).map(at).filter(is_inside).collect();
    let ([x, y], [z, w]) = (visible.first()?, visible.last()?);
    Some([*x, *y, *z, *w])
}

#[test]
fn touches() {
    let cases: [(&str, Numbers, Option<Numbers>); 15] = [
        (
            "a corner, in passing",
            [-2.0, 0.0, 0.0, 2.0],
            Some([-1.0, 1.0, -1.0, 1.0]),
        ),
        (
            "a corner, with an end",
            [-3.0, 2.0, -1.0, 1.0],
            Some([-1.0, 1.0, -1.0, 1.0]),
        ),
        (
            "a corner, missed",
            [-2.0, 0.0, 0.0, 2.0 + f64::EPSILON * 2.0],
            None,
        ),
        (
            "a side, with an end",
            [-3.0, 0.5, -1.0, 0.25],
            Some([-1.0, 0.25, -1.0, 0.25]),
        ),
        (
            "a side, along all of it",
            [-1.0, -3.0, -1.0, 3.0],
            Some([-1.0, -1.0, -1.0, 1.0]),
        ),
        (
            "a side, along part of it",
            [-1.0, 0.0, -1.0, 0.5],
            Some([-1.0, 0.0, -1.0, 0.5]),
        ),
        (
            "a side's line beyond the side",
            [-1.0, 2.0, -1.0, 3.0],
            None,
        ),
        (
            "a side's line up to the corner",
            [-1.0, 3.0, -1.0, 1.0],
            Some([-1.0, 1.0, -1.0, 1.0]),
        ),
        (
            "both corners of a diagonal",
            [-2.0, -2.0, 2.0, 2.0],
            Some([-1.0, -1.0, 1.0, 1.0]),
        ),
        (
            "from corner to corner",
            [-1.0, -1.0, 1.0, 1.0],
            Some([-1.0, -1.0, 1.0, 1.0]),
        ),
        (
            "from a corner outwards",
            [1.0, 1.0, 3.0, 2.0],
            Some([1.0, 1.0, 1.0, 1.0]),
        ),
        ("a point inside", [0.5; 4], Some([0.5; 4])),
        (
            "a point on a side",
            [-1.0, 0.5, -1.0, 0.5],
            Some([-1.0, 0.5, -1.0, 0.5]),
        ),
        ("a point on a corner", [1.0; 4], Some([1.0; 4])),
        ("a point outside", [1.5; 4], None),
    ];
    for (name, numbers, expected) in cases {
        check(name, numbers, expected);
    }
}

#[test]
fn the_practice_example_of_the_slides() {
    check(
        "as printed, Δx = 4",
        [-2.0, -1.0, 2.0, 1.5],
        Some([-1.0, -0.375, 1.0, 0.875]),
    );
    check(
        "as computed, Δx = 3",
        [-2.0, -1.0, 1.0, 1.5],
        Some([-1.0, -1.0 / 6.0, 0.4, 1.0]),
    );
    let input = WindowInput {
        window: window(UNIT),
        segment: segment([-2.0, -1.0, 2.0, 1.5]),
    };
    let trace = Recording::<LiangBarsky>::new(input);
    let rows = trace.events().iter().filter_map(|event| match event {
        LiangBarskyEvent::Row { row, .. } => Some((row.p, row.q)),
        _ => None,
    });
    let expected = [(-4.0, -1.0), (4.0, 3.0), (-2.5, 0.0), (2.5, 2.0)];
    assert_eq!(rows.collect::<Vec<_>>(), expected, "p and q, row by row");
    let put = trace.events().iter().filter_map(|event| match event {
        LiangBarskyEvent::Put { u, .. } => Some(*u),
        _ => None,
    });
    assert_eq!(put.collect::<Vec<_>>(), [0.25, 0.75], "u");
}

#[test]
fn equal_codes_and_different_verdicts() {
    // The slides' L1 to L5 by their codes: top, bottom, right, left.
    let cases: [(&str, Numbers, [&str; 2], bool); 5] = [
        ("L1", [-0.5, -0.5, 0.5, 0.25], ["0000", "0000"], true),
        ("L2", [2.0, 2.0, -2.0, 3.0], ["1010", "1001"], false),
        ("L3", [0.0, 0.0, 2.0, -2.0], ["0000", "0110"], true),
        ("L4", [-2.0, 0.5, 0.5, -2.0], ["0001", "0100"], true),
        ("L5", [-2.0, -0.5, -0.5, -2.0], ["0001", "0100"], false),
    ];
    for (name, numbers, expected, visible) in cases {
        let s = segment(numbers);
        let codes =
            [s.p1, s.p2].map(|p| Outcode::of_point(p, &window(UNIT), BitOrder::Tbrl).to_string());
        assert_eq!(codes, expected, "codes of {name}");
        for (clipper, clip) in all_clippers() {
            assert_eq!(
                clip(&window(UNIT), &s).is_some(),
                visible,
                "{name}, by {clipper}"
            );
        }
    }
}

#[test]
fn parallel_and_between_two_sides_is_not_enough() {
    // E4: p = 0 for left and right with both q > 0, and yet all of it lies above the window.
    check("above the window", [0.5, 2.0, 0.5, 3.0], None);
    let trace = Recording::<LiangBarsky>::new(WindowInput {
        window: window(UNIT),
        segment: segment([0.5, 2.0, 0.5, 3.0]),
    });
    let inside = trace.events().iter().filter(
        |event| matches!(event, LiangBarskyEvent::Parallel { inside: true, q, .. } if *q > 0.0),
    );
    assert_eq!(inside.count(), 2, "both parallel rows are inside");
}

#[test]
fn what_rounding_once_broke() {
    let cases: [(&str, Numbers, Numbers); 6] = [
        ("o·w / w is not o", UNIT, [-3.0, 0.1, -1.0, 0.7]),
        ("a zero of either sign", UNIT, [-2.0, -0.3, 2.0, 0.3]),
        ("minus zero along an axis", UNIT, [-2.0, -0.0, 2.0, -0.0]),
        (
            "differences that overflow",
            [-1e308, -1e308, 1e308, 1e308],
            [-1.7e308, -1.0, 1.7e308, 1.7e308],
        ),
        (
            "a window of one ulp, far away",
            [1.0, 1.0, 1.0 + f64::EPSILON, 2.0],
            [-1e20, 0.5, 1e20, 3.0],
        ),
        (
            "products that underflow",
            [-1e-200, -1e-200, 1e-200, 1e-200],
            [-3e-200, -2e-200, 2e-200, 2.5e-200],
        ),
    ];
    for (name, w, s) in cases {
        println!("{name}");
        floats::check_promises(&window(w), &segment(s));
        floats::check_agreement(&window(w), &segment(s));
    }
}

#[test]
fn convex_windows() {
    let diamond = [[0.0, -2.0], [2.0, 0.0], [0.0, 2.0], [-2.0, 0.0]];
    let triangle = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]];
    let cases: [(&str, &Outline, Numbers, Option<Numbers>); 9] = [
        (
            "across",
            &diamond,
            [-3.0, 1.0, 3.0, 1.0],
            Some([-1.0, 1.0, 1.0, 1.0]),
        ),
        (
            "touching a vertex",
            &diamond,
            [-3.0, 2.0, 3.0, 2.0],
            Some([0.0, 2.0, 0.0, 2.0]),
        ),
        (
            "along an edge",
            &diamond,
            [-1.0, 3.0, 3.0, -1.0],
            Some([0.0, 2.0, 2.0, 0.0]),
        ),
        ("beside an edge", &diamond, [-1.0, 3.5, 3.5, -1.0], None),
        (
            "inside",
            &diamond,
            [-0.5, 0.5, 0.5, 0.25],
            Some([-0.5, 0.5, 0.5, 0.25]),
        ),
        ("a point on an edge", &diamond, [1.0; 4], Some([1.0; 4])),
        (
            "through two vertices",
            &diamond,
            [-4.0, 0.0, 4.0, 0.0],
            Some([-2.0, 0.0, 2.0, 0.0]),
        ),
        (
            "over the long edge",
            &triangle,
            [1.0, 1.0, 4.0, 4.0],
            Some([1.0, 1.0, 2.0, 2.0]),
        ),
        ("past a vertex", &triangle, [3.0, 2.0, 5.0, -1.0], None),
    ];
    for (name, outline, numbers, expected) in cases {
        let (given, expected) = (segment(numbers), expected.map(segment));
        let clockwise: Vec<[f64; 2]> = outline.iter().rev().copied().collect();
        for outline in [outline, &clockwise] {
            let clip = ConvexPolygon::new(outline).expect("convex");
            let by = |segment| {
                silent::<CyrusBeck>(&CyrusBeckInput {
                    clip: clip.clone(),
                    segment,
                })
            };
            assert_eq!(by(given), expected, "{name}");
            assert_eq!(
                by(given.reversed()),
                expected.map(Segment::reversed),
                "{name}, reversed"
            );
        }
    }
}

#[test]
fn a_convex_window_of_any_size() {
    for scale in [1e-308, 1e-160, 1.0, 1e160, 1e307] {
        let clip = ConvexPolygon::new(
            &[[0.0, -2.0], [2.0, 0.0], [0.0, 2.0], [-2.0, 0.0]].map(|p| p.map(|x| x * scale)),
        )
        .expect("convex");
        let segment = segment([-3.0, 1.0, 5.0, 1.0].map(|x| x * scale));
        let visible = silent::<CyrusBeck>(&CyrusBeckInput { clip, segment }).expect("visible");
        for (x, expected) in visible.to_array().into_iter().zip([-1.0, 1.0, 1.0, 1.0]) {
            assert!(
                (x / scale - expected).abs() < 1e-12,
                "{visible:?} at scale {scale:e}"
            );
        }
    }
}
