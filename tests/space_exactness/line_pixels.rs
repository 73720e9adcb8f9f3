//! Bresenham's pixels against the pixel that is exactly nearest.

use clipscope::{
    algo::pipeline::{Bresenham, BresenhamEvent, BresenhamInput},
    trace::{Algorithm, Counted, Counts, laws, silent},
};
use proptest::prelude::*;

fn input(from: [i64; 2], to: [i64; 2]) -> BresenhamInput {
    BresenhamInput::new(from, to).expect("not too many pixels")
}

fn pixels(from: [i64; 2], to: [i64; 2]) -> Vec<[i64; 2]> {
    silent::<Bresenham>(&input(from, to))
}

/// At each place along the longer axis the nearest pixel, by whole numbers: of two that are as near the smaller.
fn nearest(from: [i64; 2], to: [i64; 2]) -> Vec<[i64; 2]> {
    let [from, to] = [from, to].map(|at| at.map(i128::from));
    let delta = [to[0] - from[0], to[1] - from[1]];
    let major = usize::from(delta[1].abs() > delta[0].abs());
    let (n, across) = (delta[major].abs(), delta[1 - major]);
    let pixel = |k: i128| {
        let mut at = from;
        at[major] += k * delta[major].signum();
        if n > 0 {
            // ⌈k·across/n − 1/2⌉
            at[1 - major] += -(n - 2 * k * across).div_euclid(2 * n);
        }
        at.map(|x| i64::try_from(x).expect("between both ends"))
    };
    (0..=n).map(pixel).collect()
}

fn check(from: [i64; 2], to: [i64; 2]) {
    let found = pixels(from, to);
    assert_eq!(found, nearest(from, to), "{from:?} to {to:?}");
    let mut back = pixels(to, from);
    back.reverse();
    assert_eq!(found, back, "{from:?} to {to:?} and back");
    laws::check::<Bresenham>(&input(from, to));
}

#[test]
fn every_line_of_a_small_raster_in_all_octants() {
    for x in -7..=7 {
        for y in -7..=7 {
            check([0, 0], [x, y]);
            check([3, -2], [3 + x, y - 2]);
        }
    }
}

proptest! {
    #[test]
    fn long_lines(from in prop::array::uniform2(-900..900_i64), to in prop::array::uniform2(-900..900_i64)) {
        check(from, to);
    }

    /// e is 2a times as much as the line is beyond the midpoint of the two candidates for the next pixel.
    #[test]
    fn the_error_term_is_what_it_is_said_to_be(to in prop::array::uniform2(-60..60_i64)) {
        let input = input([0, 0], to);
        let major = input.major();
        let [a, b] = [major, 1 - major].map(|i| to[i].abs());
        let step = to.map(i64::signum);
        Bresenham::run::<f64>(&input, |event| {
            let BresenhamEvent::Pixel { at, error, .. } = event;
            let (k, m) = (at[major] * step[major], at[1 - major] * step[1 - major]);
            assert_eq!(error, 2 * b * (k + 1) - a * (2 * m + 1));
        });
    }
}

#[test]
fn the_ends_of_all_numbers() {
    let (low, high) = (i64::MIN, i64::MAX);
    check([low, high], [low + 60, high - 25]);
    check([high, low], [high - 4, low + 65_535]);
    check([high, high], [high, high]);
    for to in [[high, 0], [0, low], [high, high]] {
        let refused = BresenhamInput::new([low, low], to).expect_err("too many pixels");
        assert!(refused.n_pixels > BresenhamInput::MOST_PIXELS);
    }
    assert!(BresenhamInput::new([0, 0], [65_535, 7]).is_ok());
    assert!(BresenhamInput::new([0, 0], [7, -65_536]).is_err());
}

#[test]
fn no_product_and_no_quotient() {
    let (_, counts) = Counts::of(|| Bresenham::run::<Counted>(&input([0, 0], [8, 4]), |_| {}));
    assert_eq!((counts.mul, counts.div), (0, 0));
    // Each step adds 2b, and each of the four diagonal ones takes 2a off.
    assert_eq!((counts.add, counts.cmp), (3 + 8 + 4, 8));
}
