//! Every degeneracy by name, with the whole answer.

use clipscope::{
    algo::polygon::weiler_atherton::{
        Contact, IntersectionLabel, Relation, WeilerAtherton, WeilerAthertonEvent as Event,
        WeilerAthertonInput,
    },
    geom::Region,
    trace::{Recording, laws},
};

use super::{clip, rings, shapes};

type Outline<'a> = &'a [[i64; 2]];

const SQUARE: Outline = &[[0, 0], [4, 0], [4, 4], [0, 4]];
/// Two arms that stand on a base.
const U: Outline = &[
    [0, 0],
    [6, 0],
    [6, 4],
    [4, 4],
    [4, 2],
    [2, 2],
    [2, 4],
    [0, 4],
];

/// Rings of the answer from their lowest vertex on the left, in order; outer ones counter-clockwise.
type Rings<'a> = &'a [&'a [[f64; 2]]];

struct Case<'a> {
    name: &'a str,
    subject: Outline<'a>,
    holes: &'a [Outline<'a>],
    clip: Outline<'a>,
    relation: Relation,
    rings: Rings<'a>,
}

fn check(case: &Case<'_>) {
    let Case {
        name,
        subject,
        holes,
        clip: outline,
        relation,
        rings: expected,
    } = case;
    let holes: Vec<shapes::Outline> = holes.iter().map(|hole| hole.to_vec()).collect();
    let region = shapes::region(subject, &holes).expect("a region");
    let clipper = shapes::simple(outline).expect("simple");
    let answer = clip(&region, &clipper);
    assert_eq!(answer.relation, *relation, "{name}");
    let expected: Vec<Vec<[f64; 2]>> = expected.iter().map(|ring| ring.to_vec()).collect();
    assert_eq!(rings(&answer), expected, "{name}");
    laws::check::<WeilerAtherton>(&WeilerAthertonInput {
        subject: region.clone(),
        clip: clipper.clone(),
    });
    if holes.is_empty() {
        let swapped = clip(&Region::from(clipper), region.outer());
        assert_eq!(rings(&swapped), expected, "{name}, the other way round");
        let other = match relation {
            Relation::SubjectInside => Relation::ClipInside,
            Relation::ClipInside => Relation::SubjectInside,
            same => *same,
        };
        assert_eq!(swapped.relation, other, "{name}, the other way round");
    }
}

fn simple<'a>(
    name: &'a str,
    [subject, clip]: [Outline<'a>; 2],
    relation: Relation,
    rings: Rings<'a>,
) -> Case<'a> {
    Case {
        name,
        subject,
        holes: &[],
        clip,
        relation,
        rings,
    }
}

#[test]
fn without_a_common_area() {
    use Relation::{Disjoint, Touching};
    let cases: [(&str, Outline, Outline, Relation); 9] = [
        ("far apart", SQUARE, &[[9, 9], [10, 9], [9, 10]], Disjoint),
        (
            "boxes overlap, nothing else",
            &[[0, 0], [4, 0], [0, 4]],
            &[[4, 4], [3, 4], [4, 3]],
            Disjoint,
        ),
        ("between the arms", U, &[[3, 3], [3, 9], [2, 9]], Disjoint),
        (
            "a vertex at a vertex",
            SQUARE,
            &[[4, 4], [5, 4], [5, 5]],
            Touching,
        ),
        (
            "a vertex on an edge",
            SQUARE,
            &[[4, 2], [6, 1], [6, 3]],
            Touching,
        ),
        (
            "an edge in common",
            SQUARE,
            &[[4, 0], [6, 0], [6, 4], [4, 4]],
            Touching,
        ),
        (
            "part of an edge",
            SQUARE,
            &[[4, 1], [6, 0], [6, 9], [4, 3]],
            Touching,
        ),
        (
            "edges that overlap by halves",
            SQUARE,
            &[[4, 2], [6, 0], [6, 9], [4, 6]],
            Touching,
        ),
        (
            "fitting between the arms",
            U,
            &[[2, 2], [4, 2], [4, 4], [2, 4]],
            Touching,
        ),
    ];
    for (name, subject, clip, relation) in cases {
        check(&simple(name, [subject, clip], relation, &[]));
    }
}

