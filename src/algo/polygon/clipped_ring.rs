//! What is left of a polygon: one ring of vertices, and what it amounts to.

use serde::Serialize;

use crate::geom::{Point, Polygon, orientation};

use super::Vertex;

/// What a clipped ring amounts to.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum RingOutcome {
    /// Nothing of the polygon lies in the region, not even on its border.
    Empty,
    /// The polygon lies in the region: the ring is the polygon, vertex for vertex.
    Whole,
    /// Part of it does: the ring has an area, and perhaps bridges without one.
    Cut,
    /// A ring without area: the polygon only touches the region from outside, or had no area to begin with.
    Degenerate,
}

/// The one ring that Sutherland–Hodgman leaves.
#[derive(Clone, PartialEq, Debug)]
pub struct ClippedRing<V> {
    /// What it amounts to.
    pub outcome: RingOutcome,
    /// In the order in which the polygon was walked. Where the outcome is `Degenerate`: where it touches.
    pub vertices: Vec<V>,
}

impl RingOutcome {
    pub(super) fn of<V: Vertex>(polygon: &[V], vertices: &[V]) -> Self {
        if vertices.is_empty() {
            Self::Empty
        } else if !has_area(vertices) {
            Self::Degenerate
        } else if vertices == polygon {
            Self::Whole
        } else {
            Self::Cut
        }
    }
}

impl<V: Vertex> ClippedRing<V> {
    /// The ring as a polygon; `None` where there is nothing to fill.
    #[must_use]
    pub fn polygon(&self) -> Option<Polygon> {
        match self.outcome {
            RingOutcome::Empty | RingOutcome::Degenerate => None,
            RingOutcome::Whole | RingOutcome::Cut => {
                let points = self.vertices.iter().map(Vertex::at).collect();
                Polygon::from_points(points).ok()
            }
        }
    }
}

/// Has the ring an area? Exact on the coordinates.
///
/// What lies straight between its neighbours, or at the tip of a spike, is taken out until every corner turns: three must be left.
/// Parts of a ring that crosses itself do not cancel out here.
pub fn has_area<V: Vertex>(ring: &[V]) -> bool {
    area_is_clear(ring) || turns(ring)
}

/// Is the signed area of the ring certainly not zero? The quick answer, for most.
fn area_is_clear<V: Vertex>(ring: &[V]) -> bool {
    let Some(origin) = ring.first().map(|v| v.at().to_array()) else {
        return false;
    };
    let (mut twice_area, mut magnitude) = (0.0, 0.0);
    let mut from = [0.0; 2];
    for vertex in &ring[1..] {
        let [x, y] = vertex.at().to_array();
        let to = [x - origin[0], y - origin[1]];
        let products = [from[0] * to[1], from[1] * to[0]];
        twice_area += products[0] - products[1];
        magnitude += products[0].abs() + products[1].abs();
        from = to;
    }
    // Four roundings a term: two differences, a product, its difference; and one for each sum that a term goes
    // into. Below the first bound products vanish, above the other they are infinite.
    let bound = (ring.len() + 8) as f64 * f64::EPSILON * magnitude;
    (1e-250..1e300).contains(&magnitude) && twice_area.abs() > bound
}

fn turns<V: Vertex>(ring: &[V]) -> bool {
    let straight = |a: Point, b: Point, c: Point| orientation(a, b, c).is_eq();
    // A stack of corners that turn; its bottom is `corners[bottom]`.
    let mut corners: Vec<Point> = Vec::with_capacity(ring.len());
    for vertex in ring {
        let p = vertex.at();
        while let [.., a, b] = corners[..]
            && straight(a, b, p)
        {
            corners.pop();
        }
        if corners.last() != Some(&p) {
            corners.push(p);
        }
    }
    // The ends of the stack are neighbours too.
    let mut rest = &corners[..];
    while let [first, second, .., before, last] | [first, second @ before, last] = rest {
        if first == last || straight(*before, *last, *first) {
            rest = &rest[..rest.len() - 1];
        } else if straight(*last, *first, *second) {
            rest = &rest[1..];
        } else {
            return true;
        }
    }
    false
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ring(outline: &[[f64; 2]]) -> Vec<Point> {
        outline
            .iter()
            .map(|&[x, y]| Point::new(x, y).unwrap())
            .collect()
    }

    #[test]
    fn a_ring_without_area_goes_there_and_back() {
        let l_shaped = [[1.0, 0.0], [0.0, 0.0], [0.0, 1.0], [0.0, 0.0]];
        let cases: [(&str, &[[f64; 2]], bool); 9] = [
            ("nothing", &[], false),
            ("a point", &[[1.0, 2.0]], false),
            ("an edge", &[[1.0, 2.0], [3.0, 4.0]], false),
            ("a point three times", &[[1.0, 2.0]; 3], false),
            ("a line", &[[0.0, 0.0], [0.75, 0.375], [0.25, 0.125]], false),
            ("around a corner and back", &l_shaped, false),
            ("a triangle", &[[0.0, 0.0], [1.0, 0.0], [0.0, 5e-324]], true),
            (
                "a bow tie, whose halves cancel out",
                &[[0.0, 0.0], [2.0, 2.0], [2.0, 0.0], [0.0, 2.0]],
                true,
            ),
            (
                "a triangle with a spike at either end of the list",
                &[[-1.0, 0.0], [0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.0, 0.0]],
                true,
            ),
        ];
        for (name, outline, expected) in cases {
            for start in 0..outline.len().max(1) {
                let mut outline = outline.to_vec();
                let mid = start.min(outline.len());
                outline.rotate_left(mid);
                assert_eq!(has_area(&ring(&outline)), expected, "{name}, from {start}");
            }
        }
    }
}
