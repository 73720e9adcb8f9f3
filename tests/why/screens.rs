//! What an eye sees: a projection's row, faces, a fence, a line in pixels, sides of a plane, a side's normal.

use clipscope::{
    algo::{
        cull::{BackFace, BackFaceInput, Viewer},
        pipeline::{Bresenham, BresenhamEvent, BresenhamInput},
        why::{
            CrossesOnce, CrossesOnceFact, CrossesOnceInput, ErrorTerm, ErrorTermFact,
            ErrorTermInput, Facing, FacingFact, FacingInput, Fence, FenceFact, FenceInput,
            ProjectionRow, ProjectionRowFact, ProjectionRowInput, QuarterTurn, QuarterTurnFact,
            QuarterTurnInput,
        },
    },
    geom::{Plane, ViewVolume, VolumeSide},
    trace::{Recording, silent},
};
use proptest::prelude::*;

use super::{near, shown};

fn whole() -> impl Strategy<Value = f64> {
    (-20..=20_i32).prop_map(f64::from)
}

fn places() -> impl Strategy<Value = [f64; 3]> {
    prop::array::uniform3(whole())
}

fn volumes() -> impl Strategy<Value = ViewVolume> {
    (any::<bool>(), 1.0..170.0, 0.2..4.0, 0.1..5.0, 0.5..50.0).prop_map(
        |(is_parallel, open, aspect, near, depth)| {
            let volume = if is_parallel {
                ViewVolume::parallel(open, aspect, near, near + depth)
            } else {
                ViewVolume::perspective(open, aspect, near, near + depth)
            };
            volume.unwrap()
        },
    )
}

