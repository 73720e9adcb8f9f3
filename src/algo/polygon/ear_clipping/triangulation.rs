//! What ear clipping leaves: the triangles of a polygon.

use std::sync::Arc;

use crate::geom::{Point, SimplePolygon};

/// Three vertices by the numbers that they were given with, counter-clockwise.
pub type Triangle = [usize; 3];

/// A polygon in triangles.
#[derive(Clone, PartialEq, Debug)]
pub struct Triangulation {
    points: Arc<[Point]>,
    triangles: Vec<Triangle>,
}

impl Triangulation {
    /// None yet; `order` is the polygon's [`order_of`].
    pub(super) fn new(polygon: &SimplePolygon, order: &[usize]) -> Self {
        let n_numbers = order.iter().max().map_or(0, |highest| highest + 1);
        let mut points = vec![Point::default(); n_numbers];
        for (&number, &at) in order.iter().zip(polygon.vertices()) {
            points[number] = at;
        }
        Self {
            points: points.into(),
            triangles: Vec::new(),
        }
    }

    pub(super) fn push(&mut self, triangle: Triangle) {
        self.triangles.push(triangle);
    }

    /// By the numbers that they were given with; a number that was dropped has a point that means nothing.
    pub(super) fn points(&self) -> Arc<[Point]> {
        Arc::clone(&self.points)
    }

    /// In the order in which they were cut off.
    #[must_use]
    pub fn triangles(&self) -> &[Triangle] {
        &self.triangles
    }

    /// Where a vertex is.
    #[must_use]
    pub fn at(&self, vertex_idx: usize) -> Point {
        self.points[vertex_idx]
    }

    /// Where a triangle's vertices are.
    #[must_use]
    pub fn corners(&self, triangle: Triangle) -> [Point; 3] {
        triangle.map(|vertex_idx| self.at(vertex_idx))
    }
}

/// The given numbers of the vertices, in the order of the polygon, counter-clockwise.
pub(super) fn order_of(polygon: &SimplePolygon) -> Vec<usize> {
    (0..polygon.vertices().len())
        .map(|i| polygon.given_vertex(i))
        .collect()
}