#[test]
fn one_inside_the_other() {
    use Relation::{ClipInside, Equal, SubjectInside};
    let cases = [
        simple(
            "clear of the border",
            [SQUARE, &[[1, 1], [3, 1], [1, 3]]],
            ClipInside,
            &[&[[1.0, 1.0], [3.0, 1.0], [1.0, 3.0]]],
        ),
        simple(
            "at a corner",
            [&[[0, 0], [2, 0], [0, 2]], SQUARE],
            SubjectInside,
            &[&[[0.0, 0.0], [2.0, 0.0], [0.0, 2.0]]],
        ),
        simple(
            "a vertex on an edge",
            [&[[2, 0], [3, 2], [1, 2]], SQUARE],
            SubjectInside,
            &[&[[1.0, 2.0], [2.0, 0.0], [3.0, 2.0]]],
        ),
        simple(
            "along an edge",
            [&[[1, 0], [3, 0], [2, 2]], SQUARE],
            SubjectInside,
            &[&[[1.0, 0.0], [3.0, 0.0], [2.0, 2.0]]],
        ),
        simple(
            "all corners on edges",
            [&[[2, 0], [4, 2], [2, 4], [0, 2]], SQUARE],
            SubjectInside,
            &[&[[0.0, 2.0], [2.0, 0.0], [4.0, 2.0], [2.0, 4.0]]],
        ),
        simple(
            "identical",
            [SQUARE, SQUARE],
            Equal,
            &[&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]],
        ),
        simple(
            "identical, from another vertex the other way round",
            [SQUARE, &[[4, 4], [4, 0], [0, 0], [0, 4]]],
            Equal,
            &[&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]],
        ),
        simple(
            "equal, with a vertex more on an edge",
            [SQUARE, &[[0, 0], [2, 0], [4, 0], [4, 4], [0, 4]]],
            Equal,
            &[&[[0.0, 0.0], [2.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]],
        ),
        simple(
            "repeated and collinear vertices",
            [
                &[
                    [0, 0],
                    [0, 0],
                    [1, 0],
                    [2, 0],
                    [2, 0],
                    [0, 2],
                    [0, 2],
                    [0, 0],
                ],
                SQUARE,
            ],
            SubjectInside,
            &[&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [0.0, 2.0]]],
        ),
    ];
    for case in &cases {
        check(case);
    }
}

#[test]
fn several_pieces() {
    use Relation::Crossing;
    let cases = [
        simple(
            "both arms",
            [U, &[[-1, 3], [7, 3], [7, 5], [-1, 5]]],
            Crossing,
            &[
                &[[0.0, 3.0], [2.0, 3.0], [2.0, 4.0], [0.0, 4.0]],
                &[[4.0, 3.0], [6.0, 3.0], [6.0, 4.0], [4.0, 4.0]],
            ],
        ),
        simple(
            "both arms, along the bay's floor",
            [U, &[[-1, 2], [7, 2], [7, 5], [-1, 5]]],
            Crossing,
            &[
                &[[0.0, 2.0], [2.0, 2.0], [2.0, 4.0], [0.0, 4.0]],
                &[[4.0, 2.0], [6.0, 2.0], [6.0, 4.0], [4.0, 4.0]],
            ],
        ),
        simple(
            "the base, along the bay's floor",
            [U, &[[-1, -1], [7, -1], [7, 2], [-1, 2]]],
            Crossing,
            &[&[
                [0.0, 0.0],
                [6.0, 0.0],
                [6.0, 2.0],
                [4.0, 2.0],
                [2.0, 2.0],
                [0.0, 2.0],
            ]],
        ),
        simple(
            "two pieces that touch in a point",
            [
                &[[0, 0], [8, 0], [8, 4], [4, 2], [0, 4]],
                &[[0, 2], [8, 2], [8, 9], [0, 9]],
            ],
            Crossing,
            &[
                &[[0.0, 2.0], [4.0, 2.0], [0.0, 4.0]],
                &[[4.0, 2.0], [8.0, 2.0], [8.0, 4.0]],
            ],
        ),
        simple(
            "two dents that touch: pinched in two",
            [
                &[[0, 0], [8, 0], [8, 4], [4, 2], [0, 4]],
                &[[0, 4], [0, 0], [4, 2], [8, 0], [8, 4]],
            ],
            Crossing,
            &[
                &[[0.0, 0.0], [4.0, 2.0], [0.0, 4.0]],
                &[[4.0, 2.0], [8.0, 0.0], [8.0, 4.0]],
            ],
        ),
        simple(
            "through two vertices",
            [SQUARE, &[[-1, -1], [5, 5], [-1, 5]]],
            Crossing,
            &[&[[0.0, 0.0], [4.0, 4.0], [0.0, 4.0]]],
        ),
        simple(
            "crossings at thirds",
            [
                &[[0, 0], [3, 1], [0, 1]],
                &[[1, -1], [2, -1], [2, 2], [1, 2]],
            ],
            Crossing,
            &[&[[1.0, 1.0 / 3.0], [2.0, 2.0 / 3.0], [2.0, 1.0], [1.0, 1.0]]],
        ),
    ];
    for case in &cases {
        check(case);
    }
}

