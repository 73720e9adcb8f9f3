//! What light comes through: painted from far to near it is right, and one depth a pixel is not enough to come to that.

use clipscope::{
    algo::surface::{DepthBuffer, DepthBufferInput, Painter, PainterAnswer, Surfaces, Tint},
    trace::{laws, silent},
};
use proptest::prelude::*;

use super::soup::{FAR, NEAR, SIZE, cases, soup, surfaces, volume};

fn tint((opacity, brightness): (f64, f64)) -> Tint {
    Tint::new(opacity, brightness).expect("parts of one")
}

fn part() -> impl Strategy<Value = (f64, f64)> {
    (0.0..=1.0, 0.0..=1.0)
}

/// Walls across the whole picture at these distances.
fn walls(distances: &[f64], tints: &[(f64, f64)]) -> Surfaces {
    let wall = |&d: &f64| {
        [
            [-20.0 * d, -20.0 * d, -d],
            [20.0 * d, -20.0 * d, -d],
            [0.0, 40.0 * d, -d],
        ]
    };
    let walls: Vec<_> = distances.iter().map(wall).collect();
    let surfaces = Surfaces::new(SIZE, volume(), walls, false).expect("finite");
    let tints: Vec<Tint> = tints.iter().copied().map(tint).collect();
    surfaces.with_tints(tints).expect("one for each")
}

fn drawn(surfaces: &Surfaces, order: &[u32]) -> Vec<f64> {
    let input = DepthBufferInput {
        order: order.to_vec(),
        ..DepthBufferInput::new(surfaces.clone())
    };
    silent::<DepthBuffer>(&input).brightness
}

#[test]
fn two_panes_before_a_wall_by_their_orders() {
    let surfaces = walls(&[2.0, 3.0, 4.0], &[(0.5, 0.25), (0.5, 0.75), (1.0, 0.0)]);
    for (order, expected) in [
        // ½·¼ + ½·(½·¾ + ½·0)
        ([2, 1, 0], 0.3125),
        // ½·¼ + ½·0: the second pane is lost.
        ([2, 0, 1], 0.125),
        ([1, 2, 0], 0.5625),
        ([1, 0, 2], 0.5625),
        ([0, 1, 2], 0.625),
        ([0, 2, 1], 0.625),
    ] {
        assert_eq!(drawn(&surfaces, &order)[0], expected, "{order:?}");
    }
    assert_eq!(surfaces.sorted_brightness()[0], 0.3125);
    assert_eq!(silent::<Painter>(&surfaces).brightness[0], 0.3125);
}

#[test]
fn a_tint_is_a_part_of_one_and_each_triangle_has_its_own() {
    for wrong in [
        (-0.1, 0.5),
        (1.1, 0.5),
        (0.5, -0.1),
        (0.5, 1.1),
        (f64::NAN, 0.5),
    ] {
        assert_eq!(Tint::new(wrong.0, wrong.1), None, "{wrong:?}");
    }
    let surfaces = walls(&[2.0, 3.0], &[(0.5, 0.25), (1.0, 0.0)]);
    assert_eq!(surfaces.tint(1), surfaces.part(1..2).tint(0));
    assert!(surfaces.with_tints([tint((0.5, 0.5))]).is_none());
}

proptest! {
    #![proptest_config(cases(200))]

    /// The painter, the depth buffer drawn from far to near, and each pixel sorted by itself agree bit for bit.
    #[test]
    fn from_far_to_near_all_agree(
        distances in prop::collection::btree_set(8_u32..120, 1..6),
        tints in prop::collection::vec(part(), 6),
        seed in any::<u64>(),
    ) {
        let n = distances.len();
        let mut distances: Vec<f64> = distances.into_iter().map(|d| f64::from(d) / 8.0).collect();
        distances.rotate_left(seed as usize % n);
        prop_assert!(distances.iter().all(|d| (NEAR..=FAR).contains(d)));
        let surfaces = walls(&distances, &tints[..n]);
        let mut order: Vec<u32> = surfaces.ids().collect();
        order.sort_by(|a, b| distances[*b as usize].total_cmp(&distances[*a as usize]));
        let expected = surfaces.sorted_brightness();
        prop_assert_eq!(&drawn(&surfaces, &order), &expected);
        let painted = silent::<Painter>(&surfaces);
        let is_ordered = matches!(painted.answer, PainterAnswer::Order { .. });
        prop_assert!(is_ordered);
        prop_assert_eq!(&painted.brightness, &expected);
        prop_assert!(expected.iter().all(|c| (-1e-12..=1.0 + 1e-12).contains(c)));
    }

    /// What is opaque is as bright as what is seen there, in every order; and the laws hold.
    #[test]
    fn of_what_is_opaque_no_order_counts(triangles in soup(6), tints in prop::collection::vec(part(), 6)) {
        let surfaces = surfaces(&triangles, false);
        let n = triangles.len();
        let opaque: Vec<Tint> = tints[..n].iter().map(|&(_, own)| tint((1.0, own))).collect();
        let opaque = surfaces.clone().with_tints(opaque).expect("one for each");
        let output = silent::<DepthBuffer>(&DepthBufferInput::new(opaque.clone()));
        for (id, brightness) in output.picture.ids().iter().zip(&output.brightness) {
            let seen = u32::try_from(*id).ok().and_then(|id| opaque.tint(id));
            prop_assert_eq!(*brightness, seen.map_or(Tint::PAPER, Tint::brightness));
        }
        prop_assert_eq!(&opaque.sorted_brightness(), &output.brightness);
        let glass: Vec<Tint> = tints[..n].iter().copied().map(tint).collect();
        let glass = surfaces.with_tints(glass).expect("one for each");
        laws::check::<Painter>(&glass);
        laws::check::<DepthBuffer>(&DepthBufferInput::new(glass));
    }
}
