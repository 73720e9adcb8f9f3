//! What each mistake does, and where it first differs.

use clipscope::{
    algo::polygon::{
        EdgeTest, SutherlandHodgman, SutherlandHodgmanEvent, SutherlandHodgmanInput, Textured,
        faulty::{CutsTwice, DropsOnBorder, EndFirst, Faulty, KeepsUv, LeavesOpen, WalksClockwise},
    },
    geom::Point,
    trace::{Method, Recording, silent},
};

use super::{arrays, input, points, unit};

type Event = SutherlandHodgmanEvent<Point>;

/// Its ring, and the first event that is not the right one's.
fn differs<L>(outline: &[[f64; 2]]) -> (Vec<[f64; 2]>, Option<Event>)
where
    Faulty<L>: Method<
            Input = SutherlandHodgmanInput,
            Event = Event,
            Output = clipscope::algo::polygon::ClippedRing<Point>,
        >,
{
    let input = input(&unit(), points(outline));
    let right = Recording::<SutherlandHodgman>::new(input.clone());
    let wrong = Recording::<Faulty<L>>::new(input);
    let pairs = wrong.events().iter().zip(right.events());
    let first = pairs.clone().position(|(w, r)| w != r);
    let event = first.map(|i| wrong.events()[i]);
    (arrays(&wrong.output().vertices), event)
}

const ACROSS: [[f64; 2]; 3] = [[0.0, 0.0], [0.0, 0.5], [-2.0, 0.0]];

#[test]
fn a_vertex_on_the_border_is_dropped() {
    let (ring, first) = differs::<DropsOnBorder>(&[[0.0, 0.0], [-1.0, 0.5], [0.0, 0.5]]);
    assert_eq!(ring, [[0.0, 0.0], [0.0, 0.5]]);
    assert!(matches!(
        first,
        Some(Event::Test(EdgeTest {
            distances: [1.0, 0.0],
            ..
        }))
    ));
}

#[test]
fn the_closing_edge_is_missing() {
    let (ring, first) = differs::<LeavesOpen>(&ACROSS);
    assert_eq!(ring, [[0.0, 0.0], [0.0, 0.5], [-1.0, 0.25]]);
    assert!(matches!(
        first,
        Some(Event::Pass {
            edge_idx: 0,
            n_vertices: 3
        })
    ));
}

#[test]
fn clip_edges_walked_clockwise_leave_nothing() {
    let (ring, first) = differs::<WalksClockwise>(&[[0.0, 0.0], [0.5, 0.0], [0.0, 0.5]]);
    assert!(ring.is_empty());
    assert!(matches!(
        first,
        Some(Event::Edge {
            edge_idx: 3,
            normal: [0.0, 1.0],
            ..
        })
    ));
}

#[test]
fn a_crossing_is_put_out_twice() {
    let (ring, first) = differs::<CutsTwice>(&ACROSS);
    assert_eq!(
        ring,
        [
            [0.0, 0.0],
            [0.0, 0.5],
            [-1.0, 0.25],
            [-1.0, 0.25],
            [-1.0, 0.0],
            [-1.0, 0.0]
        ]
    );
    assert!(matches!(first, Some(Event::Output { at }) if at.x() == -1.0));
}

#[test]
fn the_end_before_the_crossing() {
    let (ring, first) = differs::<EndFirst>(&[[-2.0, 0.0], [0.0, 0.0], [0.0, 0.5]]);
    assert_eq!(ring, [[0.0, 0.0], [-1.0, 0.0], [0.0, 0.5], [-1.0, 0.25]]);
    assert!(matches!(first, Some(Event::Output { at }) if at.x() == 0.0));
}

#[test]
fn a_texture_that_moves_with_the_vertex() {
    let at = points(&ACROSS);
    let uv = [[0.0, 0.0], [0.0, 1.0], [1.0, 0.0]];
    let right = (0..3)
        .map(|i| Textured {
            at: at[i],
            uv: uv[i],
        })
        .collect();
    let wrong = (0..3)
        .map(|i| KeepsUv {
            at: at[i],
            uv: uv[i],
        })
        .collect();
    let right = silent::<SutherlandHodgman<Textured>>(&input(&unit(), right));
    let wrong = silent::<SutherlandHodgman<KeepsUv>>(&input(&unit(), wrong));
    assert_eq!(right.vertices[2].uv, [0.5, 0.5]);
    assert_eq!(wrong.vertices[2].uv, [1.0, 0.0]);
    for (r, w) in right.vertices.iter().zip(&wrong.vertices) {
        assert_eq!(r.at, w.at, "the outline is the same");
    }
}
