//! Closed outlines: polygons whatever their shape, and convex ones.

use std::cmp::Ordering;

use serde::{Deserialize, Serialize};

use super::{
    GeomError, HalfPlane, Point, Segment, Window, lexicographic, orientation, point::finite,
};

/// At least three vertices joined in a ring. It may turn either way, repeat vertices and cross itself.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[serde(try_from = "Vec<[f64; 2]>", into = "Vec<[f64; 2]>")]
pub struct Polygon {
    vertices: Vec<Point>,
}

impl Polygon {
    /// # Errors
    /// [`GeomError::NotFinite`], or [`GeomError::TooFewVertices`] where there are fewer than three vertices.
    pub fn new(outline: &[[f64; 2]]) -> Result<Self, GeomError> {
        finite(outline.as_flattened())?;
        let points = outline.iter().map(|&[x, y]| Point::from_finite(x, y));
        Self::from_points(points.collect())
    }

    /// # Errors
    /// [`GeomError::TooFewVertices`] where there are fewer than three vertices.
    pub fn from_points(vertices: Vec<Point>) -> Result<Self, GeomError> {
        match vertices.len() {
            0..3 => Err(GeomError::TooFewVertices),
            _ => Ok(Self { vertices }),
        }
    }

    /// As given.
    #[must_use]
    pub fn vertices(&self) -> &[Point] {
        &self.vertices
    }

    /// Moves a vertex; an index that is none is ignored.
    pub fn set_vertex(&mut self, vertex_idx: usize, to: Point) {
        if let Some(vertex) = self.vertices.get_mut(vertex_idx) {
            *vertex = to;
        }
    }

    /// From vertex `edge_idx` to the next; the last edge closes the ring.
    #[must_use]
    pub fn edge(&self, edge_idx: usize) -> Segment {
        let (p1, next) = (
            self.vertices[edge_idx],
            (edge_idx + 1) % self.vertices.len(),
        );
        let p2 = self.vertices[next];
        Segment { p1, p2 }
    }

    /// Every edge, first to last.
    #[must_use]
    pub fn edges(&self) -> impl ExactSizeIterator<Item = Segment> + '_ {
        (0..self.vertices.len()).map(|i| self.edge(i))
    }
}

impl From<Window> for Polygon {
    fn from(window: Window) -> Self {
        Self {
            vertices: window.corners().to_vec(),
        }
    }
}

impl From<&ConvexPolygon> for Polygon {
    fn from(polygon: &ConvexPolygon) -> Self {
        polygon.0.clone()
    }
}

impl TryFrom<Vec<[f64; 2]>> for Polygon {
    type Error = GeomError;
    fn try_from(outline: Vec<[f64; 2]>) -> Result<Self, GeomError> {
        Self::new(&outline)
    }
}

impl From<Polygon> for Vec<[f64; 2]> {
    fn from(polygon: Polygon) -> Self {
        polygon.vertices.into_iter().map(Point::to_array).collect()
    }
}

/// A convex polygon with an area. Vertices run counter-clockwise; three in a row may be collinear.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[serde(try_from = "Vec<[f64; 2]>", into = "Vec<[f64; 2]>")]
pub struct ConvexPolygon(Polygon);

impl ConvexPolygon {
    /// Takes either winding; a clockwise outline is stored reversed, starting at the same vertex.
    ///
    /// # Errors
    /// All of [`GeomError`] but those of windows, edges that meet and holes.
    pub fn new(outline: &[[f64; 2]]) -> Result<Self, GeomError> {
        let mut polygon = Polygon::new(outline)?;
        let (vertices, n) = (&mut polygon.vertices, outline.len());
        if let Some(i) = (0..n).find(|&i| vertices[i] == vertices[(i + 1) % n]) {
            let vertex_idx = (i + 1) % n;
            return Err(GeomError::Degenerate { vertex_idx });
        }
        if winding(vertices)? == Ordering::Less {
            vertices[1..].reverse();
        }
        Ok(Self(polygon))
    }

