//! The move that a verdict names turns the answer of every clipper, and a little less does not.

use clipscope::{
    algo::line::{CyrusBeck, CyrusBeckInput, SegmentTurn, least_move_in, least_move_out},
    geom::{ConvexPolygon, HalfPlane, Point, Segment, Window},
    trace::silent,
};
use proptest::prelude::*;

use super::BY_DISTANCES;

/// A segment moved as a whole along a border's normal.
fn moved(segment: &Segment, plane: &HalfPlane, by: f64) -> Segment {
    let [nx, ny] = plane.normal();
    let length = nx.hypot(ny);
    let [x1, y1, x2, y2] = segment.to_array();
    let (dx, dy) = (by * nx / length, by * ny / length);
    Segment::new(x1 + dx, y1 + dy, x2 + dx, y2 + dy).expect("finite")
}

/// Of a turn a hundredth more, and a hundredth less. What touches has a turn of 0: a little beyond what rounding does.
fn beyond_and_before(by: f64, way: f64) -> [f64; 2] {
    [
        by + way * (0.01 * by.abs() + 1e-9),
        by - way * 0.01 * by.abs(),
    ]
}

/// Holds both moves of a segment to what a clipper says.
fn hold(
    planes: &[HalfPlane],
    corners: &[Point],
    segment: &Segment,
    is_visible: impl Fn(&Segment) -> bool,
) -> Result<(), TestCaseError> {
    if is_visible(segment) {
        let SegmentTurn { border_idx, by } =
            least_move_out(planes, corners, segment).expect("a region is bounded");
        let [beyond, before] = beyond_and_before(by, -1.0);
        prop_assert!(!is_visible(&moved(segment, &planes[border_idx], beyond)));
        if by < -1e-9 {
            prop_assert!(is_visible(&moved(segment, &planes[border_idx], before)));
        }
        // Over no border a shorter move is enough.
        for plane in planes {
            prop_assert!(is_visible(&moved(segment, plane, 0.99 * by)) || by > -1e-9);
        }
        return Ok(());
    }
    for (border_idx, plane) in planes.iter().enumerate() {
        if let Some(by) = least_move_in(planes, corners, segment, border_idx) {
            let [beyond, before] = beyond_and_before(by, by.signum());
            prop_assert!(
                is_visible(&moved(segment, plane, beyond))
                    || is_sliver(planes, corners, segment, plane)
            );
            prop_assert!(!is_visible(&moved(segment, plane, before)));
        } else {
            for step in -100..100 {
                prop_assert!(!is_visible(&moved(segment, plane, 0.2 * f64::from(step))));
            }
        }
    }
    Ok(())
}

/// Does so little of the way lead through the region that a hundredth more is already past it?
fn is_sliver(
    planes: &[HalfPlane],
    corners: &[Point],
    segment: &Segment,
    plane: &HalfPlane,
) -> bool {
    let border_idx = planes.iter().position(|p| p == plane).expect("one of them");
    let by = least_move_in(planes, corners, segment, border_idx)
        .expect("it is asked where there is one");
    let there = moved(segment, plane, by + by.signum() * 1e-9);
    let out = least_move_out(planes, corners, &there);
    out.is_some_and(|turn| turn.by.abs() <= 0.011 * by.abs() + 1e-8)
}

proptest! {
    #[test]
    fn a_segment_turns_where_it_is_said_for_every_clipper(
        ends in prop::array::uniform4(-4.0..4.0_f64),
    ) {
        let window = Window::new(-1.5, -1.0, 1.25, 1.0).expect("a window");
        let region = ConvexPolygon::from(window);
        let planes: Vec<HalfPlane> = region.half_planes().collect();
        let segment = Segment::try_from(ends).expect("finite");
        for (_, clip) in BY_DISTANCES {
            hold(&planes, region.vertices(), &segment, |s| clip(&window, s).is_some())?;
        }
    }

    #[test]
    fn and_against_a_convex_polygon(
        ends in prop::array::uniform4(-4.0..4.0_f64),
    ) {
        let outline = [[0.0, -2.0], [2.5, -0.5], [0.5, 2.0], [-1.5, 1.25], [-2.0, 0.0]];
        let region = ConvexPolygon::new(&outline).expect("convex");
        let planes: Vec<HalfPlane> = region.half_planes().collect();
        let segment = Segment::try_from(ends).expect("finite");
        let is_visible = |&segment: &Segment| {
            let clip = region.clone();
            silent::<CyrusBeck>(&CyrusBeckInput { clip, segment }).is_some()
        };
        hold(&planes, region.vertices(), &segment, is_visible)?;
    }
}

#[test]
fn a_touch_vanishes_at_once_and_a_point_has_no_line_of_its_own() {
    let region = ConvexPolygon::from(Window::new(-1.0, -1.0, 1.0, 1.0).expect("a window"));
    let planes: Vec<HalfPlane> = region.half_planes().collect();
    let touch = Segment::new(-2.0, 0.0, 0.0, 2.0).expect("finite");
    let turn = least_move_out(&planes, region.vertices(), &touch).expect("bounded");
    assert_eq!(turn.by, 0.0);
    let point = Segment::new(0.5, 3.0, 0.5, 3.0).expect("finite");
    let from = |border_idx| least_move_in(&planes, region.vertices(), &point, border_idx);
    // Bottom, right, top, left.
    assert_eq!([0, 1, 2, 3].map(from), [Some(-2.0), None, Some(2.0), None]);
}
