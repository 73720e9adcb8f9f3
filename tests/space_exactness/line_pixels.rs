//! Bresenham's pixels against the pixel that is exactly nearest.

use clipscope::{
    algo::{
        pipeline::{
            Bresenham, BresenhamEvent, BresenhamInput, DrawnSegment, LineToPixels,
            LineToPixelsEvent, LineToPixelsInput,
        },
        surface::Viewport,
    },
    geom::{Camera, ViewVolume},
    trace::{Counted, Counts, Recording, held_after, laws, silent},
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
        for &BresenhamEvent::Pixel { at, error, .. } in Recording::<Bresenham>::new(input).events() {
            let (k, m) = (at[major] * step[major], at[1 - major] * step[1 - major]);
            assert_eq!(error, 2 * b * (k + 1) - a * (2 * m + 1));
        }
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
    let (_, counts) = Counts::of(|| held_after::<Bresenham, Counted>(&input([0, 0], [8, 4])));
    assert_eq!((counts.mul, counts.div), (0, 0));
    // Each step adds 2b, and each of the four diagonal ones takes 2a off.
    assert_eq!((counts.add, counts.cmp), (3 + 8 + 4, 8));
}

/// Of a segment in the world, as far as it is visible.
fn drawn(ends: [[f64; 3]; 2], size: [u32; 2]) -> LineToPixelsInput {
    let volume = ViewVolume::perspective(70.0, 1.5, 0.5, 20.0).expect("a volume");
    let camera = Camera::new([1.0, 2.0, 6.0], [0.0; 3], [0.0, 1.0, 0.0], volume);
    LineToPixelsInput::Segment(DrawnSegment {
        ends,
        camera: camera.expect("a camera"),
        viewport: Viewport::new(size, Viewport::ANSWER_BITS).expect("a picture"),
    })
}

/// Both ends go to the middles of their pixels, up to ½ away along each axis, and Bresenham's pixels lie up to ½ from the
/// line between these. At slope s that is up to (1 + s/2) / (1 + s²) along the axis on which it is more, most at s = √5 − 2.
const MOST_OFF: f64 = 1.06;

/// Every pixel is on the picture, and the line's image passes near its middle.
fn check_drawn(ends: [[f64; 3]; 2], size: [u32; 2]) {
    let input = drawn(ends, size);
    laws::check::<LineToPixels>(&input);
    let found = silent::<LineToPixels>(&input);
    let recording = Recording::<LineToPixels>::new(input);
    let screen = recording.events().iter().find_map(|event| match *event {
        LineToPixelsEvent::Divide { screen } => Some(screen),
        _ => None,
    });
    assert_eq!(screen.is_some(), !found.is_empty());
    let Some([a, b]) = screen else {
        return;
    };
    let along = [b[0] - a[0], b[1] - a[1]];
    let squared = along[0] * along[0] + along[1] * along[1];
    for at in &found {
        let is_on = (0..2).all(|i| (0..i64::from(size[i])).contains(&at[i]));
        assert!(is_on, "{at:?}");
        let middle = at.map(|x| x as f64 + 0.5);
        let from = [middle[0] - a[0], middle[1] - a[1]];
        let t = if squared > 0.0 {
            ((from[0] * along[0] + from[1] * along[1]) / squared).clamp(0.0, 1.0)
        } else {
            0.0
        };
        let off = (0..2).map(|i| (from[i] - t * along[i]).abs());
        let off = off.fold(0.0, f64::max);
        assert!(off <= MOST_OFF, "{at:?} is {off} from the line {a:?} {b:?}");
    }
}

proptest! {
    #[test]
    fn pixels_of_a_segment_in_space(
        ends in prop::array::uniform2(prop::array::uniform3(-9.0..9.0_f64)),
        size in prop::array::uniform2(1..60_u32),
    ) {
        check_drawn(ends, size);
    }
}

/// Found by the property when it allowed one pixel.
#[test]
fn an_end_in_the_corner_of_its_pixel() {
    let p1 = [
        6.340_030_667_298_816,
        -5.571_148_864_412_808,
        4.700_309_064_953_221,
    ];
    let p2 = [
        2.135_991_804_773_791_4,
        7.311_040_219_364_735_5,
        -0.872_127_178_664_678_1,
    ];
    check_drawn([p1, p2], [34, 49]);
}

#[test]
fn a_segment_behind_the_eye_has_no_pixels() {
    let behind = drawn([[0.0, 2.0, 8.0], [3.0, 2.0, 9.0]], [24, 16]);
    laws::check::<LineToPixels>(&behind);
    assert!(silent::<LineToPixels>(&behind).is_empty());
}
