//! Convex polygons, either winding on entry, counter-clockwise inside.

use std::cmp::Ordering;

use serde::{Deserialize, Serialize};

use super::{GeomError, HalfPlane, Point, Window, lexicographic, orientation, point::finite};

/// A convex polygon with an area. Vertices run counter-clockwise; three in a row may be collinear.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[serde(try_from = "Vec<[f64; 2]>", into = "Vec<[f64; 2]>")]
pub struct ConvexPolygon {
    vertices: Vec<Point>,
}

impl ConvexPolygon {
    /// Takes either winding; a clockwise outline is stored reversed, starting at the same vertex.
    ///
    /// # Errors
    /// [`GeomError`]: a coordinate that is not finite, fewer than three vertices, a repeated vertex or no
    /// area, a turn the wrong way, or an outline that runs around more than once.
    pub fn new(outline: &[[f64; 2]]) -> Result<Self, GeomError> {
        finite(outline.as_flattened())?;
        let n = outline.len();
        if n < 3 {
            return Err(GeomError::TooFewVertices);
        }
        let mut vertices: Vec<Point> = outline
            .iter()
            .map(|&[x, y]| Point::from_finite(x, y))
            .collect();
        if let Some(i) = (0..n).find(|&i| vertices[i] == vertices[(i + 1) % n]) {
            return Err(GeomError::Degenerate {
                vertex_idx: (i + 1) % n,
            });
        }
        if winding(&vertices)? == Ordering::Less {
            vertices[1..].reverse();
        }
        Ok(Self { vertices })
    }

    /// Counter-clockwise.
    #[must_use]
    pub fn vertices(&self) -> &[Point] {
        &self.vertices
    }

    /// One half-plane an edge; edge `i` runs from vertex `i` to vertex `i + 1`.
    #[must_use]
    pub fn half_planes(&self) -> impl ExactSizeIterator<Item = HalfPlane> + '_ {
        (0..self.vertices.len()).map(|edge_idx| self.half_plane(edge_idx))
    }

    /// The inside of the edge from one vertex to the next.
    ///
    /// # Panics
    /// Where there are not so many.
    #[inline]
    #[must_use]
    pub fn half_plane(&self, edge_idx: usize) -> HalfPlane {
        let next = (edge_idx + 1) % self.vertices.len();
        HalfPlane::left_of(self.vertices[edge_idx], self.vertices[next])
    }
}