proptest! {
    /// The two conditions give the row that the program uses, and order on the ruler is order of depth.
    #[test]
    fn row_three_is_fixed_by_near_and_far(volume in volumes(), part in 0.0..1.0) {
        let depth = volume.near() + part * (volume.far() - volume.near());
        let number = shown::<ProjectionRow>(&ProjectionRowInput { volume, depth });
        let fact = |fact| number(fact).expect("shown");
        let [_, _, [.., scale, offset], _] = volume.clip_from_view().rows();
        prop_assert!(near(fact(ProjectionRowFact::Slope), -scale));
        prop_assert!(near(fact(ProjectionRowFact::AtZero), offset));
        let divided = fact(ProjectionRowFact::Divided);
        prop_assert!((-1.0 - 1e-9..=1.0 + 1e-9).contains(&divided));
        let deeper = ProjectionRowInput { volume, depth: depth + 0.5 };
        prop_assert!(shown::<ProjectionRow>(&deeper)(ProjectionRowFact::Divided).unwrap() > divided);
        let middle = fact(ProjectionRowFact::Middle);
        prop_assert!((volume.near()..=volume.far()).contains(&middle));
    }

    /// A turn keeps lengths: the normal has length 1, and is the one of the volume.
    #[test]
    fn a_quarter_turn_makes_the_right_planes_normal(volume in volumes(), point in places()) {
        let number = shown::<QuarterTurn>(&QuarterTurnInput { volume, point });
        let fact = |fact| number(fact).expect("shown");
        prop_assert_eq!(fact(QuarterTurnFact::TurnedAcross), -fact(QuarterTurnFact::Ahead));
        prop_assert_eq!(fact(QuarterTurnFact::TurnedAhead), fact(QuarterTurnFact::Across));
        let plane = volume.planes()[VolumeSide::Right as usize];
        let [x, y, z] = plane.normal();
        prop_assert!(near(x, fact(QuarterTurnFact::TurnedAcross)) && y == 0.0);
        prop_assert!(near(-z, fact(QuarterTurnFact::TurnedAhead)));
        let distance = x * point[0] + z * point[2] + plane.d();
        prop_assert!((distance - fact(QuarterTurnFact::Distance)).abs() < 1e-9);
    }

    /// The eye is above the bar of exactly those faces that the test draws.
    #[test]
    fn the_eye_is_above_the_faces_that_are_drawn(
        faces in prop::collection::vec(prop::array::uniform3(places()), 1..9),
        eye in places(),
        is_far in any::<bool>(),
    ) {
        let viewer = if is_far && eye != [0.0; 3] { Viewer::Direction(eye) } else { Viewer::Eye(eye) };
        let others = (1..faces.len()).collect();
        let input = FacingInput { faces, first: 0, others, viewer };
        let number = shown::<Facing>(&input);
        let fronts = input.faces.iter().map(|&triangle| silent::<BackFace>(&BackFaceInput { triangle, viewer }).front);
        let fronts: Vec<bool> = fronts.collect();
        let Some(n_fronts) = number(FacingFact::Fronts) else {
            prop_assert_eq!(number(FacingFact::Length), Some(0.0));
            return Ok(());
        };
        prop_assert_eq!(n_fronts, fronts.iter().filter(|it| **it).count() as f64);
        let others = (1..fronts.len()).map(|face| (FacingFact::Face { face }, face));
        for (fact, face) in [(FacingFact::Height, 0)].into_iter().chain(others) {
            let height = number(fact).unwrap_or(0.0);
            prop_assert_eq!(height > 0.0, fronts[face]);
        }
    }

    /// Drops are equal to each other, wherever the fence stands.
    #[test]
    fn one_over_depth_falls_evenly_from_post_to_post(
        across in prop::array::uniform2(whole()),
        ahead in prop::array::uniform2(1..40_i32),
    ) {
        let ends = [0, 1].map(|i| [across[i], f64::from(ahead[i])]);
        let number = shown::<Fence>(&FenceInput::new(ends));
        let Some(step) = number(FenceFact::Step) else {
            prop_assert!(near(across[0] / f64::from(ahead[0]), across[1] / f64::from(ahead[1])));
            return Ok(());
        };
        let post = |nth: usize| number(match nth {
            0 => FenceFact::First,
            FenceInput::STEPS => FenceFact::Last,
            nth => FenceFact::Post { nth },
        });
        let heights: Vec<f64> = (0..=FenceInput::STEPS).map(|nth| 1.0 / post(nth).unwrap()).collect();
        prop_assert!(heights.windows(2).all(|pair| near(pair[0] - pair[1], step)), "{:?}", heights);
    }

    /// Every number is whole, and e is that of the algorithm, one pixel earlier.
    #[test]
    fn parts_of_a_pixel_give_bresenhams_e(from in prop::array::uniform2(-9..9_i64), to in prop::array::uniform2(-9..9_i64)) {
        let ends = BresenhamInput::new(from, to).unwrap();
        let number = shown::<ErrorTerm>(&ErrorTermInput { ends: Some(ends) });
        let recording = Recording::<Bresenham>::new(ends);
        // Exactly between two pixels the algorithm takes the smaller coordinate: from there on rows may differ.
        for (column, event) in (1..=ErrorTermInput::MOST_COLUMNS).zip(recording.events()) {
            let BresenhamEvent::Pixel { error, at, .. } = *event;
            if at == to {
                break;
            }
            prop_assert_eq!(number(ErrorTermFact::Error { column }), Some(error as f64));
            if error == 0 {
                break;
            }
        }
        let [x, y] = ends.distances();
        prop_assert_eq!(number(ErrorTermFact::Parts), Some(2.0 * x.max(y) as f64));
    }

    /// At no place on the way to Q is the distance 0; on the way to R it is, once.
    #[test]
    fn a_sight_meets_a_plane_once(plane in prop::array::uniform4(whole()), [eye, a, b] in prop::array::uniform3(places()), u in 0.0..1.0) {
        let Ok(plane) = Plane::new(plane) else { return Ok(()) };
        let distance = |[x, y, z]: [f64; 3]| {
            let [nx, ny, nz] = plane.unit_normal();
            nx * x + ny * y + nz * z + plane.d() / plane.length()
        };
        prop_assume!(distance(eye) > 0.1);
        let own = [a, b].into_iter().find(|at| distance(*at) > 0.1);
        let other = [a, b].into_iter().find(|at| distance(*at) < -0.1);
        let number = shown::<CrossesOnce>(&CrossesOnceInput { plane: Some(plane), eye, own, other });
        let between = |to: [f64; 3], part: f64| -> [f64; 3] { std::array::from_fn(|i| eye[i] + part * (to[i] - eye[i])) };
        if let Some(own) = own {
            let least = number(CrossesOnceFact::Least).expect("shown");
            prop_assert!(least > 0.0 && distance(between(own, u)) >= least - 1e-9);
        }
        if let Some(other) = other {
            let part = number(CrossesOnceFact::Crossing).expect("shown");
            prop_assert!(distance(between(other, part)).abs() < 1e-9);
            prop_assert_eq!(distance(between(other, u)) > 0.0, u < part);
        }
    }
}
