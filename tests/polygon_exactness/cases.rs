//! Named cases: the four rules, and every way to touch.

use clipscope::{
    algo::polygon::{
        ClipRegion, Crossing, RingOutcome, Rule, SutherlandHodgman, SutherlandHodgmanEvent,
        Textured,
    },
    geom::{ConvexPolygon, Point},
    trace::{Recording, silent},
};

use super::{arrays, check_promises, clip, input, points, unit};

use RingOutcome::{Cut, Degenerate, Empty, Whole};

type Case<'a> = (&'a str, &'a [[f64; 2]], RingOutcome, &'a [[f64; 2]]);

fn check(region: &ClipRegion, cases: &[Case]) {
    for &(name, outline, outcome, expected) in cases {
        let ring = points(outline);
        let clipped = clip(region, &ring);
        assert_eq!(arrays(&clipped.vertices), expected, "{name}");
        assert_eq!(clipped.outcome, outcome, "{name}");
        check_promises(region, &ring);
    }
}

#[test]
fn the_four_rules_at_one_border() {
    check(
        &unit(),
        &[
            (
                "in, in, in",
                &[[0.0, 0.0], [0.5, 0.0], [0.0, 0.5]],
                Whole,
                &[[0.0, 0.0], [0.5, 0.0], [0.0, 0.5]],
            ),
            (
                "in → out, then out → in on the closing edge",
                &[[0.0, 0.0], [0.0, 0.5], [-2.0, 0.0]],
                Cut,
                &[[0.0, 0.0], [0.0, 0.5], [-1.0, 0.25], [-1.0, 0.0]],
            ),
            (
                "out → in and in → out",
                &[[-2.0, 0.0], [0.0, 0.0], [0.0, 0.5]],
                Cut,
                &[[-1.0, 0.0], [0.0, 0.0], [0.0, 0.5], [-1.0, 0.25]],
            ),
            (
                "out, out, out beyond one border",
                &[[-2.0, 0.0], [-3.0, 0.0], [-2.0, 0.5]],
                Empty,
                &[],
            ),
            (
                "out → out across two borders, past the corner",
                &[[-3.0, 0.0], [0.0, 3.0], [-3.0, 3.0]],
                Empty,
                &[],
            ),
        ],
    );
}

