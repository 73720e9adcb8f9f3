//! Strips of a window, the area of a ring, and a segment's crossing with an edge.

use clipscope::{
    algo::{
        line::{BruteForce, BruteForceEvent, LiangBarsky, Turn, WindowInput},
        why::{
            Bridge, BridgeFact, BridgeInput, DoubleArea, DoubleAreaFact, DoubleAreaInput, Mean,
            MeanFact, Strips, StripsFact,
        },
    },
    geom::{Axis, Edge, Segment, Window},
    trace::{Recording, silent},
};
use proptest::prelude::*;

use super::{near, shown};

fn whole(most: i32) -> impl Strategy<Value = f64> {
    (-most..=most).prop_map(f64::from)
}

proptest! {
    /// "In" stands at the border with p < 0, "out" across from it; and what both strips hold is what Liang–Barsky leaves.
    #[test]
    fn a_line_comes_in_by_one_border_of_a_strip_and_goes_out_by_the_other(
        ends in prop::array::uniform4(whole(9)),
        [x, y] in prop::array::uniform2(whole(4)),
        [width, height] in prop::array::uniform2(1..6_u8),
    ) {
        let window = Window::new(x, y, x + f64::from(width), y + f64::from(height)).unwrap();
        let segment = Segment::try_from(ends).unwrap();
        let input = WindowInput { window, segment };
        let number = shown::<Strips>(&input);
        let visible = silent::<LiangBarsky>(&input);
        let is_beyond = Edge::ALL.into_iter().any(|edge| number(StripsFact::Beyond { edge }).is_some());
        if is_beyond {
            prop_assert!(visible.is_none());
            return Ok(());
        }
        let delta = [ends[2] - ends[0], ends[3] - ends[1]];
        for edge in Edge::ALL {
            let along = delta[usize::from(edge.axis() == Axis::Y)];
            let p = if edge.is_max() { along } else { -along };
            prop_assert_eq!(number(StripsFact::In { edge }).is_some(), p < 0.0);
            prop_assert_eq!(number(StripsFact::Out { edge }).is_some(), p > 0.0);
            prop_assert_eq!(number(StripsFact::Level { edge }).is_some(), p == 0.0);
        }
        let [from, to] = [StripsFact::From, StripsFact::To].map(|fact| number(fact).expect("shown"));
        let Some(visible) = visible else {
            prop_assert!(from >= to);
            return Ok(());
        };
        let left = [from, to].map(|u| [ends[0] + u * delta[0], ends[1] + u * delta[1]]);
        let [x1, y1, x2, y2] = visible.to_array();
        for (a, b) in left.into_iter().zip([[x1, y1], [x2, y2]]) {
            prop_assert!(near(a[0], b[0]) && near(a[1], b[1]), "{:?} is {:?}", a, b);
        }
    }

    /// Wherever strips begin, they add up to the area; of a ring with an edge there and back, too.
    #[test]
    fn strips_add_up_to_the_area(
        ring in prop::collection::vec(prop::array::uniform2(whole(9)), 3..9),
        begin in prop::array::uniform2(whole(9)),
        spike in prop::array::uniform2(whole(9)),
    ) {
        let area = |ring: &[[f64; 2]]| -> f64 {
            let crossed = (0..ring.len()).map(|i| {
                let ([x1, y1], [x2, y2]) = (ring[i], ring[(i + 1) % ring.len()]);
                x1 * y2 - x2 * y1
            });
            0.5 * crossed.sum::<f64>()
        };
        let mut there_and_back = ring.clone();
        there_and_back.extend([spike, *ring.last().unwrap()]);
        for with in [&ring, &there_and_back] {
            let number = shown::<Bridge>(&BridgeInput { ring: with.clone(), begin });
            for fact in [BridgeFact::Area, BridgeFact::Elsewhere] {
                prop_assert_eq!(number(fact), Some(area(&ring)));
            }
        }
    }
}

/// The ring of the lesson: its bridge is walked down and up again.
#[test]
fn a_bridge_is_found_where_an_edge_runs_back_over_another() {
    let ring = vec![
        [4.0, 2.75],
        [-2.0, 2.0],
        [4.0, 1.25],
        [4.0, -0.5],
        [2.0, -2.0],
        [4.0, -2.5],
    ];
    let input = BridgeInput {
        ring,
        begin: [-4.0, 4.0],
    };
    let twins: Vec<_> = (0..6).map(|edge| input.twin(edge)).collect();
    assert_eq!(twins, [None, None, None, None, None, Some((2, 1.75))]);
    assert_eq!(shown::<Bridge>(&input)(BridgeFact::Area), Some(6.5));
}