/// Which way every corner turns: `Greater` for counter-clockwise.
fn winding(vertices: &[Point]) -> Result<Ordering, GeomError> {
    let n = vertices.len();
    let mut winding = Ordering::Equal;
    let mut spike = None;
    for i in 0..n {
        let [a, b, c] = [0, 1, 2].map(|k| vertices[(i + k) % n]);
        let turn = orientation(a, b, c);
        let vertex_idx = (i + 1) % n;
        if turn == Ordering::Equal {
            // Collinear: going on is fine, turning back is not.
            if reverses(a, b, c) {
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
    let directions: Vec<Ordering> = (0..n)
        .map(|i| lexicographic(vertices[i], vertices[(i + 1) % n]))
        .collect();
    let changes: Vec<usize> = (0..n)
        .filter(|&i| directions[i] != directions[(i + 1) % n])
        .collect();
    match changes.get(2) {
        Some(&i) => Err(GeomError::SelfIntersecting {
            vertex_idx: (i + 1) % n,
        }),
        None => Ok(winding),
    }
}

/// Of three collinear points: does the second step go back over the first?
fn reverses(a: Point, b: Point, c: Point) -> bool {
    lexicographic(a, b) != lexicographic(b, c)
}

impl From<Window> for ConvexPolygon {
    fn from(window: Window) -> Self {
        Self {
            vertices: window.corners().to_vec(),
        }
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
        polygon.vertices.iter().map(|p| p.to_array()).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SQUARE: [[f64; 2]; 4] = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];

    fn corners(polygon: &ConvexPolygon) -> Vec<[f64; 2]> {
        polygon.vertices().iter().map(|p| p.to_array()).collect()
    }

    #[test]
    fn either_winding_is_stored_counter_clockwise_from_the_same_vertex() {
        let clockwise = [[0.0, 0.0], [0.0, 2.0], [2.0, 2.0], [2.0, 0.0]];
        for outline in [SQUARE, clockwise] {
            let polygon = ConvexPolygon::new(&outline).unwrap();
            assert_eq!(corners(&polygon), SQUARE);
        }
    }

    #[test]
    fn three_vertices_in_a_row_may_be_collinear() {
        let outline = [
            [0.0, 0.0],
            [1.0, 0.0],
            [2.0, 0.0],
            [2.0, 2.0],
            [0.0, 2.0],
            [0.0, 1.0],
        ];
        let polygon = ConvexPolygon::new(&outline).unwrap();
        assert_eq!(corners(&polygon), outline);
        let normals: Vec<[f64; 2]> = polygon.half_planes().map(|plane| plane.normal()).collect();
        let [up, left, down, right] = [[0.0, 1.0], [-1.0, 0.0], [0.0, -1.0], [1.0, 0.0]];
        assert_eq!(
            normals,
            [up, up, left, down, right, right],
            "unit normals, pointing inside"
        );
    }

    #[test]
    fn refused_with_the_vertex_at_fault() {
        use GeomError::{Degenerate, NotConvex, SelfIntersecting, TooFewVertices};
        let tip = |i: usize| {
            let (sin, cos) = libm::sincos(std::f64::consts::TAU * (i * 2 % 5) as f64 / 5.0);
            [cos, sin]
        };
        let pentagram: Vec<[f64; 2]> = (0..5).map(tip).collect();
        let twice: Vec<[f64; 2]> = [SQUARE, SQUARE].concat();
        let cases: [(&str, &[[f64; 2]], GeomError); 10] = [
            ("nothing", &[], TooFewVertices),
            ("two vertices", &SQUARE[..2], TooFewVertices),
            (
                "a vertex twice in a row",
                &[[0.0, 0.0], [2.0, 0.0], [2.0, 0.0], [0.0, 2.0]],
                Degenerate { vertex_idx: 2 },
            ),
            (
                "the last vertex repeats the first",
                &[[0.0, 0.0], [2.0, 0.0], [0.0, 2.0], [0.0, 0.0]],
                Degenerate { vertex_idx: 0 },
            ),
            (
                "all on one line",
                &[[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]],
                Degenerate { vertex_idx: 0 },
            ),
            (
                "a dent",
                &[[0.0, 0.0], [4.0, 0.0], [2.0, 1.0], [0.0, 4.0]],
                NotConvex { vertex_idx: 2 },
            ),
            (
                "a spike",
                &[[0.0, 0.0], [4.0, 0.0], [2.0, 0.0], [2.0, 2.0]],
                NotConvex { vertex_idx: 1 },
            ),
            (
                "a bow tie",
                &[[0.0, 0.0], [2.0, 2.0], [2.0, 0.0], [0.0, 2.0]],
                NotConvex { vertex_idx: 3 },
            ),
            (
                "a pentagram",
                &pentagram,
                SelfIntersecting { vertex_idx: 4 },
            ),
            ("twice around", &twice, SelfIntersecting { vertex_idx: 6 }),
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
        let dent = 0.5_f64.next_down();
        let outline = |y: f64| [[0.0, 0.0], [1.0, -3.0], [1.0, 1.0], [0.5, y]];
        assert!(ConvexPolygon::new(&outline(0.5)).is_ok(), "collinear");
        assert!(
            ConvexPolygon::new(&outline(0.5_f64.next_up())).is_ok(),
            "outwards"
        );
        let refused = ConvexPolygon::new(&outline(dent)).unwrap_err();
        assert_eq!(refused, GeomError::NotConvex { vertex_idx: 3 }, "inwards");
    }

    #[test]
    fn any_size_will_do() {
        for scale in [5e-324, 1e-308, 1e-160, 1e160, 8e307] {
            let outline = SQUARE.map(|p| p.map(|x| x * scale));
            assert!(
                ConvexPolygon::new(&outline).is_ok(),
                "a square of {scale:e}"
            );
        }
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
        assert_eq!(
            serde_json::from_str::<ConvexPolygon>(&json).unwrap(),
            polygon
        );
        let refused = serde_json::from_str::<ConvexPolygon>("[[0,0],[1,1],[2,2]]").unwrap_err();
        assert!(refused.to_string().contains("degenerate"), "{refused}");
    }
}