    /// Counter-clockwise.
    #[inline]
    #[must_use]
    pub fn vertices(&self) -> &[Point] {
        &self.0.vertices
    }

    /// One half-plane an edge; edge `i` runs from vertex `i` to vertex `i + 1`.
    #[must_use]
    pub fn half_planes(&self) -> impl ExactSizeIterator<Item = HalfPlane> + '_ {
        (0..self.vertices().len()).map(|edge_idx| self.half_plane(edge_idx))
    }

    /// The inside of the edge from vertex `edge_idx` to the next.
    #[inline]
    #[must_use]
    pub fn half_plane(&self, edge_idx: usize) -> HalfPlane {
        let vertices = self.vertices();
        HalfPlane::left_of(
            vertices[edge_idx],
            vertices[(edge_idx + 1) % vertices.len()],
        )
    }
}

/// Which way every corner turns: `Greater` for counter-clockwise.
fn winding(vertices: &[Point]) -> Result<Ordering, GeomError> {
    let n = vertices.len();
    let mut winding = Ordering::Equal;
    let mut spike = None;
    let corner = |i: usize| [0, 1, 2].map(|k| vertices[(i + k) % n]);
    // Does the edge after this one run the other way along x?
    let turns_back = |i: usize| {
        let [a, b, c] = corner(i);
        lexicographic(a, b) != lexicographic(b, c)
    };
    for i in 0..n {
        let [a, b, c] = corner(i);
        let turn = orientation(a, b, c);
        let vertex_idx = (i + 1) % n;
        if turn == Ordering::Equal {
            // Collinear: going on is fine, turning back is not.
            if turns_back(i) {
                spike = spike.or(Some(vertex_idx));
            }
        } else if winding == Ordering::Equal {
            winding = turn;
        } else if winding != turn {
            let vertex_idx = spike.unwrap_or(vertex_idx);
            return Err(GeomError::NotConvex { vertex_idx });
        }
    }
    if winding == Ordering::Equal {
        return Err(GeomError::Degenerate { vertex_idx: 0 });
    }
    if let Some(vertex_idx) = spike {
        return Err(GeomError::NotConvex { vertex_idx });
    }
    // A convex outline goes up once and down once: it changes direction along x exactly twice.
    let mut changes = (0..n).filter(|&i| turns_back(i));
    match changes.nth(2).map(|i| (i + 1) % n) {
        Some(vertex_idx) => Err(GeomError::SelfIntersecting { vertex_idx }),
        None => Ok(winding),
    }
}

impl From<Window> for ConvexPolygon {
    fn from(window: Window) -> Self {
        Self(window.into())
    }
}

impl TryFrom<Vec<[f64; 2]>> for ConvexPolygon {
    type Error = GeomError;
    fn try_from(outline: Vec<[f64; 2]>) -> Result<Self, GeomError> {
        Self::new(&outline)
    }
}

impl From<ConvexPolygon> for Vec<[f64; 2]> {
    fn from(polygon: ConvexPolygon) -> Self {
        polygon.0.into()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SQUARE: [[f64; 2]; 4] = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];

    #[test]
    fn three_finite_vertices_are_enough_in_any_shape() {
        let bow_tie = [[0.0, 0.0], [2.0, 2.0], [2.0, 0.0], [0.0, 2.0]];
        let polygon = Polygon::new(&bow_tie).unwrap();
        assert_eq!(polygon.edge(3).to_array(), [0.0, 2.0, 0.0, 0.0]);
        assert_eq!(Polygon::new(&bow_tie[..2]), Err(GeomError::TooFewVertices));
        let refused = Polygon::new(&[[0.0, 0.0], [1.0, f64::NAN], [2.0, 0.0]]).unwrap_err();
        assert!(matches!(refused, GeomError::NotFinite { index: 3, .. }));
    }
    #[test]
    fn normals_are_of_length_1_along_the_axes_and_point_inside() {
        let [a, b, c, d] = SQUARE;
        let polygon = ConvexPolygon::new(&[a, [1.0, 0.0], b, c, d, [0.0, 1.0]]).unwrap();
        let normals: Vec<[f64; 2]> = polygon.half_planes().map(|plane| plane.normal()).collect();
        let [up, left, down, right] = [[0.0, 1.0], [-1.0, 0.0], [0.0, -1.0], [1.0, 0.0]];
        assert_eq!(normals, [up, up, left, down, right, right]);
    }