#[test]
fn vertices_and_edges_on_the_border() {
    check(
        &unit(),
        &[
            (
                "a vertex on the border, the polygon inside",
                &[[0.0, 0.0], [-1.0, 0.5], [0.0, 0.5]],
                Whole,
                &[[0.0, 0.0], [-1.0, 0.5], [0.0, 0.5]],
            ),
            (
                "an edge along the border, the polygon inside",
                &[[-1.0, 0.0], [0.0, 0.0], [-1.0, 0.5]],
                Whole,
                &[[-1.0, 0.0], [0.0, 0.0], [-1.0, 0.5]],
            ),
            (
                "leaving from a vertex on the border: it is not put out twice",
                &[[0.0, 0.0], [-1.0, 0.0], [-2.0, 0.5], [0.0, 0.5]],
                Cut,
                &[[0.0, 0.0], [-1.0, 0.0], [-1.0, 0.5], [0.0, 0.5]],
            ),
            (
                "coming in at a vertex on the border: nor is this",
                &[[0.0, 0.5], [-2.0, 0.5], [-1.0, 0.0], [0.0, 0.0]],
                Cut,
                &[[0.0, 0.5], [-1.0, 0.5], [-1.0, 0.0], [0.0, 0.0]],
            ),
            (
                "a vertex in the corner of the window",
                &[[0.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
                Whole,
                &[[0.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
            ),
            (
                "an edge through the corner, the rest inside",
                &[[0.0, 0.0], [2.0, 0.0], [0.0, 2.0]],
                Cut,
                &[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
            ),
            (
                "the window itself",
                &[[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]],
                Whole,
                &[[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]],
            ),
            (
                "the window, clockwise",
                &[[-1.0, -1.0], [-1.0, 1.0], [1.0, 1.0], [1.0, -1.0]],
                Whole,
                &[[-1.0, -1.0], [-1.0, 1.0], [1.0, 1.0], [1.0, -1.0]],
            ),
        ],
    );
}

#[test]
fn touching_from_outside() {
    let around_the_corner = [
        [-2.0, -2.0],
        [1.0, -2.0],
        [1.0, -1.0],
        [-1.0, -1.0],
        [-1.0, 1.0],
        [-2.0, 1.0],
    ];
    let two_feet = [
        [-0.5, 1.0],
        [0.0, 2.0],
        [0.5, 1.0],
        [0.8, 1.0],
        [0.5, 3.0],
        [-0.5, 3.0],
    ];
    check(
        &unit(),
        &[
            (
                "with a vertex",
                &[[-1.0, 0.5], [-2.0, 1.0], [-2.0, 0.0]],
                Degenerate,
                &[[-1.0, 0.5]],
            ),
            (
                "with an edge",
                &[[-1.0, 0.0], [-1.0, 0.5], [-2.0, 0.0]],
                Degenerate,
                &[[-1.0, 0.0], [-1.0, 0.5]],
            ),
            (
                "with an edge that is longer than the window: there and back",
                &[[-1.0, 3.0], [-2.0, 0.0], [-1.0, -3.0]],
                Degenerate,
                &[[-1.0, 1.0], [-1.0, -1.0], [-1.0, -1.0], [-1.0, 1.0]],
            ),
            (
                "the corner with an edge",
                &[[-2.0, 0.0], [0.0, -2.0], [-2.0, -2.0]],
                Degenerate,
                &[[-1.0, -1.0]],
            ),
            (
                "two sides of it",
                &around_the_corner,
                Degenerate,
                &[[1.0, -1.0], [-1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]],
            ),
            (
                "with a vertex and an edge of the same side",
                &two_feet,
                Degenerate,
                &[[-0.5, 1.0], [0.5, 1.0], [0.8, 1.0]],
            ),
        ],
    );
}

#[test]
fn around_repeated_collinear_flat() {
    check(
        &unit(),
        &[
            (
                "the polygon around the window",
                &[[-2.0, -2.0], [2.0, -2.0], [2.0, 2.0], [-2.0, 2.0]],
                Cut,
                &[[1.0, -1.0], [1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0]],
            ),
            (
                "a repeated vertex stays repeated",
                &[[0.0, 0.0], [0.0, 0.0], [0.5, 0.0], [0.0, 0.5]],
                Whole,
                &[[0.0, 0.0], [0.0, 0.0], [0.5, 0.0], [0.0, 0.5]],
            ),
            (
                "a collinear vertex stays",
                &[[0.0, 0.0], [0.25, 0.0], [0.5, 0.0], [0.0, 0.5]],
                Whole,
                &[[0.0, 0.0], [0.25, 0.0], [0.5, 0.0], [0.0, 0.5]],
            ),
            (
                "a point three times, inside",
                &[[0.5, 0.5]; 3],
                Degenerate,
                &[[0.5, 0.5]; 3],
            ),
            ("a point three times, outside", &[[1.5, 0.5]; 3], Empty, &[]),
            (
                "there and back across the border",
                &[[0.0, 0.0], [2.0, 0.0], [1.5, 0.0]],
                Degenerate,
                &[[0.0, 0.0], [1.0, 0.0], [1.0, 0.0]],
            ),
            (
                "a concave one falls apart: a bridge along the border joins its pieces",
                &[
                    [-0.5, -2.0],
                    [0.5, -2.0],
                    [0.5, 0.0],
                    [0.25, 0.0],
                    [0.0, -1.5],
                    [-0.25, 0.0],
                    [-0.5, 0.0],
                ],
                Cut,
                &[
                    [0.5, -1.0],
                    [0.5, 0.0],
                    [0.25, 0.0],
                    [1.0 / 12.0, -1.0],
                    [-1.0 / 12.0, -1.0],
                    [-0.25, 0.0],
                    [-0.5, 0.0],
                    [-0.5, -1.0],
                ],
            ),
            (
                "a bow tie is clipped as it runs",
                &[[-2.0, -0.5], [2.0, 0.5], [2.0, -0.5], [-2.0, 0.5]],
                Cut,
                &[[-1.0, -0.25], [1.0, 0.25], [1.0, -0.25], [-1.0, 0.25]],
            ),
        ],
    );
}

#[test]
fn against_an_oblique_region() {
    let diamond = [[0.0, -2.0], [2.0, 0.0], [0.0, 2.0], [-2.0, 0.0]];
    let region = ConvexPolygon::new(&diamond).expect("convex").into();
    check(
        &region,
        &[
            ("itself", &diamond, Whole, &diamond),
            (
                "around it",
                &[[-3.0, -3.0], [3.0, -3.0], [3.0, 3.0], [-3.0, 3.0]],
                Cut,
                &diamond,
            ),
            (
                "touching along an edge",
                &[[2.0, 0.0], [2.0, 2.0], [0.0, 2.0]],
                Degenerate,
                &[[2.0, 0.0], [0.0, 2.0]],
            ),
            (
                "touching with a vertex",
                &[[1.0, 1.0], [2.0, 1.0], [1.0, 2.0]],
                Degenerate,
                &[[1.0, 1.0]],
            ),
            (
                "a square over a corner",
                &[[1.0, -1.0], [3.0, -1.0], [3.0, 1.0], [1.0, 1.0]],
                Cut,
                &[[1.0, -1.0], [2.0, 0.0], [1.0, 1.0]],
            ),
        ],
    );
}

#[test]
fn fewer_than_three_vertices_are_clipped_all_the_same() {
    check(
        &unit(),
        &[
            ("none", &[], Empty, &[]),
            ("one", &[[0.0, 0.0]], Degenerate, &[[0.0, 0.0]]),
            (
                "two",
                &[[0.0, 0.0], [2.0, 0.0]],
                Degenerate,
                &[[0.0, 0.0], [1.0, 0.0], [1.0, 0.0]],
            ),
        ],
    );
}

#[test]
fn texture_coordinates_are_mixed_by_the_same_t() {
    let corner = |x, y, u, v| Textured {
        at: Point::new(x, y).expect("finite"),
        uv: [u, v],
    };
    let triangle = vec![
        corner(0.0, 0.0, 0.0, 0.0),
        corner(4.0, 0.0, 1.0, 0.0),
        corner(0.0, 4.0, 0.0, 1.0),
    ];
    let ring = silent::<SutherlandHodgman<Textured>>(&input(&unit(), triangle));
    let expected = [
        corner(0.0, 0.0, 0.0, 0.0),
        corner(1.0, 0.0, 0.25, 0.0),
        corner(1.0, 1.0, 0.25, 0.25),
        corner(0.0, 1.0, 0.0, 0.25),
    ];
    assert_eq!(ring.vertices, expected);
}

#[test]
fn t_runs_from_s_to_p_whichever_end_is_inside() {
    let triangle = points(&[[0.0, 0.0], [0.0, 0.5], [-4.0, 0.0]]);
    let diamond = ConvexPolygon::new(&[[0.0, -1.0], [1.0, 0.0], [0.0, 1.0], [-1.0, 0.0]]);
    for region in [unit(), diamond.expect("convex").into()] {
        let trace = Recording::<SutherlandHodgman>::new(input(&region, triangle.clone()));
        let mut rule = Rule::InIn;
        let mut n_crossings = 0;
        let mut ends = [Point::default(); 2];
        for &event in trace.events() {
            match event {
                SutherlandHodgmanEvent::Test(test) => (rule, ends) = (test.rule, test.ends),
                SutherlandHodgmanEvent::Cross(Crossing { at, t }) => {
                    n_crossings += 1;
                    assert!(rule.changes_side());
                    let [[x1, _], [x2, _]] = ends.map(Point::to_array);
                    let x = x1 + t.num / t.den * (x2 - x1);
                    assert!((x - at.x()).abs() < 1e-15, "{x} at {at:?}");
                }
                _ => {}
            }
        }
        assert_eq!(n_crossings, 2, "{region:?}");
    }
}
