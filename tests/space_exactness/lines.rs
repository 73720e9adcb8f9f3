//! Segments in boxes, against planes and in clip space, against exact fractions: on whole numbers every sum and product of the
//! clippers is exact, so that each coordinate of an answer has to be the fraction's own nearest number.

use std::fmt::Debug;

use clipscope::{
    algo::volume::{
        Bounds, ClipSpace, CohenSutherland3d, CohenSutherland3dInput, HomogeneousLine,
        LiangBarsky3d, LineClip, LineInput, PlaneLine, SideCode, VisibleLine,
        faulty::{DividedLine, DividesFirst},
    },
    geom::{AlignedBox, Plane},
    trace::{laws, silent},
};
use proptest::prelude::*;

/// A fraction with a positive denominator.
#[derive(Clone, Copy, Debug)]
struct Fraction(i128, i128);

impl Fraction {
    fn new(num: i64, den: i64) -> Self {
        let sign = if den < 0 { -1 } else { 1 };
        Self(i128::from(sign * num), i128::from(sign * den))
    }

    fn is_less(self, other: Self) -> bool {
        self.0 * other.1 < other.0 * self.1
    }

    /// From one end of a segment to the other.
    fn between(self, a: i64, b: i64) -> f64 {
        let whole = i128::from(a) * self.1 + i128::from(b - a) * self.0;
        whole as f64 / self.1 as f64
    }
}

/// The part of a segment on which no distance is negative; `distances` are those of both ends from every border.
fn oracle<const N: usize>(ends: [[i64; N]; 2], distances: &[[i64; 2]]) -> VisibleLine<N> {
    let (mut low, mut high) = (Fraction(0, 1), Fraction(1, 1));
    for &[d1, d2] in distances {
        let at = Fraction::new(d1, d1 - d2);
        if d1 == d2 && d1 < 0 {
            return None;
        } else if d1 < d2 && low.is_less(at) {
            low = at;
        } else if d1 > d2 && at.is_less(high) {
            high = at;
        }
    }
    let at = |t: Fraction| std::array::from_fn(|i| t.between(ends[0][i], ends[1][i]));
    (!high.is_less(low)).then(|| [at(low), at(high)])
}

fn numbers<const N: usize>(ends: [[i64; N]; 2]) -> [[f64; N]; 2] {
    ends.map(|at| at.map(|x| x as f64))
}

/// `min` and `max` of three axes.
fn box_distances(ends: [[i64; 3]; 2], [min, max]: [[i64; 3]; 2]) -> Vec<[i64; 2]> {
    let of = |axis: usize| {
        let low = ends.map(|at| at[axis] - min[axis]);
        let high = ends.map(|at| max[axis] - at[axis]);
        [low, high]
    };
    (0..3).flat_map(of).collect()
}

fn clip_distances(ends: [[i64; 4]; 2]) -> Vec<[i64; 2]> {
    let of = |axis: usize| {
        [
            ends.map(|at| at[3] + at[axis]),
            ends.map(|at| at[3] - at[axis]),
        ]
    };
    (0..3).flat_map(of).collect()
}

fn aligned([min, max]: [[i64; 3]; 2]) -> AlignedBox {
    let [a, b, c, d, e, f] = [min[0], min[1], min[2], max[0], max[1], max[2]].map(|x| x as f64);
    AlignedBox::new([a, b, c, d, e, f]).expect("ordered")
}

fn place(reach: i64) -> impl Strategy<Value = [i64; 3]> {
    prop::array::uniform3(-reach..=reach)
}

fn some_box() -> impl Strategy<Value = [[i64; 3]; 2]> {
    let sizes = prop::array::uniform3(1..5_i64);
    (place(3), sizes).prop_map(|(min, size)| [min, std::array::from_fn(|i| min[i] + size[i])])
}

fn clip_place() -> impl Strategy<Value = [i64; 4]> {
    prop::array::uniform4(-6..7_i64).prop_filter("a point", |at| *at != [0; 4])
}

fn some_plane() -> impl Strategy<Value = [i64; 4]> {
    prop::array::uniform4(-4..5_i64).prop_filter("a direction", |[a, b, c, _]| [a, b, c] != [&0; 3])
}

