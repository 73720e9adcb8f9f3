//! Named outlines.

use clipscope::{
    algo::polygon::{Corner, EarClipping, EarClippingEvent as Event, Triangle},
    geom::SimplePolygon,
    trace::{Method, Recording, laws, silent},
};

use super::{
    Outline,
    outlines::{comb, is_simple, spiral, star},
    polygon, triangulated,
};

/// A name, an outline, and its triangles in the order in which they are cut off.
type Case = (&'static str, &'static [[i64; 2]], &'static [Triangle]);

fn trace(outline: &[[i64; 2]]) -> Recording<EarClipping> {
    Recording::new(polygon(outline))
}

#[test]
fn outlines_and_their_triangles() {
    let cases: [Case; 7] = [
        ("a triangle", &[[0, 0], [4, 0], [0, 4]], &[[0, 1, 2]]),
        (
            "a square: the first corner that is asked",
            &[[0, 0], [4, 0], [4, 4], [0, 4]],
            &[[3, 0, 1], [1, 2, 3]],
        ),
        (
            "convex: every second corner, then what is left",
            &[[0, 0], [4, 0], [6, 2], [4, 4], [0, 4]],
            &[[4, 0, 1], [1, 2, 3], [1, 3, 4]],
        ),
        (
            "an arrowhead: the reflex vertex is in both",
            &[[0, 0], [2, 1], [4, 0], [2, 4]],
            &[[3, 0, 1], [1, 2, 3]],
        ),
        (
            "the picture of the module: V₃ blocks V₀ and V₁",
            &[[0, 0], [6, 0], [6, 6], [3, 2], [0, 6]],
            &[[1, 2, 3], [3, 4, 0], [0, 1, 3]],
        ),
        (
            "a triangle with a straight vertex, which is no tip and blocks the corner across",
            &[[0, 0], [2, 0], [4, 0], [0, 4]],
            &[[3, 0, 1], [1, 2, 3]],
        ),
        (
            "all three sides with straight vertices",
            &[[0, 0], [1, 0], [2, 0], [1, 1], [0, 2], [0, 1]],
            &[[5, 0, 1], [1, 2, 3], [3, 4, 5], [1, 3, 5]],
        ),
    ];
    for (name, outline, expected) in cases {
        assert!(is_simple(outline), "{name}");
        assert_eq!(triangulated(outline), expected, "{name}");
        laws::check::<EarClipping>(&polygon(outline));
    }
}

#[test]
fn combs_spirals_and_stars() {
    let outlines: Vec<(&str, Outline)> = (1..8)
        .flat_map(|n| {
            [
                ("comb", comb(n)),
                ("spiral", spiral(n)),
                ("star", star(n as usize + 2)),
            ]
        })
        .collect();
    for (name, outline) in outlines {
        assert!(is_simple(&outline), "{name}: {outline:?}");
        triangulated(&outline);
        let mut from_another_vertex = outline.clone();
        from_another_vertex.rotate_left(outline.len() / 2);
        triangulated(&from_another_vertex);
        laws::check::<EarClipping>(&polygon(&outline));
    }
}

#[test]
fn the_steps_of_the_picture_in_the_module() {
    use Corner::{Convex, Reflex};
    let trace = trace(&[[0, 0], [6, 0], [6, 6], [3, 2], [0, 6]]);
    let classify = |prev_idx, vertex_idx, next_idx, double_area, corner| Event::Classify {
        vertex_idx,
        prev_idx,
        next_idx,
        double_area,
        corner,
    };
    let expected = [
        classify(4, 0, 1, 36.0, Convex),
        classify(0, 1, 2, 36.0, Convex),
        classify(1, 2, 3, 18.0, Convex),
        classify(2, 3, 4, -24.0, Reflex),
        classify(3, 4, 0, 18.0, Convex),
        Event::Round {
            round_idx: 0,
            n_left: 5,
        },
        Event::Candidate {
            triangle: [4, 0, 1],
        },
        Event::Blocked {
            vertex_idx: 0,
            by_idx: 3,
            double_areas: [18.0, 12.0, 6.0],
        },
        Event::Candidate {
            triangle: [0, 1, 2],
        },
        Event::Blocked {
            vertex_idx: 1,
            by_idx: 3,
            double_areas: [12.0, 18.0, 6.0],
        },
        Event::Candidate {
            triangle: [1, 2, 3],
        },
        Event::Ear { vertex_idx: 2 },
        Event::Cut {
            triangle: [1, 2, 3],
            n_left: 4,
        },
        classify(1, 3, 4, -6.0, Reflex),
        Event::Candidate {
            triangle: [3, 4, 0],
        },
        Event::Ear { vertex_idx: 4 },
        Event::Cut {
            triangle: [3, 4, 0],
            n_left: 3,
        },
        Event::Last {
            triangle: [0, 1, 3],
        },
        Event::Done { n_triangles: 3 },
    ];
    assert_eq!(trace.events(), expected);
    let json = serde_json::to_string(&expected[9]).unwrap();
    assert_eq!(
        json,
        r#"{"event":"blocked","vertex_idx":1,"by_idx":3,"double_areas":[12.0,18.0,6.0]}"#
    );
}

#[test]
fn a_vertex_on_the_diagonal_blocks_the_corner() {
    // V₃ lies on the line from V₀ to V₂: cutting V₁ off would leave an outline that touches itself.
    let outline = [[0, 0], [4, 0], [4, 4], [2, 2], [0, 4]];
    assert!(is_simple(&outline));
    let trace = trace(&outline);
    let blocked = Event::Blocked {
        vertex_idx: 1,
        by_idx: 3,
        double_areas: [8.0, 8.0, 0.0],
    };
    assert!(trace.events().contains(&blocked), "{:?}", trace.events());
    triangulated(&outline);
}

#[test]
fn few_vertices_are_asked_twice() {
    for n in [3, 10, 40] {
        let outline = comb(n);
        let trace = trace(&outline);
        let asked = trace
            .events()
            .iter()
            .filter(|e| matches!(e, Event::Candidate { .. } | Event::Pass { .. }))
            .count();
        assert!(
            asked <= 3 * outline.len() - 6,
            "{asked} vertices asked in a comb of {n} teeth"
        );
    }
}

/// Corners so flat that rounded areas have no sign: only exact ones tell them apart.
#[test]
fn corners_of_one_unit_in_the_last_place() {
    let [low, high] = [0.3_f64.next_down(), 0.3_f64.next_up()];
    let outline = [[0.1, 0.1], [0.3, low], [0.7, 0.7], [0.3, high]];
    let polygon = SimplePolygon::new(&outline).unwrap();
    assert_eq!(
        silent::<EarClipping>(&polygon).triangles(),
        [[3, 0, 1], [1, 2, 3]]
    );
    let dented = [[0.3, high], [0.7, 0.7], [0.1, 0.7], [0.1, 0.1]];
    let polygon = SimplePolygon::new(&dented).unwrap();
    assert_eq!(
        silent::<EarClipping>(&polygon).triangles(),
        [[0, 1, 2], [0, 2, 3]],
        "V₀ is reflex"
    );
}

#[test]
fn ten_thousand_vertices() {
    let outline = star(5_000);
    let trace = trace(&outline);
    assert_eq!(trace.output().triangles().len(), outline.len() - 2);
    assert!(trace.events().len() <= EarClipping::max_events(&polygon(&outline)));
}

/// The polygon names its vertices as they were given; what it cuts off is the same.
#[test]
fn clockwise_outlines_and_repeated_vertices() {
    let arrowhead = [[0.0, 0.0], [2.0, 1.0], [4.0, 0.0], [2.0, 4.0]];
    let [a, b, c, d] = arrowhead;
    let corners = |outline: &[[f64; 2]]| -> Vec<[[f64; 2]; 3]> {
        let polygon = SimplePolygon::new(outline).unwrap();
        let triangles = silent::<EarClipping>(&polygon).triangles().to_vec();
        let given = |i: usize| outline[i];
        triangles.iter().map(|t| t.map(given)).collect()
    };
    let expected = [[d, a, b], [b, c, d]];
    assert_eq!(corners(&arrowhead), expected);
    assert_eq!(corners(&[a, d, c, b]), expected, "clockwise");
    assert_eq!(corners(&[a, a, b, c, c, c, d, a]), expected, "repeated");
    assert_eq!(corners(&[a, a, d, c, c, b, b]), expected, "both");
}
