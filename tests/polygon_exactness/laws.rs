//! The laws of traced execution: one line an algorithm.

use clipscope::{
    algo::polygon::{
        ClipRegion, Pipeline, SutherlandHodgman, SutherlandHodgmanInput, Textured,
        faulty::{CutsTwice, DropsOnBorder, EndFirst, Faulty, KeepsUv, LeavesOpen, WalksClockwise},
    },
    geom::{ConvexPolygon, Point, Window},
    trace::laws,
};
use proptest::prelude::*;

fn region() -> impl Strategy<Value = ClipRegion> {
    let regular = (3..9_usize, 0.5..4.0_f64).prop_map(|(n, radius)| {
        let corner = |i: usize| {
            let (sin, cos) = libm::sincos(std::f64::consts::TAU * i as f64 / n as f64);
            [radius * cos, radius * sin]
        };
        let outline: Vec<[f64; 2]> = (0..n).map(corner).collect();
        ConvexPolygon::new(&outline).expect("convex").into()
    });
    let window = Window::new(-2.0, -1.0, 3.0, 2.0).expect("a window");
    prop_oneof![Just(ClipRegion::from(window)), regular]
}

fn input() -> impl Strategy<Value = SutherlandHodgmanInput> {
    let coordinate = || prop_oneof![(-4..=5_i32).prop_map(f64::from), -5.0..5.0_f64];
    let outline = prop::collection::vec([coordinate(), coordinate()], 0..20);
    (region(), outline).prop_map(|(region, outline)| SutherlandHodgmanInput {
        region,
        vertices: super::points(&outline),
    })
}

/// With something at every vertex.
fn with<V>(
    input: SutherlandHodgmanInput,
    vertex: impl Fn(Point, [f64; 2]) -> V,
) -> SutherlandHodgmanInput<V> {
    let vertices = input
        .vertices
        .iter()
        .map(|&at| vertex(at, [at.x(), 0.5]))
        .collect();
    SutherlandHodgmanInput {
        region: input.region,
        vertices,
    }
}

proptest! {
    #[test]
    fn sutherland_hodgman(input in input()) { laws::check::<SutherlandHodgman>(&input); }

    #[test]
    fn pipeline(input in input()) { laws::check::<Pipeline>(&input); }

    #[test]
    fn textured(input in input()) {
        let input = with(input, |at, uv| Textured { at, uv });
        laws::check::<SutherlandHodgman<Textured>>(&input);
        laws::check::<Pipeline<Textured>>(&input);
    }

    #[test]
    fn drops_on_border(input in input()) { laws::check::<Faulty<DropsOnBorder>>(&input); }

    #[test]
    fn leaves_open(input in input()) { laws::check::<Faulty<LeavesOpen>>(&input); }

    #[test]
    fn walks_clockwise(input in input()) { laws::check::<Faulty<WalksClockwise>>(&input); }

    #[test]
    fn cuts_twice(input in input()) { laws::check::<Faulty<CutsTwice>>(&input); }

    #[test]
    fn end_first(input in input()) { laws::check::<Faulty<EndFirst>>(&input); }

    #[test]
    fn keeps_uv(input in input()) {
        laws::check::<SutherlandHodgman<KeepsUv>>(&with(input, |at, uv| KeepsUv { at, uv }));
    }
}