fn odd_number() -> impl Strategy<Value = f64> {
    prop_oneof![
        6 => -3.0..3.0,
        1 => Just(0.0),
        2 => Just(1.0),
        2 => Just(-1.0),
        1 => Just(5e-324),
        1 => Just(-1e-300),
        1 => Just(1e300),
        1 => Just(f64::MAX),
        1 => Just(f64::MIN),
        1 => Just(1.0 + f64::EPSILON),
        1 => Just(-1.0 + 0.5 * f64::EPSILON),
    ]
}

fn bits<const N: usize>(visible: VisibleLine<N>) -> Option<[[u64; N]; 2]> {
    visible.map(|ends| ends.map(|at| at.map(|x| (x + 0.0).to_bits())))
}

/// The answer for a segment, and for the same walked the other way: swapped, bit for bit.
fn from_both_ends<const N: usize, B>(bounds: &B, [p1, p2]: [[f64; N]; 2]) -> VisibleLine<N>
where
    B: Bounds<N, Input = LineInput<N, B>, Output = VisibleLine<N>>,
{
    let clip = |ends| {
        let bounds = bounds.clone();
        silent::<LineClip<N, B>>(&LineInput { bounds, ends })
    };
    let (there, back) = (clip([p1, p2]), clip([p2, p1]));
    assert_eq!(
        bits(there),
        bits(back.map(|[a, b]| [b, a])),
        "{p1:?} {p2:?}"
    );
    there
}

fn in_box(bounds: AlignedBox, ends: [[f64; 3]; 2]) -> [VisibleLine<3>; 2] {
    [
        silent::<CohenSutherland3d>(&CohenSutherland3dInput { bounds, ends }),
        silent::<LiangBarsky3d>(&LineInput { bounds, ends }),
    ]
}

fn unit_box() -> AlignedBox {
    aligned([[-1; 3], [1; 3]])
}

