//! Simple polygons: outlines that never meet themselves.

use std::cmp::Ordering;

use super::{
    ConvexPolygon, GeomError, Location, Point, Polygon, Rings, Segment, Window, orientation,
    sweep::first_meeting, winding,
};

/// A polygon whose edges meet in shared vertices only, with an area. Vertices run counter-clockwise and no two
/// are the same; three in a row may be collinear. [`SimplePolygon::given_vertex`] leads back to the caller's numbering.
#[derive(Clone, PartialEq, Debug)]
pub struct SimplePolygon {
    rings: Rings,
    given_vertices: Vec<u32>,
    given_edges: Vec<u32>,
    n_given: usize,
}

impl SimplePolygon {
    /// # Errors
    /// What [`Polygon::new`] refuses; and see [`SimplePolygon::try_from`].
    pub fn new(outline: &[[f64; 2]]) -> Result<Self, GeomError> {
        Self::try_from(&Polygon::new(outline)?)
    }

    /// Counter-clockwise: a clockwise outline is stored reversed, from the same vertex on.
    #[must_use]
    pub fn vertices(&self) -> &[Point] {
        self.rings.points()
    }

    /// From vertex `edge_idx` to the next; the last edge closes the ring.
    #[must_use]
    pub fn edge(&self, edge_idx: usize) -> Segment {
        let [p1, p2] = self.rings.edge(edge_idx);
        Segment { p1, p2 }
    }

    /// Every edge, first to last.
    #[must_use]
    pub fn edges(&self) -> impl ExactSizeIterator<Item = Segment> + '_ {
        (0..self.vertices().len()).map(|i| self.edge(i))
    }

    /// The number of a vertex in the outline that was given: of repeated ones the first.
    #[must_use]
    pub fn given_vertex(&self, vertex_idx: usize) -> usize {
        self.given_vertices[vertex_idx] as usize
    }

    /// The number of an edge in the outline that was given, which may have run the other way.
    #[must_use]
    pub fn given_edge(&self, edge_idx: usize) -> usize {
        self.given_edges[edge_idx] as usize
    }

    /// How many vertices were given, repeated ones included.
    #[must_use]
    pub const fn n_given(&self) -> usize {
        self.n_given
    }

    /// Exact.
    #[must_use]
    pub fn locate(&self, p: Point) -> Location {
        self.rings.locate(p)
    }

    /// Its one ring, with neighbours.
    #[must_use]
    pub const fn rings(&self) -> &Rings {
        &self.rings
    }
}

impl TryFrom<&Polygon> for SimplePolygon {
    type Error = GeomError;

    /// A vertex that repeats the one before it is dropped.
    ///
    /// # Errors
    /// `Degenerate` where all vertices lie on one line; `EdgesMeet` where the outline crosses, touches or runs back over itself.
    fn try_from(polygon: &Polygon) -> Result<Self, GeomError> {
        let given = polygon.vertices();
        let n = given.len();
        let starts_anew = |i: usize| i == 0 || given[i] != given[i - 1];
        let mut kept: Vec<u32> = (0..n as u32).filter(|&i| starts_anew(i as usize)).collect();
        while kept.len() > 1 && kept.last().is_some_and(|&i| given[i as usize] == given[0]) {
            kept.pop();
        }
        let at = |k: usize| given[kept[k % kept.len()] as usize];
        if (0..kept.len()).all(|k| orientation(at(k), at(k + 1), at(k + 2)) == Ordering::Equal) {
            return Err(GeomError::Degenerate { vertex_idx: 0 });
        }
        // Of repeated vertices the last one starts the edge: the one before the next that was kept.
        let end_of = |k: usize| match kept.get(k + 1) {
            Some(&next) => next - 1,
            None => kept[k],
        };
        let mut given_edges: Vec<u32> = (0..kept.len()).map(end_of).collect();
        let rings = Rings::one((0..kept.len()).map(at));
        if let Some([i, j]) = first_meeting(&rings) {
            let [i, j] = [i, j].map(|k| given_edges[k] as usize);
            return Err(GeomError::EdgesMeet {
                edges: [i.min(j), i.max(j)],
            });
        }
        let mut points = rings.points().to_vec();
        if winding(&points) != Ordering::Greater {
            points[1..].reverse();
            kept[1..].reverse();
            given_edges.reverse();
        }
        Ok(Self {
            rings: Rings::one(points),
            given_vertices: kept,
            given_edges,
            n_given: n,
        })
    }
}

