//! Any finite numbers, however large, small or close together.

use clipscope::{
    algo::line::Visible,
    geom::{Edge, Point, Segment, Window},
};
use proptest::prelude::*;

use super::{BY_DISTANCES, all_clippers, bits};

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
        4 => -10.0..10.0_f64,
        1 => (-8..=8_i32).prop_map(f64::from),
        1 => prop::num::f64::NORMAL | prop::num::f64::ZERO | prop::num::f64::SUBNORMAL,
        1 => (0..4_usize).prop_map(|i| [f64::MAX, f64::MIN, 1e308, -1e308][i]),
        1 => (-1100..1023_i32, -4.0..4.0_f64).prop_map(|(e, x)| (x * 2f64.powi(e)).clamp(f64::MIN, f64::MAX)),
    ]
}

fn window() -> impl Strategy<Value = Window> {
    let interval = || {
        (coordinate(), coordinate(), 1..4_i32, any::<bool>()).prop_map(|(a, b, ulps, thin)| {
            let b = if thin { nudged(a, ulps) } else { b };
            if a < b {
                [a, b]
            } else if b < a {
                [b, a]
            } else {
                [nudged(a, -1), nudged(a, 1)]
            }
        })
    };
    let ordinary = (
        0.1..10.0_f64,
        0.1..10.0_f64,
        -10.0..10.0_f64,
        -10.0..10.0_f64,
    )
        .prop_map(|(w, h, x, y)| [x, y, x + w, y + h]);
    let any =
        (interval(), interval()).prop_map(|([xmin, xmax], [ymin, ymax])| [xmin, ymin, xmax, ymax]);
    prop_oneof![2 => ordinary, 1 => any].prop_map(|w| Window::try_from(w).expect("ordered"))
}

/// A number that stands in some relation to an interval: a few ulps from a border, as far outside as the
/// other end is, between, or anywhere.
fn related(low: f64, high: f64) -> impl Strategy<Value = f64> {
    prop_oneof![
        2 => (any::<bool>(), -3..=3_i32).prop_map(move |(at_high, ulps)| nudged(if at_high { high } else { low }, ulps)),
        2 => (0.0..=1.0_f64).prop_map(move |u| (low * (1.0 - u) + high * u).clamp(low, high)),
        2 => (-3.0..4.0_f64).prop_map(move |u| (low + u * (high * 0.5 - low * 0.5)).clamp(f64::MIN, f64::MAX)),
        1 => coordinate(),
    ]
}

fn case() -> impl Strategy<Value = (Window, Segment)> {
    window().prop_flat_map(|w| {
        let [xmin, ymin, xmax, ymax] = w.to_array();
        let (x, y) = (|| related(xmin, xmax), || related(ymin, ymax));
        let free = (x(), y(), x(), y()).prop_map(|(x1, y1, x2, y2)| [x1, y1, x2, y2]);
        let aligned = (x(), y(), x(), y(), any::<bool>()).prop_map(|(x1, y1, x2, y2, h)| {
            if h {
                [x1, y1, x2, y1]
            } else {
                [x1, y1, x1, y2]
            }
        });
        // Both ends on a line through a corner, or as near as rounding lets them.
        let corner = (
            0..4_usize,
            -2.0..2.0_f64,
            -2.0..2.0_f64,
            -2.0..2.0_f64,
            -2.0..2.0_f64,
            -1..=1_i32,
        )
            .prop_map(move |(i, dx, dy, s, t, ulps)| {
                let c = w.corners()[i];
                let at = |s: f64| {
                    [c.x() + s * dx, c.y() + s * dy]
                        .map(|x| nudged(x.clamp(f64::MIN, f64::MAX), ulps))
                };
                let ([x1, y1], [x2, y2]) = (at(s), at(t));
                [x1, y1, x2, y2]
            });
        let segment = prop_oneof![4 => free, 1 => aligned, 2 => corner]
            .prop_map(|s| Segment::try_from(s).expect("finite"));
        (Just(w), segment)
    })
}

