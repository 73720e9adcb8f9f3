//! A closed outline, whatever its shape.

use serde::{Deserialize, Serialize};

use super::{ConvexPolygon, GeomError, Point, Segment, Window, point::finite};

/// At least three vertices, all finite, joined in a ring: edge `i` runs from vertex `i` to the next. It may
/// turn either way, repeat vertices and cross itself; [`ConvexPolygon`] promises more.
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
        Self::from_points(
            outline
                .iter()
                .map(|&[x, y]| Point::from_finite(x, y))
                .collect(),
        )
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
    ///
    /// # Panics
    /// Where there is no such edge.
    #[must_use]
    pub fn edge(&self, edge_idx: usize) -> Segment {
        let next = (edge_idx + 1) % self.vertices.len();
        Segment {
            p1: self.vertices[edge_idx],
            p2: self.vertices[next],
        }
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
        Self {
            vertices: polygon.vertices().to_vec(),
        }
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_finite_vertices_are_enough_in_any_shape() {
        let bow_tie = [[0.0, 0.0], [2.0, 2.0], [2.0, 0.0], [0.0, 2.0]];
        let polygon = Polygon::new(&bow_tie).unwrap();
        assert_eq!(polygon.edge(3).to_array(), [0.0, 2.0, 0.0, 0.0]);
        assert_eq!(Polygon::new(&bow_tie[..2]), Err(GeomError::TooFewVertices));
        let refused = Polygon::new(&[[0.0, 0.0], [1.0, f64::NAN], [2.0, 0.0]]).unwrap_err();
        assert!(matches!(refused, GeomError::NotFinite { index: 3, .. }));
    }
}