const BOX: Outline = &[[0, 0], [8, 0], [8, 8], [0, 8]];
const HOLE: Outline = &[[2, 2], [6, 2], [6, 6], [2, 6]];
const DIAMOND: Outline = &[[4, 2], [6, 4], [4, 6], [2, 4]];
const ALL: &[[f64; 2]] = &[[0.0, 0.0], [8.0, 0.0], [8.0, 8.0], [0.0, 8.0]];
const RIM: &[[f64; 2]] = &[[2.0, 2.0], [2.0, 6.0], [6.0, 6.0], [6.0, 2.0]];
const FACETS: &[[f64; 2]] = &[[2.0, 4.0], [4.0, 6.0], [6.0, 4.0], [4.0, 2.0]];

fn holed<'a>(
    name: &'a str,
    holes: &'a [Outline<'a>],
    clip: Outline<'a>,
    relation: Relation,
    rings: Rings<'a>,
) -> Case<'a> {
    Case {
        name,
        subject: BOX,
        holes,
        clip,
        relation,
        rings,
    }
}

#[test]
fn holes() {
    use Relation::{ClipInside, Crossing, Disjoint, SubjectInside, Touching};
    let cases = [
        holed("the box again", &[HOLE], BOX, SubjectInside, &[ALL, RIM]),
        holed(
            "inside the hole",
            &[HOLE],
            &[[3, 3], [5, 3], [4, 5]],
            Disjoint,
            &[],
        ),
        holed("the hole itself", &[HOLE], HOLE, Touching, &[]),
        holed(
            "beside the hole",
            &[HOLE],
            &[[1, 1], [7, 1], [7, 2], [1, 2]],
            ClipInside,
            &[&[
                [1.0, 1.0],
                [7.0, 1.0],
                [7.0, 2.0],
                [6.0, 2.0],
                [2.0, 2.0],
                [1.0, 2.0],
            ]],
        ),
        holed(
            "around the hole",
            &[HOLE],
            &[[1, 1], [7, 1], [7, 7], [1, 7]],
            Crossing,
            &[&[[1.0, 1.0], [7.0, 1.0], [7.0, 7.0], [1.0, 7.0]], RIM],
        ),
        holed(
            "around the hole, touching it once",
            &[DIAMOND],
            &[[2, 1], [7, 1], [7, 7], [2, 7]],
            Crossing,
            &[
                &[[2.0, 1.0], [7.0, 1.0], [7.0, 7.0], [2.0, 7.0], [2.0, 4.0]],
                FACETS,
            ],
        ),
        holed(
            "around the hole, touching it on both sides: two pieces",
            &[DIAMOND],
            &[[2, 1], [6, 1], [6, 7], [2, 7]],
            Crossing,
            &[
                &[[2.0, 1.0], [6.0, 1.0], [6.0, 4.0], [4.0, 2.0], [2.0, 4.0]],
                &[[2.0, 4.0], [4.0, 6.0], [6.0, 4.0], [6.0, 7.0], [2.0, 7.0]],
            ],
        ),
        holed(
            "around the hole, along one of its edges",
            &[HOLE],
            &[[2, 1], [7, 1], [7, 7], [2, 7]],
            Crossing,
            &[&[
                [2.0, 1.0],
                [7.0, 1.0],
                [7.0, 7.0],
                [2.0, 7.0],
                [2.0, 6.0],
                [6.0, 6.0],
                [6.0, 2.0],
                [2.0, 2.0],
            ]],
        ),
        holed(
            "half of the hole",
            &[HOLE],
            &[[4, -1], [9, -1], [9, 9], [4, 9]],
            Crossing,
            &[&[
                [4.0, 0.0],
                [8.0, 0.0],
                [8.0, 8.0],
                [4.0, 8.0],
                [4.0, 6.0],
                [6.0, 6.0],
                [6.0, 2.0],
                [4.0, 2.0],
            ]],
        ),
    ];
    for case in &cases {
        check(case);
    }
}

