//! The laws of traced execution: one line an algorithm.

use clipscope::{
    algo::line::{
        BitOrder, BruteForce, CohenSutherland, CohenSutherlandInput, CyrusBeck, CyrusBeckInput,
        LiangBarsky, NichollLeeNicholl, WindowInput, faulty::OutwardCyrusBeck,
    },
    geom::{ConvexPolygon, Segment, Window},
    trace::laws,
};
use proptest::prelude::*;

fn input() -> impl Strategy<Value = WindowInput> {
    let window = Window::new(-2.0, -1.0, 3.0, 2.0).expect("a window");
    let coordinate = || prop_oneof![(-4..=5_i32).prop_map(f64::from), -5.0..5.0_f64];
    [coordinate(), coordinate(), coordinate(), coordinate()].prop_map(move |s| WindowInput {
        window,
        segment: Segment::try_from(s).expect("finite"),
    })
}

/// A regular polygon with a few sides of its own size, either winding.
fn polygon() -> impl Strategy<Value = ConvexPolygon> {
    (3..12_usize, 0.5..4.0_f64, any::<bool>()).prop_map(|(n, radius, clockwise)| {
        let mut outline: Vec<[f64; 2]> = (0..n)
            .map(|i| {
                let (sin, cos) = libm::sincos(std::f64::consts::TAU * i as f64 / n as f64);
                [radius * cos, radius * sin]
            })
            .collect();
        if clockwise {
            outline.reverse();
        }
        ConvexPolygon::new(&outline).expect("convex")
    })
}

proptest! {
    #[test]
    fn brute_force(input in input()) { laws::check::<BruteForce>(&input); }

    #[test]
    fn cohen_sutherland(WindowInput { window, segment } in input(), tbrl in any::<bool>()) {
        let bit_order = if tbrl { BitOrder::Tbrl } else { BitOrder::Lrbt };
        laws::check::<CohenSutherland>(&CohenSutherlandInput { window, segment, bit_order });
    }

    #[test]
    fn liang_barsky(input in input()) { laws::check::<LiangBarsky>(&input); }

    #[test]
    fn cyrus_beck(clip in polygon(), input in input()) {
        laws::check::<CyrusBeck>(&CyrusBeckInput { clip, segment: input.segment });
    }

    #[test]
    fn normals_outside(clip in polygon(), input in input()) {
        laws::check::<OutwardCyrusBeck>(&CyrusBeckInput { clip, segment: input.segment });
    }

    #[test]
    fn nicholl_lee_nicholl(input in input()) { laws::check::<NichollLeeNicholl>(&input); }
}
