//! What is promised for any finite numbers.

use clipscope::{
    algo::polygon::weiler_atherton::{
        WeilerAtherton, WeilerAthertonEvent as Event, WeilerAthertonInput, WeilerAthertonOutput,
    },
    geom::{Point, Region, SimplePolygon},
    trace::{Recording, laws, silent},
};
use proptest::prelude::*;

use super::{clip, rings, total_area};

/// Corners around a centre at growing angles, somewhere near the origin.
fn star(n: std::ops::Range<usize>) -> impl Strategy<Value = Vec<[f64; 2]>> {
    let radii = prop::collection::vec(0.1..1.0_f64, n);
    (radii, [-0.5..0.5_f64, -0.5..0.5_f64], 0.0..1.0_f64).prop_map(|(radii, [cx, cy], phase)| {
        let corner = |(i, radius): (usize, &f64)| {
            let angle = std::f64::consts::TAU * (i as f64 + phase) / radii.len() as f64;
            [
                cx + radius * libm::cos(angle),
                cy + radius * libm::sin(angle),
            ]
        };
        radii.iter().enumerate().map(corner).collect()
    })
}

fn simple(outline: &[[f64; 2]]) -> SimplePolygon {
    SimplePolygon::new(outline).expect("simple")
}

fn scaled(outline: &[[f64; 2]], by: f64) -> SimplePolygon {
    simple(
        &outline
            .iter()
            .map(|p| p.map(|x| x * by))
            .collect::<Vec<_>>(),
    )
}

/// Intersections of one of the subject's edges, by its ends.
fn on_edge(subject: &SimplePolygon, clip: &SimplePolygon, ends: [Point; 2]) -> Vec<[u64; 2]> {
    let edge_idx = (0..subject.vertices().len()).find(|&i| {
        let edge = subject.edge(i);
        [edge.p1, edge.p2] == ends || [edge.p2, edge.p1] == ends
    });
    let edge_idx = edge_idx.expect("an edge of the subject") as u32;
    let input = WeilerAthertonInput {
        subject: subject.clone().into(),
        clip: clip.clone(),
    };
    let trace = Recording::<WeilerAtherton>::new(input);
    let mut points: Vec<[u64; 2]> = trace
        .events()
        .iter()
        .filter_map(|event| match event {
            Event::Found {
                edges: [edge, _],
                at,
                ..
            } if *edge == edge_idx => Some(at.to_array().map(f64::to_bits)),
            _ => None,
        })
        .collect();
    points.sort_unstable();
    points
}