#[test]
fn each_hole_goes_to_the_piece_that_it_lies_in() {
    let holes: Vec<shapes::Outline> =
        vec![vec![[5, 1], [5, 2], [4, 1]], vec![[1, 1], [2, 1], [1, 2]]];
    let region = shapes::region(&[[0, 0], [9, 0], [9, 3], [0, 3]], &holes).expect("a region");
    let comb = [
        [0, 0],
        [3, 0],
        [3, 4],
        [4, 4],
        [4, 0],
        [9, 0],
        [9, 5],
        [0, 5],
    ];
    let answer = clip(&region, &shapes::simple(&comb).expect("simple"));
    let n_holes: Vec<usize> = answer
        .pieces
        .iter()
        .map(|piece| piece.holes.len())
        .collect();
    assert_eq!(n_holes, [1, 1], "{answer:?}");
    assert_eq!(answer.pieces[0].holes[0][0].to_array(), [4.0, 1.0]);
}

/// Which contacts and labels a run meets.
fn met(subject: Outline, outline: Outline) -> (Vec<Contact>, Vec<IntersectionLabel>) {
    let input = WeilerAthertonInput {
        subject: shapes::simple(subject).expect("simple").into(),
        clip: shapes::simple(outline).expect("simple"),
    };
    let trace = Recording::<WeilerAtherton>::new(input);
    let contacts = trace.events().iter().filter_map(|event| match event {
        Event::Found { contact, .. } => Some(*contact),
        _ => None,
    });
    let labels = trace.events().iter().filter_map(|event| match event {
        Event::Labelled { label, .. } => Some(*label),
        _ => None,
    });
    (contacts.collect(), labels.collect())
}

#[test]
fn a_shared_edge_is_entered_where_it_begins_or_where_it_ends() {
    use Contact::{BothVertices as V, ClipVertex as C, SubjectVertex as S};
    use IntersectionLabel::{Entering, Leaving, Touching};
    // The subject comes from outside, runs along the lower edge to the right, as the clip polygon does, and goes in.
    let same: Outline = &[[0, -2], [1, 0], [3, 0], [3, 2], [-2, 2]];
    let (contacts, labels) = met(same, SQUARE);
    assert_eq!(contacts, [S, S, Contact::Crossing]);
    assert_eq!(labels, [Entering, Touching, Leaving]);
    // Against it, it has entered only at the end.
    let against: Outline = &[
        [3, 0],
        [1, 0],
        [1, 2],
        [5, 2],
        [5, -2],
        [0, -2],
        [-1, -1],
        [3, -1],
    ];
    let (contacts, labels) = met(&against.iter().rev().copied().collect::<Vec<_>>(), SQUARE);
    assert_eq!(contacts.len(), labels.len());
    // Identical polygons touch all along and change no lists.
    assert_eq!(met(SQUARE, SQUARE), (vec![V; 4], vec![Touching; 4]));
    let (contacts, labels) = met(SQUARE, &[[0, 0], [2, 0], [2, -2], [9, -2], [9, 4], [0, 4]]);
    assert_eq!(contacts, [V, C, S, V]);
    assert!(!labels.contains(&IntersectionLabel::Pinching), "{labels:?}");
}

/// Where nothing crosses, that too is found out by comparisons, and a vertex is looked for in the other border.
#[test]
fn what_finds_that_nothing_crosses_is_counted() {
    let triangle: Outline = &[[1, 1], [3, 1], [2, 3]];
    let far: Outline = &[[11, 1], [13, 1], [12, 3]];
    for (name, subject) in [("inside", triangle), ("outside", far)] {
        let simple = |outline| shapes::simple(outline).expect("simple");
        let [subject, clip] = [subject, SQUARE].map(simple);
        let input = WeilerAthertonInput {
            subject: subject.into(),
            clip,
        };
        let run = Recording::<WeilerAtherton>::new(input);
        let is_found = |event: &Event| matches!(event, Event::Found { .. });
        assert!(!run.events().iter().any(is_found), "{name}");
        let counts = run.counts_at(usize::MAX);
        assert!(counts.cmp > 0, "{name}: {counts:?}");
        assert_eq!(counts.div, 0, "{name}");
    }
}