impl From<Rings> for SimplePolygon {
    /// One ring that is known to be simple, counter-clockwise and without repeated vertices.
    fn from(rings: Rings) -> Self {
        let numbers: Vec<u32> = (0..rings.points().len() as u32).collect();
        Self {
            n_given: numbers.len(),
            rings,
            given_vertices: numbers.clone(),
            given_edges: numbers,
        }
    }
}

impl From<Window> for SimplePolygon {
    fn from(window: Window) -> Self {
        Rings::one(window.corners()).into()
    }
}

impl From<&ConvexPolygon> for SimplePolygon {
    fn from(polygon: &ConvexPolygon) -> Self {
        Rings::one(polygon.vertices().iter().copied()).into()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SQUARE: [[f64; 2]; 4] = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];

    fn corners(vertices: &[Point]) -> Vec<[f64; 2]> {
        vertices.iter().map(|p| p.to_array()).collect()
    }

    /// The vertices that are stored, which a convex polygon stores alike.
    fn stored(outline: &[[f64; 2]]) -> Vec<[f64; 2]> {
        let [simple, convex] = [
            SimplePolygon::new(outline).map(|polygon| corners(polygon.vertices())),
            ConvexPolygon::new(outline).map(|polygon| corners(polygon.vertices())),
        ];
        assert_eq!(simple, convex);
        simple.unwrap()
    }

    #[test]
    fn either_winding_leads_back_to_the_given_numbers() {
        let clockwise = [[0.0, 0.0], [0.0, 2.0], [2.0, 2.0], [2.0, 0.0]];
        for outline in [SQUARE, clockwise] {
            assert_eq!(stored(&outline), SQUARE);
            let polygon = SimplePolygon::new(&outline).unwrap();
            for i in 0..4 {
                assert_eq!(outline[polygon.given_vertex(i)], SQUARE[i]);
                let edge = polygon.given_edge(i);
                let ends = [outline[edge], outline[(edge + 1) % 4]];
                let stored = [SQUARE[i], SQUARE[(i + 1) % 4]];
                assert!(stored == ends || stored == [ends[1], ends[0]], "edge {i}");
            }
        }
    }

    #[test]
    fn repeated_vertices_are_dropped_and_the_numbers_kept() {
        let [a, b, c, d] = SQUARE;
        let outline = [a, a, b, b, b, c, d, a, a];
        let polygon = SimplePolygon::new(&outline).unwrap();
        assert_eq!(corners(polygon.vertices()), SQUARE);
        let vertices = [0, 1, 2, 3].map(|i| polygon.given_vertex(i));
        assert_eq!(vertices, [0, 2, 5, 6]);
        let edges = [0, 1, 2, 3].map(|i| polygon.given_edge(i));
        assert_eq!(edges, [1, 4, 5, 6], "from the last of its repetitions");
    }

    #[test]
    fn refused_with_two_edges_that_meet() {
        use GeomError::{Degenerate, EdgesMeet};
        let ([a, b, c, d], e) = (SQUARE, [-1.0, 1.0]);
        let twice = [SQUARE, SQUARE].concat();
        let meet = |i, j| EdgesMeet { edges: [i, j] };
        let flat = Degenerate { vertex_idx: 0 };
        let cases: [(&str, &[[f64; 2]], GeomError); 9] = [
            ("one point", &[a, a, a], flat),
            ("two points", &[a, b, a, b], flat),
            ("all on one line", &[a, c, [1.0, 1.0]], flat),
            ("a bow tie", &[a, c, b, d], meet(0, 2)),
            ("a bow tie twice at a", &[a, a, c, b, d], meet(1, 3)),
            ("a vertex on an edge", &[a, b, c, [1.0, 0.0], d], meet(0, 3)),
            ("a spike", &[a, b, [3.0, 0.0], [2.0, 0.0], c, d], meet(1, 3)),
            ("a vertex twice", &[a, b, c, a, e, [-1.0, -1.0]], meet(3, 5)),
            ("twice around", &twice, meet(0, 4)),
        ];
        for (name, outline, expected) in cases {
            let refused = SimplePolygon::new(outline).unwrap_err();
            assert_eq!(refused, expected, "{name}: {refused}");
            assert_eq!(refused.code(), expected.code());
        }
    }

    #[test]
    fn collinear_vertices_stay() {
        let [a, b, c, d] = SQUARE;
        let outline = [a, [1.0, 0.0], b, c, d, [0.0, 1.0]];
        assert_eq!(stored(&outline), outline);
    }

    #[test]
    fn any_size_will_do() {
        for scale in [5e-324, 1e-308, 1e-160, 1e160, 8e307] {
            let outline = SQUARE.map(|p| p.map(|x| x * scale));
            assert_eq!(stored(&outline), outline, "a square of {scale:e}");
        }
    }
}
