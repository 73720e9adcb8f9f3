//! What two polygons share, they still share: the vertices that clipping leaves on a common edge are the same in
//! both, bit for bit.

use clipscope::{
    algo::polygon::{ClipRegion, Share, SutherlandHodgman, Vertex},
    geom::{ConvexPolygon, Point, Window},
    trace::{Real, silent},
};
use proptest::prelude::*;

use super::input;

/// A vertex that knows which edges of its polygon it lies on.
#[derive(Clone, Copy, PartialEq, Debug)]
struct Named {
    at: Point,
    /// One bit an edge.
    edges: u8,
}

impl Vertex for Named {
    fn at(&self) -> Point {
        self.at
    }

    fn crossing<R: Real>(&self, outside: &Self, at: Point, _: &Share<R>) -> Self {
        let edges = self.edges & outside.edges;
        Self { at, edges }
    }
}

/// What is left on the first edge of a triangle, in no order.
fn on_first_edge(region: &ClipRegion, triangle: [Point; 3]) -> Vec<[u64; 2]> {
    let [a, b, c] = triangle;
    let vertices = vec![
        Named {
            at: a,
            edges: 0b101,
        },
        Named {
            at: b,
            edges: 0b011,
        },
        Named {
            at: c,
            edges: 0b110,
        },
    ];
    let ring = silent::<SutherlandHodgman<Named>>(&input(region, vertices));
    let shared = ring.vertices.iter().filter(|v| v.edges & 1 == 1);
    let mut shared: Vec<[u64; 2]> = shared.map(|v| v.at.to_array().map(f64::to_bits)).collect();
    shared.sort_unstable();
    shared.dedup();
    shared
}

fn point() -> impl Strategy<Value = Point> {
    let coordinate = || prop_oneof![-3.0..3.0_f64, (-3..=3_i32).prop_map(f64::from)];
    [coordinate(), coordinate()].prop_map(|p| Point::try_from(p).expect("finite"))
}

fn region() -> impl Strategy<Value = ClipRegion> {
    let window = (-2.0..0.0_f64, 0.1..2.0_f64, -2.0..0.0_f64, 0.1..2.0_f64)
        .prop_map(|(x1, x2, y1, y2)| Window::new(x1, y1, x2, y2).expect("ordered").into());
    let triangle = prop::array::uniform3(point()).prop_filter_map("a triangle", |corners| {
        ConvexPolygon::new(&corners.map(Point::to_array))
            .ok()
            .map(ClipRegion::from)
    });
    prop_oneof![window, triangle]
}

proptest! {
    #[test]
    fn two_triangles_on_one_edge(region in region(), a in point(), b in point(), c in point(), d in point()) {
        let [one, other] = [[a, b, c], [b, a, d]].map(|triangle| on_first_edge(&region, triangle));
        assert_eq!(one, other, "what is left of {a:?} to {b:?} against {region:?}");
    }
}
