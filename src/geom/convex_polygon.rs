//! Convex polygons, either winding on entry, counter-clockwise inside.

use std::cmp::Ordering;

use serde::{Deserialize, Serialize};

use super::{GeomError, HalfPlane, Point, Window, point::finite};

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
            return Err(GeomError::Degenerate { vertex_idx: n });
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
        let n = self.vertices.len();
        (0..n).map(move |i| HalfPlane::left_of(self.vertices[i], self.vertices[(i + 1) % n]))
    }
}

/// Which way every corner turns: `Greater` for counter-clockwise.
fn winding(vertices: &[Point]) -> Result<Ordering, GeomError> {
    let n = vertices.len();
    let mut winding = Ordering::Equal;
    for i in 0..n {
        let [a, b, c] = [0, 1, 2].map(|k| vertices[(i + k) % n]);
        let turn = orientation(a, b, c);
        let vertex_idx = (i + 1) % n;
        if turn == Ordering::Equal {
            // Collinear: going on is fine, turning back is not.
            if reverses(a, b, c) {
                return Err(GeomError::NotConvex { vertex_idx });
            }
        } else if winding == Ordering::Equal {
            winding = turn;
        } else if winding != turn {
            return Err(GeomError::NotConvex { vertex_idx });
        }
    }
    if winding == Ordering::Equal {
        return Err(GeomError::Degenerate { vertex_idx: 0 });
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

fn lexicographic(a: Point, b: Point) -> Ordering {
    (a.x(), a.y())
        .partial_cmp(&(b.x(), b.y()))
        .unwrap_or(Ordering::Equal)
}

/// Of three collinear points: does the second step go back over the first?
fn reverses(a: Point, b: Point, c: Point) -> bool {
    lexicographic(a, b) != lexicographic(b, c)
}

/// Sign of the area of abc, `Greater` for counter-clockwise, exact for coordinates of magnitude
/// 2⁻⁵⁰⁰ … 2⁵⁰⁰ (Shewchuk's adaptive predicate: Discrete & Computational Geometry 18, 1997).
fn orientation(a: Point, b: Point, c: Point) -> Ordering {
    let largest = [a, b, c]
        .iter()
        .flat_map(|p| p.to_array())
        .fold(0.0, |m: f64, x| m.max(x.abs()));
    // Larger coordinates are scaled by a power of two so that no product overflows.
    let scale = if largest > 2f64.powi(500) {
        2f64.powi(-540)
    } else {
        1.0
    };
    let coord = |p: Point| robust::Coord {
        x: p.x() * scale,
        y: p.y() * scale,
    };
    let area = robust::orient2d(coord(a), coord(b), coord(c));
    area.partial_cmp(&0.0).unwrap_or(Ordering::Equal)
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