    #[test]
    fn refused_with_the_vertex_at_fault() {
        use GeomError::{Degenerate, NotConvex, SelfIntersecting, TooFewVertices};
        let [a, b, c, d] = SQUARE;
        let tip = |i: usize| {
            let (sin, cos) = libm::sincos(std::f64::consts::TAU * (i * 2 % 5) as f64 / 5.0);
            [cos, sin]
        };
        let pentagram: Vec<[f64; 2]> = (0..5).map(tip).collect();
        let twice: Vec<[f64; 2]> = [SQUARE, SQUARE].concat();
        let flat = |vertex_idx| Degenerate { vertex_idx };
        let dent = |vertex_idx| NotConvex { vertex_idx };
        let again = |vertex_idx| SelfIntersecting { vertex_idx };
        let dented = [a, [4.0, 0.0], [2.0, 1.0], [0.0, 4.0]];
        let cases: [(&str, &[[f64; 2]], GeomError); 10] = [
            ("nothing", &[], TooFewVertices),
            ("two vertices", &[a, b], TooFewVertices),
            ("a vertex twice in a row", &[a, b, b, d], flat(2)),
            ("the last vertex repeats the first", &[a, b, d, a], flat(0)),
            ("all on one line", &[a, [1.0, 1.0], c], flat(0)),
            ("a dent", &dented, dent(2)),
            ("a spike", &[a, [4.0, 0.0], b, c], dent(1)),
            ("a bow tie", &[a, c, b, d], dent(3)),
            ("a pentagram", &pentagram, again(4)),
            ("twice around", &twice, again(6)),
        ];
        for (name, outline, expected) in cases {
            let refused = ConvexPolygon::new(outline).unwrap_err();
            assert_eq!(refused, expected, "{name}: {refused}");
        }
    }

    #[test]
    fn a_number_that_is_not_finite_is_named_by_its_place() {
        let refused = ConvexPolygon::new(&[[0.0, 0.0], [2.0, f64::NAN], [0.0, 2.0]]).unwrap_err();
        assert!(matches!(refused, GeomError::NotFinite { index: 3, value } if value.is_nan()));
        assert_eq!(refused.code(), "not-finite");
    }

    #[test]
    fn a_turn_of_one_unit_in_the_last_place_is_seen() {
        let refused =
            |y: f64| ConvexPolygon::new(&[[0.0, 0.0], [1.0, -3.0], [1.0, 1.0], [0.5, y]]).err();
        assert_eq!(refused(0.5), None, "collinear");
        assert_eq!(refused(0.5_f64.next_up()), None, "outwards");
        let inwards = Some(GeomError::NotConvex { vertex_idx: 3 });
        assert_eq!(refused(0.5_f64.next_down()), inwards);
    }

    #[test]
    fn a_window_is_one() {
        let window = Window::new(0.0, 0.0, 2.0, 2.0).unwrap();
        let polygon = ConvexPolygon::from(window);
        assert_eq!(ConvexPolygon::new(&SQUARE), Ok(polygon.clone()));
        for (plane, edge) in polygon.half_planes().zip([2, 1, 3, 0]) {
            let expected = window.half_plane(crate::geom::Edge::ALL[edge]);
            assert_eq!(plane.normal(), expected.normal());
        }
    }

    #[test]
    fn through_json_and_back() {
        let polygon = ConvexPolygon::new(&SQUARE).unwrap();
        let json = serde_json::to_string(&polygon).unwrap();
        let again: ConvexPolygon = serde_json::from_str(&json).unwrap();
        assert_eq!(again, polygon);
        let refused = serde_json::from_str::<ConvexPolygon>("[[0,0],[1,1],[2,2]]").unwrap_err();
        assert!(refused.to_string().contains("degenerate"), "{refused}");
    }
}
