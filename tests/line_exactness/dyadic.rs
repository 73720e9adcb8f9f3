//! Coordinates k/2ᵐ: every difference, product and sum of the algorithms is exact, so nothing but the true
//! answer, correctly rounded, will do.

use clipscope::geom::{Segment, Window};
use proptest::prelude::*;

use super::{all_clippers, bits, oracle};

/// All clippers against the oracle, on integer coordinates scaled by 2⁻ᵐ.
pub fn check(window: [i64; 4], segment: [i64; 4], m: i32) {
    let scale = 2f64.powi(-m);
    let expected = oracle::clip(window, segment)
        .map(|ends| Segment::try_from(ends.map(|x| x * scale)).expect("finite"));
    let [w, s] = [window, segment].map(|numbers| numbers.map(|k| k as f64 * scale));
    let (window, segment) = (
        Window::try_from(w).expect("a window"),
        Segment::try_from(s).expect("finite"),
    );
    for (name, clip) in all_clippers() {
        let visible = clip(&window, &segment);
        assert_eq!(
            bits(visible),
            bits(expected),
            "{name} clips {s:?} against {w:?} to {visible:?}, but the exact answer is {expected:?}"
        );
    }
}

/// Two different numbers of magnitude up to `k`, in order.
fn interval(k: i64) -> impl Strategy<Value = [i64; 2]> {
    (-k..k)
        .prop_flat_map(move |low| (Just(low), low + 1..=k))
        .prop_map(|(low, high)| [low, high])
}

fn window(k: i64) -> impl Strategy<Value = [i64; 4]> {
    (interval(k), interval(k)).prop_map(|([xmin, xmax], [ymin, ymax])| [xmin, ymin, xmax, ymax])
}

fn segment(k: i64) -> impl Strategy<Value = [i64; 4]> {
    prop::array::uniform4(-k..=k)
}

/// A segment along a line through a corner of the window, which may pass, touch or miss it.
fn through_corner(k: i64) -> impl Strategy<Value = ([i64; 4], [i64; 4])> {
    let direction = [-k..=k, -k..=k];
    (window(k), 0..4_usize, direction, -8..=8_i64, -8..=8_i64).prop_map(
        |(w, corner, [dx, dy], s, t)| {
            let (x, y) = (w[corner & 2], w[(corner << 1 & 2) + 1]);
            (w, [x + s * dx, y + s * dy, x + t * dx, y + t * dy])
        },
    )
}

proptest! {
    #[test]
    fn on_a_small_grid_with_many_coincidences(w in window(8), s in segment(8), m in 0..12) {
        check(w, s, m);
    }

    #[test]
    fn on_a_large_grid(w in window(1 << 20), s in segment(1 << 20), m in -40..60) {
        check(w, s, m);
    }

    #[test]
    fn a_large_segment_and_a_small_window(w in window(8), s in segment(1 << 20), m in 0..30) {
        check(w, s, m);
    }

    #[test]
    fn along_lines_through_corners((w, s) in through_corner(1 << 16), m in 0..30) {
        check(w, s, m);
    }
}

#[test]
fn every_segment_between_points_of_a_grid() {
    let window = [-1, -2, 2, 1];
    let grid = || (-4..=4).flat_map(|x| (-4..=4).map(move |y| [x, y]));
    for [x1, y1] in grid() {
        for [x2, y2] in grid() {
            check(window, [x1, y1, x2, y2], 0);
        }
    }
}
