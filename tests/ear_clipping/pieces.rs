//! Triangulated, then clipped.

use clipscope::{
    algo::polygon::{
        ClipRegion, EarClipping, Pieces, SutherlandHodgman, SutherlandHodgmanInput,
        TriangulateAndClip, TriangulateAndClipEvent as Event, TriangulateAndClipInput,
    },
    geom::{ConvexPolygon, Point, Polygon, Segment, Window},
    trace::{Recording, laws, silent},
};
use proptest::prelude::*;

use super::{Outline, polygon, properties::any_outline};
use crate::polygon_exactness::oracle::common_area;

fn input(outline: &[[i64; 2]], region: impl Into<ClipRegion>) -> TriangulateAndClipInput {
    TriangulateAndClipInput {
        region: region.into(),
        polygon: polygon(outline),
    }
}

fn window(bounds: [f64; 4]) -> Window {
    let [xmin, ymin, xmax, ymax] = bounds;
    Window::new(xmin, ymin, xmax, ymax).expect("a window")
}

fn rings(pieces: &Pieces) -> Vec<Vec<[f64; 2]>> {
    let ring = |ring: &[Point]| ring.iter().map(|p| p.to_array()).collect();
    pieces.rings().map(ring).collect()
}

fn double_area(ring: &[Point]) -> f64 {
    let next = ring.iter().cycle().skip(1);
    let term = |(p, q): (&Point, &Point)| p.x() * q.y() - q.x() * p.y();
    ring.iter().zip(next).map(term).sum()
}

/// Twice the area that rounding may leave of a touch, for coordinates up to ten: squares of their spacing, with room.
const SLIVER: f64 = 1e-28;

fn area(pieces: &Pieces) -> f64 {
    pieces.rings().map(double_area).sum::<f64>() / 2.0
}

