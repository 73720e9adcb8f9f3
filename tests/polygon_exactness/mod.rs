//! What `clipscope::algo::polygon` promises of Sutherland–Hodgman, held to it.
//!
//! - `cases`: named cases: the four rules, and every way to touch.
//! - `faulty`: what each mistake does, and where it first differs.
//! - `floats`: what is promised for any finite numbers.
//! - `grid`: small integers, on which coincidences are common, against exact areas.
//! - `laws`: the laws of traced execution, one line an algorithm.
//! - `logs`: event logs of worked examples, as text.
//! - `shared_edges`: what two polygons share, they still share.

mod cases;
mod faulty;
mod floats;
mod grid;
mod laws;
mod logs;
pub mod oracle;
mod shared_edges;

use std::fmt::Debug;

use clipscope::{
    algo::polygon::{
        ClipRegion, ClippedRing, Clipper, Pipeline, RingOutcome, SutherlandHodgman,
        SutherlandHodgmanInput, Vertex,
    },
    geom::{HalfPlane, Point, Window},
    trace::silent,
};

fn points(outline: &[[f64; 2]]) -> Vec<Point> {
    let finite = |&p: &[f64; 2]| Point::try_from(p).expect("finite");
    outline.iter().map(finite).collect()
}

fn arrays(ring: &[Point]) -> Vec<[f64; 2]> {
    ring.iter().map(|p| p.to_array()).collect()
}

/// Equal where every bit is, the sign of a zero included.
fn bits(ring: &[Point]) -> Vec<[u64; 2]> {
    let of = |p: &Point| p.to_array().map(f64::to_bits);
    ring.iter().map(of).collect()
}

fn input<V>(region: &ClipRegion, vertices: Vec<V>) -> SutherlandHodgmanInput<V> {
    let region = region.clone();
    SutherlandHodgmanInput { region, vertices }
}

fn clip(region: &ClipRegion, vertices: &[Point]) -> ClippedRing<Point> {
    silent::<SutherlandHodgman>(&input(region, vertices.to_vec()))
}

fn unit() -> ClipRegion {
    Window::new(-1.0, -1.0, 1.0, 1.0).expect("a window").into()
}

/// Everything promised for any region and any ring.
fn check_promises(region: &ClipRegion, ring: &[Point]) {
    let clipped = clip(region, ring);
    let what = format!("{ring:?} against {region:?} leaves {clipped:?}");
    let kept = &clipped.vertices;
    for &p in kept {
        for plane in region.half_planes() {
            assert!(is_inside(p, plane), "{what}: {p:?} is inside");
        }
    }
    let again = clip(region, kept);
    assert_eq!(
        bits(&again.vertices),
        bits(kept),
        "{what}: again, nothing changes"
    );
    let pipeline = silent::<Pipeline>(&input(region, ring.to_vec()));
    assert_eq!(
        bits(&pipeline.vertices),
        bits(kept),
        "{what}: as a pipeline"
    );
    assert_eq!(pipeline.outcome, clipped.outcome, "{what}: as a pipeline");
    check_clipper(region, ring, &clipped, bits);
    check_walks(region, ring, kept, &what);
    if ring.iter().all(|&p| {
        region
            .half_planes()
            .iter()
            .all(|&plane| is_inside(p, plane))
    }) {
        assert_eq!(bits(kept), bits(ring), "{what}: it was inside");
    }
    match clipped.outcome {
        RingOutcome::Empty => assert!(kept.is_empty(), "{what}"),
        RingOutcome::Whole => assert_eq!(kept, ring, "{what}"),
        RingOutcome::Cut => assert!(kept.len() >= 3 && kept != ring, "{what}"),
        RingOutcome::Degenerate => assert!(!kept.is_empty(), "{what}"),
    }
    assert_eq!(
        clipped.polygon().is_some(),
        matches!(clipped.outcome, RingOutcome::Whole | RingOutcome::Cut)
    );
}

/// The clipper leaves what is expected, by its bits; twice with one, so that its lists are used again.
fn check_clipper<V: Vertex + Debug, B: PartialEq + Debug>(
    region: &ClipRegion,
    ring: &[V],
    expected: &ClippedRing<V>,
    bits: fn(&[V]) -> Vec<B>,
) {
    let what = format!("{ring:?} against {region:?}, by the clipper");
    let mut clipper = Clipper::new(region);
    for _ in 0..2 {
        let clipped = clipper.clip(ring);
        assert_eq!(bits(clipped.vertices()), bits(&expected.vertices), "{what}");
        assert_eq!(clipped.has_area(), expected.polygon().is_some(), "{what}");
    }
}

/// Begun at another vertex, or walked the other way, the polygon leaves the same ring, begun at another
/// vertex or walked the other way.
fn check_walks(region: &ClipRegion, ring: &[Point], kept: &[Point], what: &str) {
    let mut other = ring.to_vec();
    for _ in 0..ring.len().min(4) {
        other.rotate_left(1);
        let rotated = clip(region, &other).vertices;
        assert!(
            is_rotation(&rotated, kept),
            "{what}, but from {:?} it leaves {rotated:?}",
            other[0]
        );
    }
    other.reverse();
    let mut reversed = clip(region, &other).vertices;
    reversed.reverse();
    assert!(
        is_rotation(&reversed, kept),
        "{what}, but backwards {reversed:?}, backwards"
    );
}

fn is_rotation(ring: &[Point], of: &[Point]) -> bool {
    let (a, b) = (bits(ring), bits(of));
    a.len() == b.len()
        && (a.is_empty()
            || (0..a.len()).any(|i| a[i..] == b[..a.len() - i] && a[..i] == b[a.len() - i..]))
}

/// n·(p − E) ≥ 0, with n brought near length 1 where products could overflow or vanish, and everything else
/// divided by 8 where they still do.
fn is_inside(p: Point, plane: HalfPlane) -> bool {
    let (mut n, e) = (plane.normal(), plane.origin().to_array());
    let length = |n: [f64; 2]| n[0].abs().max(n[1].abs());
    if !(2f64.powi(-100)..=2f64.powi(100)).contains(&length(n)) {
        while length(n) > 1.0 {
            n = n.map(|x| x * 0.5);
        }
        while length(n) < 0.5 {
            n = n.map(|x| x * 2.0);
        }
    }
    let sum = |scale: f64| {
        let product = |i: usize| n[i] * (p.to_array()[i] * scale - e[i] * scale);
        match n {
            [_, 0.0] => product(0),
            [0.0, _] => product(1),
            _ => product(0) + product(1),
        }
    };
    let d = sum(1.0);
    if d.is_finite() {
        d >= 0.0
    } else {
        sum(0.125) >= 0.0
    }
}

/// Twice the area, counter-clockwise positive.
fn twice_area<V: Vertex>(ring: &[V]) -> f64 {
    let n = ring.len();
    let cross = |i: usize| {
        let [[x1, y1], [x2, y2]] = [ring[i], ring[(i + 1) % n]].map(|v| v.at().to_array());
        x1 * y2 - x2 * y1
    };
    (0..n).map(cross).sum()
}