proptest! {
    #[test]
    fn neither_roles_nor_windings_change_a_bit(a in star(3..40), b in star(3..40), turn in 0..40_usize) {
        let [s, c] = [&a, &b].map(|outline| simple(outline));
        let answer = clip(&s.clone().into(), &c);
        prop_assert_eq!(rings(&answer), rings(&clip(&c.into(), &s)));
        let turned = |outline: &Vec<[f64; 2]>| {
            let mut turned = outline.clone();
            turned.rotate_left(turn % outline.len());
            turned.reverse();
            simple(&turned)
        };
        prop_assert_eq!(rings(&answer), rings(&clip(&turned(&a).into(), &turned(&b))));
        laws::check::<WeilerAtherton>(&WeilerAthertonInput { subject: simple(&a).into(), clip: simple(&b) });
    }

    #[test]
    fn two_polygons_that_share_an_edge_still_share_it(
        [y0, y1, y2, y3] in [0.1..1.0_f64, 0.1..1.0_f64, 0.1..1.0_f64, 0.1..1.0_f64],
        clip in star(3..40),
    ) {
        // A quadrilateral and its diagonal.
        let [p, q, r, s] = [[-1.0, y0], [-y1, -1.0], [1.0, -y2], [y3, 1.0]];
        let (first, second) = (simple(&[p, q, r]), simple(&[r, s, p]));
        let diagonal = [p, r].map(|p| Point::try_from(p).expect("finite"));
        let clip = simple(&clip);
        let [there, back] = [&first, &second].map(|subject| on_edge(subject, &clip, diagonal));
        let vertices = diagonal.map(|p| p.to_array().map(f64::to_bits));
        let within = |points: Vec<[u64; 2]>| -> Vec<_> { points.into_iter().filter(|p| !vertices.contains(p)).collect() };
        prop_assert_eq!(within(there), within(back));
    }

    #[test]
    fn any_size_will_do(a in star(3..20), b in star(3..20), exponent in -990..=1015_i32) {
        let scale = 2f64.powi(exponent);
        let expected = clip(&simple(&a).into(), &simple(&b));
        let found = clip(&scaled(&a, scale).into(), &scaled(&b, scale));
        prop_assert_eq!(found.relation, expected.relation);
        let (found, expected) = (rings(&found), rings(&expected));
        prop_assert_eq!(found.len(), expected.len());
        for (ring, expected) in found.iter().zip(&expected) {
            prop_assert_eq!(ring.len(), expected.len());
            for (p, q) in ring.iter().flatten().zip(expected.iter().flatten()) {
                prop_assert!((p / scale - q).abs() < 1e-9, "{p:e} is not {q} at scale 2^{exponent}");
            }
        }
    }

    #[test]
    fn crossings_stay_within_both_edges(a in star(3..40), b in star(3..40)) {
        let input = WeilerAthertonInput { subject: simple(&a).into(), clip: simple(&b) };
        let trace = Recording::<WeilerAtherton>::new(input.clone());
        for event in trace.events() {
            let Event::Found { edges: [s, c], at, .. } = event else { continue };
            let edges = [input.subject.outer().edge(*s as usize), input.clip.edge(*c as usize)];
            for edge in edges {
                for axis in [Point::x, Point::y] {
                    let [low, high] = [axis(edge.p1).min(axis(edge.p2)), axis(edge.p1).max(axis(edge.p2))];
                    prop_assert!((low..=high).contains(&axis(*at)), "{at:?} beyond {edge:?}");
                }
            }
        }
    }

    #[test]
    fn whatever_the_numbers_there_is_an_answer(
        a in prop::array::uniform3(prop::array::uniform2(any_finite())),
        b in prop::array::uniform3(prop::array::uniform2(any_finite())),
    ) {
        if let (Ok(s), Ok(c)) = (SimplePolygon::new(&a), SimplePolygon::new(&b)) {
            let answer: WeilerAthertonOutput = silent::<WeilerAtherton>(&WeilerAthertonInput { subject: s.into(), clip: c });
            prop_assert!(answer.pieces.len() <= 1, "two triangles have one piece in common: {answer:?}");
        }
    }

    #[test]
    fn the_area_is_that_of_inclusion_and_exclusion(a in star(3..40), b in star(3..40)) {
        // What a star has in common with a window and with the rest of a larger one is all of it.
        let s = simple(&a);
        let [left, right] = [[-3.0, 0.1], [0.1, 3.0]].map(|[xmin, xmax]| {
            SimplePolygon::from(clipscope::geom::Window::new(xmin, -3.0, xmax, 3.0).expect("a window"))
        });
        let common = clip(&s.into(), &simple(&b));
        let whole = total_area(&common);
        let parts: f64 = common
            .pieces
            .iter()
            .filter_map(|piece| {
                let outline: Vec<[f64; 2]> = piece.outer.iter().map(|p| p.to_array()).collect();
                // A piece that is a sliver may have been rounded into one that meets itself.
                SimplePolygon::new(&outline).ok().map(|piece| {
                    let region = Region::from(piece);
                    total_area(&clip(&region, &left)) + total_area(&clip(&region, &right))
                })
            })
            .sum();
        prop_assert!((whole - parts).abs() < 1e-12, "{whole} in parts is {parts}");
    }
}

/// Of any magnitude, with zeros and equal numbers among them.
fn any_finite() -> impl Strategy<Value = f64> {
    prop_oneof![
        prop::num::f64::NORMAL | prop::num::f64::SUBNORMAL | prop::num::f64::ZERO,
        (-3..=3_i32).prop_map(f64::from),
        Just(f64::MAX),
        Just(f64::MIN_POSITIVE),
    ]
}

/// Found by the fuzzer: whether a ring of next to no area has one must not depend on the corner it starts from.
#[test]
fn a_sliver_is_the_same_from_every_corner() {
    let subject = simple(&[
        [5.142913279904117e25, 1.2002863958624906e16],
        [1.0843961455707782e16, 1.5845632480485861e29],
        [1.427312619867e-312, 1.0773255447117824e16],
    ]);
    let other = simple(&[
        [5.7627558418819304e-213, 1.0408838621796937e-255],
        [5.2609718213798e25, 5.142912288508157e25],
        [0.0, 0.0],
        [1.20604675213968e-309, 5.0511374e-317],
    ]);
    let there = rings(&clip(&subject.clone().into(), &other));
    let back = rings(&clip(&other.into(), &subject));
    assert_eq!(there, back);
}