proptest! {
    #[test]
    fn both_box_clippers_give_the_fractions(ends in prop::array::uniform2(place(8)), bounds in some_box()) {
        let expected = oracle(ends, &box_distances(ends, bounds));
        let (bounds, ends) = (aligned(bounds), numbers(ends));
        for found in in_box(bounds, ends) {
            prop_assert_eq!(found, expected);
        }
        laws::check::<CohenSutherland3d>(&CohenSutherland3dInput { bounds, ends });
        laws::check::<LiangBarsky3d>(&LineInput { bounds, ends });
    }

    #[test]
    fn quarters_of_the_unit_box_give_the_fractions(ends in prop::array::uniform2(place(9))) {
        // All in quarters: four is one.
        let expected = oracle(ends, &box_distances(ends, [[-4; 3], [4; 3]]));
        let expected = expected.map(|ends| ends.map(|at| at.map(|x| 0.25 * x)));
        let ends = numbers(ends).map(|at| at.map(|x| 0.25 * x));
        for found in in_box(unit_box(), ends) {
            prop_assert_eq!(found, expected);
        }
    }

    #[test]
    fn planes_of_any_direction_give_the_fractions(
        ends in prop::array::uniform2(place(6)),
        planes in prop::collection::vec(some_plane(), 1..6),
    ) {
        let of = |[a, b, c, d]: &[i64; 4]| ends.map(|[x, y, z]| a * x + b * y + c * z + d);
        let distances: Vec<[i64; 2]> = planes.iter().map(of).collect();
        let expected = oracle(ends, &distances);
        let planes = planes.iter().map(|row| Plane::new(row.map(|x| x as f64)).unwrap());
        let (bounds, ends) = (planes.collect::<Vec<_>>(), numbers(ends));
        let found = from_both_ends(&bounds, ends);
        match (found, expected) {
            (Some(found), Some(expected)) => {
                // Square to an axis −d/n is rounded before it is assigned, elsewhere nothing is.
                for (a, b) in found.as_flattened().iter().zip(expected.as_flattened()) {
                    prop_assert!((a - b).abs() <= 1e-15 * b.abs(), "{:?} {:?}", found, expected);
                }
            }
            (found, expected) => prop_assert_eq!(found, expected),
        }
        laws::check::<PlaneLine>(&LineInput { bounds, ends });
    }

    #[test]
    fn clip_space_gives_the_fractions_and_assigns_its_sides(ends in prop::array::uniform2(clip_place())) {
        let expected = oracle(ends, &clip_distances(ends));
        let given = numbers(ends);
        let found = from_both_ends(&ClipSpace, given);
        prop_assert_eq!(found, expected);
        for at in found.iter().flatten().filter(|at| !given.contains(at)) {
            let w = at[3];
            prop_assert!(at[..3].iter().any(|x| x.abs().to_bits() == w.abs().to_bits()), "{:?}", at);
        }
        if ends.iter().all(|at| at[3] < 0) {
            prop_assert_eq!(found, None, "behind the eye");
        }
        let input = LineInput { bounds: ClipSpace, ends: given };
        laws::check::<HomogeneousLine>(&input);
        laws::check::<DividedLine>(&input);
    }

    /// 90°, near 1, far 3: then z_clip = −2z − 3 and w = −z, and every number is whole.
    #[test]
    fn clip_space_and_view_space_agree(ends in prop::array::uniform2(place(5))) {
        let planes = [[0, 0, -1, -1], [0, 0, 1, 3], [1, 0, -1, 0], [-1, 0, -1, 0], [0, 1, -1, 0], [0, -1, -1, 0]];
        let bounds: Vec<Plane> = planes.map(|row: [i32; 4]| Plane::new(row.map(f64::from)).unwrap()).into();
        let in_view = silent::<PlaneLine>(&LineInput { bounds, ends: numbers(ends) });
        let clip_from_view = |[x, y, z]: [f64; 3]| [x, y, -2.0 * z - 3.0, -z];
        let ends = numbers(ends).map(clip_from_view);
        let in_clip = silent::<HomogeneousLine>(&LineInput { bounds: ClipSpace, ends });
        prop_assert_eq!(in_view.is_some(), in_clip.is_some());
        for (view, clip) in in_view.iter().flatten().zip(in_clip.iter().flatten()) {
            for (a, b) in clip_from_view(*view).iter().zip(clip) {
                prop_assert!((a - b).abs() < 1e-13, "{:?} {:?}", view, clip);
            }
            prop_assert!(clip[3] >= 1.0 - 1e-13, "inside is before the eye");
        }
    }

    #[test]
    fn any_numbers_keep_their_promises_in_a_box(
        ends in prop::array::uniform2(prop::array::uniform3(odd_number())),
    ) {
        let bounds = unit_box();
        let there = from_both_ends(&bounds, ends);
        let [p1, p2] = ends;
        let [cut, _] = in_box(bounds, ends);
        let [back, _] = in_box(bounds, [p2, p1]);
        prop_assert_eq!(bits(cut), bits(back.map(|[a, b]| [b, a])));
        for visible in [there, cut].into_iter().flatten() {
            for at in visible {
                prop_assert!(SideCode::of_box(at, &bounds).is_inside(), "{:?}", at);
            }
            for again in in_box(bounds, visible) {
                prop_assert_eq!(again, Some(visible), "clipping again changes nothing");
            }
        }
        laws::check::<CohenSutherland3d>(&CohenSutherland3dInput { bounds, ends });
        laws::check::<LiangBarsky3d>(&LineInput { bounds, ends });
    }

    #[test]
    fn any_numbers_keep_their_promises_in_clip_space(
        ends in prop::array::uniform2(prop::array::uniform4(odd_number())),
    ) {
        let found = from_both_ends(&ClipSpace, ends);
        for (at, given) in found.iter().flatten().zip(ends) {
            prop_assert!(SideCode::of(*at).is_inside(), "{:?}", at);
            prop_assert!(!SideCode::of(given).is_inside() || *at == given, "inside stays");
        }
        if let Some(visible) = found {
            prop_assert_eq!(from_both_ends(&ClipSpace, visible), found, "clipping again changes nothing");
        }
        let input = LineInput { bounds: ClipSpace, ends };
        laws::check::<HomogeneousLine>(&input);
        laws::check::<DividedLine>(&input);
    }

    #[test]
    fn any_numbers_are_answered_by_planes(
        ends in prop::array::uniform2(prop::array::uniform3(odd_number())),
        rows in prop::collection::vec(prop::array::uniform4(odd_number()), 1..5),
    ) {
        let bounds: Vec<Plane> = rows.into_iter().filter_map(|row| Plane::new(row).ok()).collect();
        prop_assume!(!bounds.is_empty());
        let found = from_both_ends(&bounds, ends);
        prop_assert!(found.iter().flatten().flatten().all(|x| x.is_finite()), "{:?}", found);
        laws::check::<PlaneLine>(&LineInput { bounds, ends });
    }
}

