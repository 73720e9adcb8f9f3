//! Random polygons with integer vertices.

use clipscope::{
    algo::polygon::weiler_atherton::{Relation, WeilerAtherton, WeilerAthertonInput},
    geom::{Location, Point, Region, SimplePolygon, locate},
    trace::laws,
};
use i_overlay::{
    core::{fill_rule::FillRule, overlay_rule::OverlayRule},
    float::single::SingleFloatOverlay,
};
use proptest::prelude::*;

use super::{area_of, clip, oracle, rings, shapes, total_area};

/// All that must hold of one pair. `region` and `clipper` were made from `subject` and `other`, whose rings are
/// given the way round in which they count.
fn check(region: &Region, clipper: &SimplePolygon, subject: &oracle::Grid, other: &oracle::Grid) {
    let input = WeilerAthertonInput {
        subject: region.clone(),
        clip: clipper.clone(),
    };
    laws::check::<WeilerAtherton>(&input);
    let clipped = clip(region, clipper);
    let what = || format!("{subject:?} against {other:?}: {clipped:?}");

    let expected = oracle::common_area(subject, other);
    let found = total_area(&clipped);
    assert!(
        (found - expected).abs() <= 1e-9 * expected.max(1e-3),
        "area {found}, not {expected}, of {}",
        what()
    );

    for piece in &clipped.pieces {
        assert!(
            area_of(&piece.outer) > 0.0,
            "outer rings run counter-clockwise: {}",
            what()
        );
        assert!(
            is_simple(&piece.outer),
            "outer rings are simple: {}",
            what()
        );
        for hole in &piece.holes {
            assert!(area_of(hole) < 0.0, "holes run clockwise: {}", what());
            assert!(is_simple(hole), "holes are simple: {}", what());
            let inside = hole
                .iter()
                .any(|&p| locate(&piece.outer, p) == Location::Inside);
            assert!(inside, "a hole lies in its piece: {}", what());
        }
    }

    // Point by point: in exactly one piece where it is in both, in none elsewhere.
    for i in -1..18 {
        for j in -1..18 {
            let p = Point::new(f64::from(i) + 0.370_241, f64::from(j) + 0.618_033).expect("finite");
            let in_both =
                region.locate(p) == Location::Inside && clipper.locate(p) == Location::Inside;
            let is_in = |ring: &Vec<Point>| locate(ring, p) == Location::Inside;
            let n = clipped
                .pieces
                .iter()
                .filter(|piece| is_in(&piece.outer) && !piece.holes.iter().any(is_in))
                .count();
            assert_eq!(n, usize::from(in_both), "{p:?} in {}", what());
        }
    }

    let (s, c) = (oracle::area(subject), oracle::area(other));
    let is_all = |whole: f64| (expected - whole).abs() < 1e-9;
    let relation = match (expected > 1e-9, is_all(s), is_all(c)) {
        (false, ..) => clipped.relation,
        (_, true, true) => Relation::Equal,
        (_, true, false) => Relation::SubjectInside,
        (_, false, true) => Relation::ClipInside,
        _ => Relation::Crossing,
    };
    assert_eq!(clipped.relation, relation, "{}", what());
    let apart = matches!(clipped.relation, Relation::Disjoint | Relation::Touching);
    assert_eq!(apart, expected < 1e-9, "{}", what());
    if apart {
        let touches = meet(region, clipper);
        assert_eq!(
            clipped.relation == Relation::Touching,
            touches,
            "{}",
            what()
        );
    }
    compare_with_peer(subject, other, expected);
}

/// Neither repeats a point nor meets itself.
fn is_simple(ring: &[Point]) -> bool {
    let outline: Vec<[f64; 2]> = ring.iter().map(|p| p.to_array()).collect();
    SimplePolygon::new(&outline).is_ok_and(|polygon| polygon.vertices().len() == ring.len())
}

