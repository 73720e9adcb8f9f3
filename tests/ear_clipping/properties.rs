//! Random simple outlines.

use clipscope::{
    algo::polygon::EarClipping,
    geom::{Point, SimplePolygon},
    trace::{laws, silent},
};
use proptest::prelude::*;

use super::{
    Outline, assert_tiles,
    outlines::{squares, tangled},
    polygon, triangulated,
};

pub fn any_outline() -> impl Strategy<Value = Outline> {
    prop_oneof![tangled(8, 4), tangled(14, 6), tangled(30, 1000), squares()]
}

/// Between two chains from left to right, the upper one a few units in the last place above the lower one.
fn sliver() -> impl Strategy<Value = Vec<[f64; 2]>> {
    let slope = prop_oneof![Just(0.0), Just(1.0), Just(-0.3), -2.0..2.0_f64];
    let gaps = || prop::collection::vec(1..6_u8, 0..8);
    (slope, gaps(), gaps()).prop_map(|(slope, lower, upper)| {
        let chain = |gaps: &[u8], sign: f64| -> Vec<[f64; 2]> {
            let step = 0.7 / (gaps.len() + 1) as f64;
            let on_line = |x: f64| slope * x;
            let off = |(i, &gap): (usize, &u8)| {
                let x = 0.1 + step * (i + 1) as f64;
                [x, on_line(x) + sign * f64::from(gap) * f64::EPSILON]
            };
            gaps.iter().enumerate().map(off).collect()
        };
        let end = |x: f64| [x, slope * x];
        let mut outline = vec![end(0.1)];
        outline.extend(chain(&lower, -1.0));
        outline.push(end(0.8));
        outline.extend(chain(&upper, 1.0).into_iter().rev());
        outline
    })
}

fn sign([a, b, c]: [Point; 3]) -> f64 {
    let [a, b, c] = [a, b, c].map(|p| robust::Coord { x: p.x(), y: p.y() });
    robust::orient2d(a, b, c)
}

proptest! {
    #[test]
    fn n_minus_two_triangles_tile_the_polygon(outline in any_outline()) {
        triangulated(&outline);
    }

    #[test]
    fn wherever_the_outline_starts(outline in any_outline(), start in any::<prop::sample::Index>()) {
        let mut outline = outline;
        let start = start.index(outline.len());
        outline.rotate_left(start);
        triangulated(&outline);
    }

    #[test]
    fn moved_far_away_it_is_cut_the_same_way(outline in any_outline()) {
        let moved: Vec<[i64; 2]> = outline.iter().map(|[x, y]| [x + (1 << 40), y - (1 << 40)]).collect();
        let [here, there] = [&outline, &moved].map(|o| silent::<EarClipping>(&polygon(o)).triangles().to_vec());
        prop_assert_eq!(here, there);
    }

    #[test]
    fn the_laws_of_traced_execution(outline in any_outline()) {
        laws::check::<EarClipping>(&polygon(&outline));
    }

    #[test]
    fn slivers(outline in sliver()) {
        prop_assume!(outline.len() > 2);
        let polygon = SimplePolygon::new(&outline).expect("simple");
        let triangles = silent::<EarClipping>(&polygon).triangles().to_vec();
        let vertices = polygon.vertices();
        for triangle in &triangles {
            let corners = triangle.map(|i| vertices[i]);
            prop_assert!(sign(corners) > 0.0, "{:?} runs counter-clockwise", corners);
        }
        assert_tiles(vertices, &triangles);
    }
}
