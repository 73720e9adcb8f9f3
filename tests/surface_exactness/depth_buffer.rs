//! The depth buffer.

use clipscope::{
    algo::ring::Right,
    algo::surface::{
        DepthBits, DepthBuffer, DepthBufferInput, DepthFormat, DepthNumber, DepthSteps, Picture,
        Surfaces,
        faulty::{
            ClearsToNear, FaultyDepthBuffer, StraightDistance, TurnsComparison, WritesAlways,
        },
        pixel_story,
    },
    geom::ViewVolume,
    trace::{Recording, laws, silent},
};
use proptest::prelude::*;

use super::{
    oracle::{Seen, pixels, seen},
    soup::{cases, soup, surfaces},
};

const STEPS: [DepthSteps; 3] = [
    DepthSteps::Fragments,
    DepthSteps::Spans,
    DepthSteps::Triangles,
];

fn format(bits: u32, is_reversed: bool) -> DepthFormat {
    let number = match bits {
        0 => DepthNumber::Double,
        33 => DepthNumber::Single,
        _ => DepthNumber::Fixed(DepthBits::new(bits).expect("32 at most")),
    };
    DepthFormat {
        number,
        is_reversed,
    }
}

proptest! {
    #![proptest_config(cases(300))]

    #[test]
    fn every_middle_is_that_of_the_nearest(triangles in soup(12), culls in any::<bool>()) {
        let output = silent::<DepthBuffer>(&DepthBufferInput::new(surfaces(&triangles, culls)));
        for pixel in pixels() {
            let place = output.picture.place(pixel);
            match seen(&triangles, culls, pixel) {
                Seen::Unsure => {}
                Seen::Nothing => {
                    prop_assert_eq!(output.picture.at(pixel), None, "{:?}", pixel);
                    prop_assert_eq!(output.depth[place], f64::INFINITY);
                }
                Seen::Surface { id, depth } => {
                    prop_assert_eq!(output.picture.at(pixel), Some(id), "{:?}", pixel);
                    prop_assert!((output.depth[place] - depth).abs() < 1e-9, "{:?}: {} {}", pixel, output.depth[place], depth);
                }
            }
        }
    }

    /// But for exact ties, of which the first that was drawn is seen.
    #[test]
    fn the_order_of_triangles_changes_nothing(triangles in soup(12), turn in 0..12_usize) {
        let input = DepthBufferInput::new(surfaces(&triangles, false));
        let mut shuffled = input.clone();
        shuffled.order.reverse();
        shuffled.order.rotate_left(turn % triangles.len());
        let [one, other] = [&input, &shuffled].map(silent::<DepthBuffer>);
        prop_assert_eq!(&one.depth, &other.depth);
        for pixel in pixels() {
            if one.picture.at(pixel) != other.picture.at(pixel) {
                let story = pixel_story::<Right>(&shuffled, pixel);
                let nearest = one.depth[one.picture.place(pixel)];
                let mut tied = story.iter().filter(|fragment| fragment.new == nearest);
                prop_assert_eq!(tied.next().map(|fragment| fragment.id), other.picture.at(pixel));
                prop_assert!(tied.next().is_some(), "no tie at {:?}", pixel);
            }
        }
    }
}

proptest! {
    #![proptest_config(cases(12))]

    #[test]
    fn the_laws(triangles in soup(4), bits in prop::sample::select(vec![0, 8, 33]), is_reversed in any::<bool>(), column in 0..16_u32) {
        let mut input = DepthBufferInput::new(
            Surfaces::new([7, 5], super::soup::volume(), super::soup::placed(&triangles), false).expect("finite"),
        );
        input.format = format(bits, is_reversed);
        for steps in STEPS {
            input.steps = steps;
            for pixel in [None, Some([column, 2])] {
                input.pixel = pixel;
                laws::check::<DepthBuffer>(&input);
                laws::check::<FaultyDepthBuffer<ClearsToNear>>(&input);
                laws::check::<FaultyDepthBuffer<TurnsComparison>>(&input);
                laws::check::<FaultyDepthBuffer<WritesAlways>>(&input);
                laws::check::<FaultyDepthBuffer<StraightDistance>>(&input);
            }
        }
    }

    /// A pixel's story is what the whole run does there, and ends with what stands in the picture.
    #[test]
    fn a_story_is_a_part_of_the_whole(triangles in soup(9)) {
        let input = DepthBufferInput::new(surfaces(&triangles, false));
        let trace = Recording::<DepthBuffer>::new(input.clone());
        let mut all: Vec<Vec<_>> = vec![Vec::new(); input.surfaces.n_pixels()];
        for event in trace.events() {
            if let clipscope::algo::surface::DepthBufferEvent::Fragment { fragment, .. } = *event {
                all[trace.output().picture.place(fragment.pixel)].push(fragment);
            }
        }
        for (pixel, expected) in pixels().zip(all) {
            let story = pixel_story::<Right>(&input, pixel);
            prop_assert_eq!(&story, &expected);
            let last = story.iter().rfind(|fragment| fragment.kept);
            prop_assert_eq!(last.map(|fragment| fragment.id), trace.output().picture.at(pixel));
        }
    }
}