/// A name, a window, and the pieces of the triangle in it, each from its lowest vertex on the left.
type Case = (&'static str, [f64; 4], &'static [&'static [[f64; 2]]]);

/// Two teeth of a comb reach into the window: Sutherland–Hodgman joins them.
const COMB: [[i64; 2]; 8] = [
    [0, 0],
    [5, 0],
    [5, 4],
    [4, 4],
    [4, 2],
    [1, 2],
    [1, 4],
    [0, 4],
];

#[test]
fn no_bridge_is_left() {
    let region = window([-1.0, 3.0, 6.0, 5.0]);
    let pieces = silent::<TriangulateAndClip>(&input(&COMB, region));
    assert_eq!(pieces.len(), 4, "two triangles of each tooth");
    assert_eq!(area(&pieces), 2.0);
    let outline = pieces.outline();
    let bridge = |p: Point| p.y() == 3.0 && p.x() > 1.0 && p.x() < 4.0;
    assert!(
        !outline
            .iter()
            .any(|edge| bridge(edge.p1) || bridge(edge.p2))
    );
    let on_border = |p: Point| p.y() == 3.0;
    let along: Vec<[f64; 4]> = outline
        .iter()
        .filter(|edge| on_border(edge.p1) && on_border(edge.p2))
        .map(|edge| edge.to_array())
        .collect();
    let length: f64 = along.iter().map(|[x1, _, x2, _]| x2 - x1).sum();
    assert_eq!(
        length, 2.0,
        "the feet of both teeth, nothing between: {along:?}"
    );

    let whole = Polygon::new(&COMB.map(|p| p.map(|x| x as f64))).expect("finite");
    let ring = silent::<SutherlandHodgman>(&SutherlandHodgmanInput::new(region.into(), &whole));
    assert!(
        ring.vertices
            .contains(&Point::new(1.0, 3.0).expect("finite")),
        "{ring:?}"
    );
    assert_eq!(ring.vertices.len(), 8, "one ring, with a bridge");
}

#[test]
fn inside_outside_and_touching() {
    let triangle = [[0, 0], [4, 0], [0, 4]];
    let cases: [Case; 5] = [
        (
            "the window around the triangle",
            [-1.0, -1.0, 5.0, 5.0],
            &[&[[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]]],
        ),
        (
            "the window inside it",
            [0.5, 0.5, 1.0, 1.0],
            &[&[[0.5, 0.5], [1.0, 0.5], [1.0, 1.0], [0.5, 1.0]]],
        ),
        ("elsewhere", [5.0, 5.0, 6.0, 6.0], &[]),
        ("touching in a vertex", [4.0, 0.0, 5.0, 1.0], &[]),
        ("touching along an edge", [0.0, -1.0, 4.0, 0.0], &[]),
    ];
    for (name, bounds, expected) in cases {
        let problem = input(&triangle, window(bounds));
        let pieces = silent::<TriangulateAndClip>(&problem);
        let mut found = rings(&pieces);
        for ring in &mut found {
            let lowest = (0..ring.len())
                .min_by(|&i, &j| ring[i][..].partial_cmp(&ring[j][..]).expect("finite"));
            ring.rotate_left(lowest.expect("not empty"));
        }
        assert_eq!(found, expected, "{name}");
        laws::check::<TriangulateAndClip>(&problem);
    }
}

/// The triangle's edge runs through a corner of the clip polygon: nothing is common but a point. Its crossings with
/// the two edges there are rounded, to a sliver that turns clockwise.
#[test]
fn a_touch_may_leave_a_sliver_as_wide_as_rounding() {
    let clip = [[2.0, 0.0], [3.0, 4.0], [0.0, 0.0]];
    let region = ConvexPolygon::new(&clip).expect("convex");
    let pieces = silent::<TriangulateAndClip>(&input(&[[-2, 1], [-1, -2], [2, -1]], region));
    let areas: Vec<f64> = pieces.rings().map(double_area).collect();
    assert!(
        matches!(areas[..], [sliver] if sliver < 0.0 && sliver > -SLIVER),
        "{areas:?}"
    );
}

#[test]
fn the_phases_follow_each_other() {
    let trace = Recording::<TriangulateAndClip>::new(input(&COMB, window([-1.0, 3.0, 6.0, 5.0])));
    let phase = |event: &Event| match event {
        Event::Triangulate(_) => 't',
        Event::Each(_) => 'e',
        Event::Clip(_) => 'c',
    };
    let mut phases: Vec<char> = trace.events().iter().map(phase).collect();
    phases.dedup();
    let each_triangle = "ece".repeat(6).replace("ee", "e");
    let phases: String = phases.into_iter().collect();
    assert_eq!(phases, format!("t{each_triangle}"));
    let json = serde_json::to_string(&trace.events()[0]).expect("plain data");
    assert!(json.starts_with(r#"{"phase":"triangulate","event":"classify","vertex_idx":0,"#));
    let last = trace.events().last().expect("not empty");
    let json = serde_json::to_string(last).expect("plain data");
    assert_eq!(json, r#"{"phase":"each","event":"finish","n_pieces":4}"#);
}

fn convex() -> impl Strategy<Value = Outline> {
    let triangle = [[0..8_i64, 0..8_i64], [0..8, 0..8], [0..8, 0..8]];
    triangle.prop_filter_map("flat", |corners| {
        let outline = corners.to_vec();
        match super::double_area(&outline) {
            0 => None,
            1.. => Some(outline),
            _ => Some(outline.into_iter().rev().collect()),
        }
    })
}

proptest! {
    #[test]
    fn the_area_is_that_of_the_intersection(outline in any_outline(), clip in convex()) {
        let floats: Vec<[f64; 2]> = clip.iter().map(|p| p.map(|x| x as f64)).collect();
        let region = ConvexPolygon::new(&floats).expect("convex");
        let problem = input(&outline, region);
        let pieces = silent::<TriangulateAndClip>(&problem);
        let expected = common_area(&outline, &clip);
        let found = area(&pieces);
        prop_assert!((found - expected).abs() <= 1e-9 * expected.max(1.0), "{found} for {expected}");
        prop_assert!(pieces.rings().all(|ring| double_area(ring) > -SLIVER));
        laws::check::<TriangulateAndClip>(&problem);
    }

    #[test]
    fn in_a_window_that_holds_it_all_nothing_is_cut(outline in any_outline()) {
        let problem = input(&outline, window([-2000.0, -2000.0, 2000.0, 2000.0]));
        let pieces = silent::<TriangulateAndClip>(&problem);
        let whole = silent::<EarClipping>(&problem.polygon);
        let triangles: Vec<_> = whole.triangles().iter().map(|&t| whole.corners(t).to_vec()).collect();
        let found: Vec<_> = pieces.rings().map(<[Point]>::to_vec).collect();
        prop_assert_eq!(found, triangles);
        let n_edges = pieces.outline().len();
        prop_assert_eq!(pieces.merged().len(), 1);
        prop_assert_eq!(n_edges, outline.len(), "the diagonals are gone, the edges are left");
    }

    /// Where a diagonal is cut, both sides get the same bits: nothing of it is left in the outline.
    #[test]
    fn the_outline_runs_along_the_polygon_and_the_window(
        outline in any_outline(),
        xs in [0..6_i64, 1..4_i64],
        ys in [0..6_i64, 1..4_i64],
    ) {
        let [x, y] = [xs, ys].map(|[from, size]| [from as f64 + 0.25, (from + size) as f64 + 0.25]);
        let problem = input(&outline, window([x[0], y[0], x[1], y[1]]));
        let pieces = silent::<TriangulateAndClip>(&problem);
        let merged: f64 = pieces.merged().iter().map(|ring| double_area(ring)).sum();
        prop_assert!((merged / 2.0 - area(&pieces)).abs() < 1e-9);
        for edge in pieces.outline() {
            let [p, q] = [edge.p1, edge.p2].map(Point::to_array);
            let along_window = |axis: usize, borders: [f64; 2]| p[axis] == q[axis] && borders.contains(&p[axis]);
            let along_polygon = problem.polygon.edges().any(|side| {
                [p, q].iter().all(|&end| distance(end, side) < 1e-9)
            });
            prop_assert!(along_window(0, x) || along_window(1, y) || along_polygon, "{edge:?} of {outline:?}");
        }
    }
}

/// From the line of a segment, or from its ends where the point lies beside it.
fn distance([x, y]: [f64; 2], Segment { p1, p2 }: Segment) -> f64 {
    let [dx, dy] = [p2.x() - p1.x(), p2.y() - p1.y()];
    let along = (x - p1.x()) * dx + (y - p1.y()) * dy;
    let t = (along / (dx * dx + dy * dy)).clamp(0.0, 1.0);
    (x - p1.x() - t * dx).hypot(y - p1.y() - t * dy)
}