/// Everything that each clipper promises by itself.
pub fn check_promises(window: &Window, segment: &Segment) {
    for (name, clip) in all_clippers() {
        let visible = clip(window, segment);
        let what = format!("{name} clips {segment:?} against {window:?} to {visible:?}");
        let back = clip(window, &segment.reversed());
        assert_eq!(
            bits(visible),
            bits(back.map(Segment::reversed)),
            "{what}: mirrored when reversed"
        );
        check_verdict(window, segment, visible, &what);
        let Some(v) = visible else { continue };
        assert_eq!(
            bits(clip(window, &v)),
            bits(visible),
            "{what}: clipped again, nothing changes"
        );
        for (given, put) in [(segment.p1, v.p1), (segment.p2, v.p2)] {
            check_end(window, segment, given, put, &what);
        }
    }
}

/// What can be told from regions alone.
fn check_verdict(window: &Window, segment: &Segment, visible: Visible, what: &str) {
    let inside = [segment.p1, segment.p2].map(|p| window.contains(p));
    let beyond_one_side = Edge::ALL.iter().any(|&edge| {
        [segment.p1, segment.p2]
            .iter()
            .all(|&p| is_beyond(p, window, edge))
    });
    assert!(
        !(beyond_one_side && visible.is_some()),
        "{what}: both ends beyond one side"
    );
    assert!(
        !inside.contains(&true) || visible.is_some(),
        "{what}: an end is inside"
    );
    if segment.p1 == segment.p2 {
        assert_eq!(visible, inside[0].then_some(*segment), "{what}: a point");
    }
}

/// One end on a border and the other beyond it: a touch, with both ends that point.
fn check_touch(window: &Window, segment: &Segment, visible: Visible, what: &str) {
    for (end, other) in [(segment.p1, segment.p2), (segment.p2, segment.p1)] {
        let touches = |&edge: &Edge| is_on(end, window, edge) && is_beyond(other, window, edge);
        if window.contains(end) && Edge::ALL.iter().any(touches) {
            let point = Segment { p1: end, p2: end };
            assert_eq!(visible, Some(point), "{what}: touches with an end");
        }
    }
}

fn check_end(window: &Window, segment: &Segment, given: Point, put: Point, what: &str) {
    assert!(window.contains(put), "{what}: {put:?} is inside");
    let between = |a: f64, b: f64, x: f64| (a.min(b)..=a.max(b)).contains(&x);
    let Segment { p1, p2 } = segment;
    assert!(
        between(p1.x(), p2.x(), put.x()) && between(p1.y(), p2.y(), put.y()),
        "{what}: {put:?} lies between the ends"
    );
    if window.contains(given) {
        assert_eq!(
            put.to_array().map(f64::to_bits),
            given.to_array().map(f64::to_bits),
            "{what}: {given:?} was inside"
        );
    } else {
        assert!(
            Edge::ALL
                .iter()
                .any(|&edge| is_beyond(given, window, edge) && is_on(put, window, edge)),
            "{what}: {put:?} lies on a border that {given:?} is beyond"
        );
    }
}

fn along(p: Point, edge: Edge) -> f64 {
    let [x, y] = p.to_array();
    if matches!(edge, Edge::Left | Edge::Right) {
        x
    } else {
        y
    }
}

fn is_beyond(p: Point, window: &Window, edge: Edge) -> bool {
    let (a, c) = (along(p, edge), window.border(edge));
    if edge.is_max() { a > c } else { a < c }
}

fn is_on(p: Point, window: &Window, edge: Edge) -> bool {
    along(p, edge) == window.border(edge)
}

/// Those that decide on distances agree in every bit, and know a touch for what it is. (One that cuts side
/// after side may have moved the other end onto the border by then, by rounding.)
pub fn check_agreement(window: &Window, segment: &Segment) {
    let [(first, clip), others @ ..] = BY_DISTANCES;
    let expected = clip(window, segment);
    let what = format!("{first} clips {segment:?} against {window:?} to {expected:?}");
    check_touch(window, segment, expected, &what);
    for (name, clip) in others {
        let visible = clip(window, segment);
        assert_eq!(
            bits(visible),
            bits(expected),
            "{name} clips {segment:?} against {window:?} to {visible:?}, {first} to {expected:?}"
        );
    }
}

proptest! {
    #[test]
    fn promises_hold_for_any_numbers((window, segment) in case()) {
        check_promises(&window, &segment);
    }

    #[test]
    fn those_that_decide_on_distances_agree((window, segment) in case()) {
        check_agreement(&window, &segment);
    }
}