/// A wall across the whole picture at a distance.
fn wall(distance: f64) -> [[f64; 3]; 3] {
    let (z, wide) = (-distance, 9.0 * distance.abs());
    [[-wide, -wide, z], [wide, -wide, z], [0.0, 2.0 * wide, z]]
}

fn of_walls(distances: &[f64], [near, far]: [f64; 2]) -> DepthBufferInput {
    let volume = ViewVolume::perspective(70.0, 1.25, near, far).expect("a volume");
    let walls: Vec<_> = distances.iter().map(|&d| wall(d)).collect();
    DepthBufferInput::new(Surfaces::new([5, 4], volume, walls, false).expect("finite"))
}

#[test]
fn near_and_far_are_closed() {
    // None of these is a power of two: the projection rounds.
    for ends in [[0.1, 0.7], [0.3, 100.1], [1.7, 1.9]] {
        for (distance, depth) in [(ends[0], 0.0), (ends[1], 1.0)] {
            let output = silent::<DepthBuffer>(&of_walls(&[distance], ends));
            assert_eq!(output.tally.pixels, 20, "{ends:?} {distance}");
            assert!(output.depth.iter().all(|d| (d - depth).abs() < 1e-12));
        }
        let outside = [ends[0].next_down(), ends[1].next_up(), -1.0];
        let output = silent::<DepthBuffer>(&of_walls(&outside, ends));
        assert_eq!(output.tally.fragments, 0, "{ends:?}");
    }
}

#[test]
fn few_bits_leave_surfaces_to_the_order() {
    let mut input = of_walls(&[9.0, 8.0], [0.5, 10.0]);
    let at = |input: &DepthBufferInput| silent::<DepthBuffer>(input).picture.ids()[0];
    assert_eq!(at(&input), 1, "nearer");
    input.format = format(5, false);
    assert_eq!(at(&input), 0, "in one step: the first");
    let depth = silent::<DepthBuffer>(&input).depth[0];
    assert!((input.format.step(depth) - 1.0 / 31.0).abs() < 1e-15);
    // Reversed, f32 has its finest steps far away; fixed point gains nothing.
    let mut far = of_walls(&[99_999.0, 99_998.0], [0.01, 100_000.0]);
    far.format = format(33, false);
    assert_eq!(at(&far), 0);
    far.format = format(33, true);
    assert_eq!(at(&far), 1);
    far.format = format(24, true);
    assert_eq!(at(&far), 0);
}

#[test]
fn each_mistake_shows() {
    let input = of_walls(&[3.0, 2.0, 5.0], [1.0, 10.0]);
    let right = Recording::<DepthBuffer>::new(input.clone());
    assert_eq!(right.output().picture.ids(), [1; 20]);
    assert_eq!(
        right.first_difference::<FaultyDepthBuffer<ClearsToNear>>(),
        Some(1)
    );
    assert!(
        right
            .first_difference::<FaultyDepthBuffer<TurnsComparison>>()
            .is_some()
    );
    assert!(
        right
            .first_difference::<FaultyDepthBuffer<WritesAlways>>()
            .is_some()
    );
    let ids = |picture: Picture| picture.ids().to_vec();
    let cleared = silent::<FaultyDepthBuffer<ClearsToNear>>(&input);
    assert_eq!(ids(cleared.picture), [-1; 20]);
    let turned = silent::<FaultyDepthBuffer<TurnsComparison>>(&input);
    assert_eq!(ids(turned.picture), [-1; 20]);
    let written = silent::<FaultyDepthBuffer<WritesAlways>>(&input);
    assert_eq!(ids(written.picture), [2; 20]);
}

#[test]
fn straight_distance_puts_a_floor_before_a_wall() {
    // A floor from near to far, and a wall across it, 3 before the eye.
    let volume = ViewVolume::perspective(90.0, 1.0, 1.0, 20.0).expect("a volume");
    let floor = [[-40.0, -1.0, -1.0], [40.0, -1.0, -1.0], [0.0, -1.0, -20.0]];
    let surfaces = Surfaces::new([8, 32], volume, [floor, wall(3.0)], false).expect("finite");
    let input = DepthBufferInput::new(surfaces);
    let [right, wrong] = [
        silent::<DepthBuffer>(&input).picture,
        silent::<FaultyDepthBuffer<StraightDistance>>(&input).picture,
    ];
    // The floor meets the wall a third of the way up from the bottom edge to the horizon.
    let floor_rows = |picture: &Picture| {
        (0..32)
            .filter(|&row| picture.at([4, row]) == Some(0))
            .count()
    };
    assert_eq!(floor_rows(&right), 11);
    assert!(floor_rows(&wrong) < 11, "{}", floor_rows(&wrong));
}