fn check_box(what: &str, ends: [[f64; 3]; 2], expected: VisibleLine<3>) {
    for found in in_box(unit_box(), ends) {
        assert_eq!(found, expected, "{what}");
    }
}

#[test]
fn touches_corners_and_parallels_in_a_box() {
    let edge = [-1.0, 1.0, 0.0];
    check_box(
        "an edge",
        [[-2.0, 0.0, 0.0], [0.0, 2.0, 0.0]],
        Some([edge; 2]),
    );
    let corner = [1.0; 3];
    let through = [[2.0, 0.0, 1.0], [0.0, 2.0, 1.0]];
    check_box("a corner, along a face", through, Some([corner; 2]));
    let along = [[-3.0, 1.0, 1.0], [3.0, 1.0, 1.0]];
    check_box("along an edge", along, Some([[-1.0, 1.0, 1.0], corner]));
    let beside = [[-3.0, 1.25, 0.0], [3.0, 1.25, 0.0]];
    check_box("parallel, outside", beside, None);
    check_box("a point on a face", [edge; 2], Some([edge; 2]));
    check_box("a point outside", [[0.0, 0.0, 1.5]; 2], None);
    let all_six = [[-3.0, -2.5, -2.0], [3.0, 2.5, 2.0]];
    let far = [1.0, 2.5 / 3.0, 2.0 / 3.0];
    check_box(
        "beyond three faces at either end",
        all_six,
        Some([far.map(|x| -x), far]),
    );
}

#[test]
fn the_eye_is_where_a_line_through_it_ends() {
    let clip = |ends| {
        silent::<HomogeneousLine>(&LineInput {
            bounds: ClipSpace,
            ends,
        })
    };
    let before = [0.0, 0.0, 0.0, 1.0];
    assert_eq!(
        clip([before, [0.0, 0.0, 0.0, -1.0]]),
        Some([before, [0.0; 4]])
    );
    let at_infinity = [3.0, 0.0, 0.0, 0.0];
    assert_eq!(
        clip([before, at_infinity]),
        Some([before, [0.75, 0.0, 0.0, 0.75]])
    );
    assert_eq!(
        clip([at_infinity; 2]),
        None,
        "w = 0 alone is no point of the volume"
    );
    // Rounded distances touch in the middle; w < 0 there as everywhere.
    let hair = [[1.0, 0.0, 0.0, -1e-300], [-1.0, 0.0, 0.0, -1e-300]];
    assert_eq!(clip(hair), None);
}

/// Erratum E10: a point behind the eye lands inside the cube, and the segment to its image was never there.
#[test]
fn divided_first_a_point_behind_the_eye_lands_in_the_cube() {
    let ends = [[0.0, 0.0, 0.0, 2.0], [1.0, 0.0, 0.0, -2.0]];
    let input = LineInput {
        bounds: ClipSpace,
        ends,
    };
    let right = silent::<HomogeneousLine>(&input);
    let w = 2.0 / 5.0;
    assert_eq!(
        right,
        Some([ends[0], [w, 0.0, 0.0, w]]),
        "it leaves by the right side"
    );
    let wrong = silent::<LineClip<4, ClipSpace, DividesFirst>>(&input);
    let image = [-0.5, 0.0, 0.0, 1.0];
    assert_eq!(
        wrong,
        Some([[0.0, 0.0, 0.0, 1.0], image]),
        "to the left of P₁"
    );
}