proptest! {
    /// The crossing lies on the segment and on the edge's line, it is the clipper's to the last bit, and the distances part the way.
    #[test]
    fn a_crossing_is_a_weighted_mean(
        ends in prop::array::uniform4(whole(9)),
        [x, y] in prop::array::uniform2(whole(4)),
        [width, height] in prop::array::uniform2(1..6_u8),
    ) {
        let window = Window::new(x, y, x + f64::from(width), y + f64::from(height)).unwrap();
        let segment = Segment::try_from(ends).unwrap();
        let input = WindowInput { window, segment };
        let number = shown::<Mean>(&input);
        let distances = |edge: Edge| {
            let axis = usize::from(edge.axis() == Axis::Y);
            [ends[axis], ends[axis + 2]].map(|at| at - window.border(edge))
        };
        let between = Edge::ALL.into_iter().find(|&edge| distances(edge)[0] * distances(edge)[1] < 0.0);
        prop_assert_eq!(Mean::edge(&input), between);
        let Some(edge) = between else {
            prop_assert!(number(MeanFact::Nothing).is_some());
            return Ok(());
        };
        let run = Recording::<BruteForce>::new(input);
        let crossing = run.events().iter().find_map(|event| match *event {
            BruteForceEvent::Intersect { edge: of, at, .. } if of == edge => Some(at.to_array()),
            _ => None,
        });
        let axis = usize::from(edge.axis() == Axis::Y);
        let get = |fact| number(fact).expect("shown");
        prop_assert_eq!([get(MeanFact::First), get(MeanFact::Second)], distances(edge).map(f64::abs));
        prop_assert!(near(get(MeanFact::Given), window.border(edge)));
        prop_assert!(near(get(MeanFact::Mean), ends[1 - axis] + get(MeanFact::Rise)));
        if let Some(crossing) = crossing {
            prop_assert_eq!(get(MeanFact::Mean), crossing[1 - axis]);
        }
        let reversed = WindowInput { segment: segment.reversed(), ..input };
        prop_assert_eq!(shown::<Mean>(&reversed)(MeanFact::Mean), number(MeanFact::Mean));
    }

    /// The four rectangles are all, the triangle is half the difference of the two, and its sign is the algorithm's answer.
    #[test]
    fn products_differ_by_twice_the_triangle(
        ends in prop::array::uniform4(whole(9)),
        [x, y] in prop::array::uniform2(whole(4)),
        [width, height] in prop::array::uniform2(1..6_u8),
    ) {
        let window = Window::new(x, y, x + f64::from(width), y + f64::from(height)).unwrap();
        let segment = Segment::try_from(ends).unwrap();
        let input = DoubleAreaInput::from(WindowInput { window, segment });
        let number = shown::<DoubleArea>(&input);
        let Some(line) = input.line() else {
            prop_assert!(number(DoubleAreaFact::Nothing).is_some());
            return Ok(());
        };
        let get = |fact| number(fact).expect("shown");
        let [first, second] = [DoubleAreaFact::First, DoubleAreaFact::Second].map(get);
        prop_assert_eq!(first + second + 2.0 * get(DoubleAreaFact::Ends), 2.0 * get(DoubleAreaFact::Half));
        // Twice the area of P₁CP₂ by strips, which know nothing of the corner.
        let [x1, y1, x2, y2] = ends;
        let ring = [[x1, y1], line.corner.to_array(), [x2, y2]];
        let strips = BridgeInput { ring: ring.to_vec(), begin: [0.0, 1.0] };
        let area = shown::<Bridge>(&strips)(BridgeFact::Area).expect("shown");
        prop_assert_eq!(get(DoubleAreaFact::Triangle), area);
        prop_assert_eq!(get(DoubleAreaFact::Twice), 2.0 * area);
        let [left, right] = if input.is_first_left() { [first, second] } else { [second, first] };
        prop_assert_eq!(left - right, 2.0 * area);
        let turn = match area {
            area if area > 0.0 => Turn::Left,
            area if area < 0.0 => Turn::Right,
            _ => Turn::Through,
        };
        prop_assert_eq!(line.turn, turn);
    }
}