/// Do any two edges meet? From the definition.
fn meet(region: &Region, clipper: &SimplePolygon) -> bool {
    use clipscope::geom::orientation;
    let edges = |rings: &clipscope::geom::Rings| {
        (0..rings.points().len())
            .map(|i| rings.edge(i))
            .collect::<Vec<_>>()
    };
    let (subject, other) = (edges(region.rings()), edges(clipper.rings()));
    subject.iter().any(|&[a, b]| {
        other.iter().any(|&[c, d]| {
            let boxes = |f: fn(Point) -> f64| {
                f(a).min(f(b)) <= f(c).max(f(d)) && f(c).min(f(d)) <= f(a).max(f(b))
            };
            let across = |a, b, c, d| {
                orientation(a, b, c) != orientation(a, b, d) || orientation(a, b, c).is_eq()
            };
            boxes(Point::x) && boxes(Point::y) && across(a, b, c, d) && across(c, d, a, b)
        })
    })
}

fn compare_with_peer(subject: &oracle::Grid, other: &oracle::Grid, expected: f64) {
    let floats = |grid: &oracle::Grid| -> Vec<Vec<[f64; 2]>> {
        grid.iter()
            .map(|ring| ring.iter().map(|p| p.map(|x| x as f64)).collect())
            .collect()
    };
    let shapes = floats(subject).overlay(&floats(other), OverlayRule::Intersect, FillRule::NonZero);
    let area: f64 = shapes
        .iter()
        .flatten()
        .map(|ring| {
            let points: Vec<Point> = ring
                .iter()
                .map(|&p| Point::try_from(p).expect("finite"))
                .collect();
            area_of(&points)
        })
        .sum();
    // It rounds coordinates to 32 bits of the extent: this is as near as it comes.
    assert!(
        (area - expected).abs() < 1e-6 * expected.max(1.0),
        "i_overlay finds {area}, the oracle {expected}"
    );
}

fn counter_clockwise(mut outline: shapes::Outline) -> shapes::Outline {
    if oracle::area(&vec![outline.clone()]) < 0.0 {
        outline.reverse();
    }
    outline
}

proptest! {
    #![proptest_config(ProptestConfig { max_global_rejects: 200_000, ..ProptestConfig::default() })]

    #[test]
    fn two_simple_polygons([a, b] in shapes::pair(), turn in 0..16_usize) {
        let [s, c] = [&a, &b].map(|outline| shapes::simple(outline).expect("simple"));
        let grid = |outline: &shapes::Outline| vec![counter_clockwise(outline.clone())];
        let region = Region::from(s.clone());
        check(&region, &c, &grid(&a), &grid(&b));

        let answer = clip(&region, &c);
        let swapped = clip(&c.clone().into(), &s);
        prop_assert_eq!(rings(&answer), rings(&swapped), "subject and clip polygon changed places");

        let turned = |outline: &shapes::Outline| {
            let mut turned = outline.clone();
            turned.rotate_left(turn % outline.len());
            turned.reverse();
            shapes::simple(&turned).expect("simple")
        };
        let other_way = clip(&turned(&a).into(), &turned(&b));
        prop_assert_eq!(rings(&answer), rings(&other_way), "either winding, from any vertex");

        let itself = clip(&region, &s);
        prop_assert_eq!(itself.relation, Relation::Equal);
        prop_assert_eq!(&itself.pieces[0].outer, s.vertices());
    }

    #[test]
    fn a_region_with_holes((outer, holes, other) in shapes::with_holes()) {
        let region = shapes::region(&outer, &holes).expect("holes lie inside");
        let c = shapes::simple(&other).expect("simple");
        let mut subject = vec![counter_clockwise(outer)];
        subject.extend(holes.into_iter().map(|hole| {
            let mut hole = counter_clockwise(hole);
            hole.reverse();
            hole
        }));
        check(&region, &c, &subject, &vec![counter_clockwise(other)]);
    }
}
