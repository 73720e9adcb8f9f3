//! A polygon with holes.

use super::{
    GeomError, Location, Point, Rings, SimplePolygon, Window, rings::locate, sweep::first_meeting,
};

/// A simple polygon without the insides of some others. No two rings touch.
#[derive(Clone, PartialEq, Debug)]
pub struct Region {
    rings: Rings,
    outer: SimplePolygon,
    holes: Vec<SimplePolygon>,
}

impl Region {
    /// # Errors
    /// [`GeomError::MisplacedHole`] where a hole does not lie in the interior of `outer`, or meets another one.
    pub fn new(outer: SimplePolygon, holes: Vec<SimplePolygon>) -> Result<Self, GeomError> {
        let mut rings = outer.rings().clone();
        for hole in &holes {
            rings.push(clockwise(hole.vertices()));
        }
        if !holes.is_empty() {
            if let Some(edges) = first_meeting(&rings) {
                let last = edges.into_iter().max().unwrap_or(0);
                let hole_idx = rings.ring_of(last).saturating_sub(1);
                return Err(GeomError::MisplacedHole { hole_idx });
            }
            // As no edges meet, one vertex of each tells.
            let is_in =
                |ring_idx: usize, p: Point| locate(rings.ring(ring_idx), p) == Location::Inside;
            let misplaced = (0..holes.len()).find(|&hole_idx| {
                let p = rings.ring(hole_idx + 1)[0];
                let is_in_another = |other| other != hole_idx && is_in(other + 1, p);
                !is_in(0, p) || (0..holes.len()).any(is_in_another)
            });
            if let Some(hole_idx) = misplaced {
                return Err(GeomError::MisplacedHole { hole_idx });
            }
        }
        Ok(Self {
            rings,
            outer,
            holes,
        })
    }

    /// The outer border.
    #[must_use]
    pub const fn outer(&self) -> &SimplePolygon {
        &self.outer
    }

    /// Counter-clockwise, each for itself.
    #[must_use]
    pub fn holes(&self) -> &[SimplePolygon] {
        &self.holes
    }

    /// Ring 0 is the outer one, counter-clockwise; then the holes, clockwise.
    #[must_use]
    pub const fn rings(&self) -> &Rings {
        &self.rings
    }

    /// The number of a vertex in the outline that was given for its ring.
    #[must_use]
    pub fn given_vertex(&self, vertex_idx: usize) -> usize {
        let idx = vertex_idx - self.first_of_ring(vertex_idx);
        match self.hole_of(vertex_idx) {
            None => self.outer.given_vertex(idx),
            // Stored the other way round, from the same vertex.
            Some(hole) => hole.given_vertex((hole.vertices().len() - idx) % hole.vertices().len()),
        }
    }

    /// The number of an edge in the outline that was given for its ring, which may have run the other way.
    #[must_use]
    pub fn given_edge(&self, edge_idx: usize) -> usize {
        let idx = edge_idx - self.first_of_ring(edge_idx);
        match self.hole_of(edge_idx) {
            None => self.outer.given_edge(idx),
            Some(hole) => hole.given_edge(hole.vertices().len() - 1 - idx),
        }
    }

    fn hole_of(&self, vertex_idx: usize) -> Option<&SimplePolygon> {
        let hole_idx = self.rings.ring_of(vertex_idx).checked_sub(1);
        hole_idx.map(|hole_idx| &self.holes[hole_idx])
    }

    fn first_of_ring(&self, vertex_idx: usize) -> usize {
        self.rings.bounds(self.rings.ring_of(vertex_idx))[0]
    }

    /// Exact. The border of a hole is border.
    #[must_use]
    pub fn locate(&self, p: Point) -> Location {
        self.rings.locate(p)
    }
}

/// The other way round, from the same vertex.
fn clockwise(ring: &[Point]) -> impl Iterator<Item = Point> + '_ {
    let (first, rest) = ring.split_at(1);
    first.iter().chain(rest.iter().rev()).copied()
}

impl From<SimplePolygon> for Region {
    fn from(outer: SimplePolygon) -> Self {
        Self {
            rings: outer.rings().clone(),
            outer,
            holes: Vec::new(),
        }
    }
}

impl From<Window> for Region {
    fn from(window: Window) -> Self {
        SimplePolygon::from(window).into()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(at: f64, size: f64) -> SimplePolygon {
        let [a, b] = [at, at + size];
        SimplePolygon::new(&[[a, a], [b, a], [b, b], [a, b]]).unwrap()
    }

    #[test]
    fn its_interior_is_to_the_left_of_every_edge() {
        let holes = vec![square(1.0, 2.0), square(5.0, 3.0)];
        let region = Region::new(square(0.0, 9.0), holes).unwrap();
        let rings = region.rings();
        assert_eq!(rings.n_rings(), 3);
        for edge_idx in 0..rings.points().len() {
            let [a, b] = rings.edge(edge_idx).map(Point::to_array);
            let beside = [0, 1].map(|axis| f64::midpoint(a[axis], b[axis]));
            let [dx, dy] = [0, 1].map(|axis| (b[axis] - a[axis]) / 8.0);
            let left = Point::new(beside[0] - dy, beside[1] + dx).unwrap();
            assert_eq!(region.locate(left), Location::Inside, "{left:?}");
            let ring = rings.ring_of(edge_idx);
            if ring > 0 {
                let hole = &region.holes()[ring - 1];
                let given = hole.edge(region.given_edge(edge_idx));
                assert_eq!([given.p2, given.p1], rings.edge(edge_idx));
                let given = hole.vertices()[region.given_vertex(edge_idx)];
                assert_eq!(given, rings.points()[edge_idx]);
            }
        }
    }

    #[test]
    fn a_hole_lies_inside_and_clear_of_everything() {
        let cases = [
            ("outside", vec![[10.0, 2.0]], Some(0)),
            ("around", vec![[-1.0, 11.0]], Some(0)),
            ("at an edge", vec![[4.0, 1.0], [0.0, 2.0]], Some(1)),
            ("touching a hole", vec![[1.0, 2.0], [3.0, 2.0]], Some(1)),
            ("in a hole", vec![[1.0, 6.0], [2.0, 2.0]], Some(1)),
            ("the outline itself", vec![[0.0, 9.0]], Some(0)),
            ("clear", vec![[1.0, 2.0], [4.0, 2.0]], None),
        ];
        for (name, holes, expected) in cases {
            let holes = holes.into_iter().map(|[at, size]| square(at, size));
            let refused = Region::new(square(0.0, 9.0), holes.collect()).err();
            let expected = expected.map(|hole_idx| GeomError::MisplacedHole { hole_idx });
            assert_eq!(refused, expected, "{name}");
        }
    }
}
