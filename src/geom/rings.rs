//! Several closed outlines in one list of vertices.

use std::cmp::Ordering;

use super::{Point, orientation};

/// Where a point lies.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Location {
    /// In the interior.
    Inside,
    /// On an edge or a vertex.
    Border,
    /// Elsewhere.
    Outside,
}

/// Closed outlines, one after the other, with each vertex's neighbours. Edge `i` runs from vertex `i` to its
/// next one: vertices and edges are numbered through all rings.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Rings {
    points: Vec<Point>,
    next: Vec<u32>,
    previous: Vec<u32>,
    /// Of each ring the first vertex; and the number of vertices at the end.
    starts: Vec<u32>,
}

impl Rings {
    /// With one ring.
    #[must_use]
    pub(super) fn one(ring: impl IntoIterator<Item = Point>) -> Self {
        let mut rings = Self {
            starts: vec![0],
            ..Self::default()
        };
        rings.push(ring);
        rings
    }

    /// Adds a ring of at least one vertex.
    pub(super) fn push(&mut self, ring: impl IntoIterator<Item = Point>) {
        let start = self.points.len() as u32;
        self.points.extend(ring);
        let end = self.points.len() as u32;
        self.next.extend(start + 1..end);
        self.next.push(start);
        self.previous.push(end - 1);
        self.previous.extend(start..end - 1);
        self.starts.push(end);
    }

    /// Vertices of all rings.
    #[must_use]
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// The vertices of one ring.
    #[must_use]
    pub fn ring(&self, ring_idx: usize) -> &[Point] {
        let [start, end] = self.bounds(ring_idx);
        &self.points[start..end]
    }

    /// Every ring, first to last.
    #[must_use]
    pub fn iter(&self) -> impl ExactSizeIterator<Item = &[Point]> + '_ {
        (0..self.n_rings()).map(|i| self.ring(i))
    }

    /// How many there are.
    #[must_use]
    pub fn n_rings(&self) -> usize {
        self.starts.len().saturating_sub(1)
    }

    /// First vertex of a ring, and the one after its last.
    #[must_use]
    pub fn bounds(&self, ring_idx: usize) -> [usize; 2] {
        [self.starts[ring_idx], self.starts[ring_idx + 1]].map(|i| i as usize)
    }

    /// The ring that a vertex belongs to.
    #[must_use]
    pub fn ring_of(&self, vertex_idx: usize) -> usize {
        self.starts
            .partition_point(|&start| start as usize <= vertex_idx)
            - 1
    }

    /// The vertex after this one, in its ring.
    #[inline]
    #[must_use]
    pub fn next(&self, vertex_idx: usize) -> usize {
        self.next[vertex_idx] as usize
    }

    /// The vertex before this one, in its ring.
    #[inline]
    #[must_use]
    pub fn previous(&self, vertex_idx: usize) -> usize {
        self.previous[vertex_idx] as usize
    }

    /// Both ends of an edge.
    #[inline]
    #[must_use]
    pub fn edge(&self, edge_idx: usize) -> [Point; 2] {
        [self.points[edge_idx], self.points[self.next(edge_idx)]]
    }

    /// Exact. Inside is what an odd number of rings run around: rings must not cross.
    #[must_use]
    pub fn locate(&self, p: Point) -> Location {
        let mut inside = false;
        for ring in self.iter() {
            match locate(ring, p) {
                Location::Border => return Location::Border,
                Location::Inside => inside = !inside,
                Location::Outside => {}
            }
        }
        if inside {
            Location::Inside
        } else {
            Location::Outside
        }
    }
}

/// Where a point lies by one simple ring, of either winding. A ray to the right is crossed an odd number of
/// times from inside; an edge counts its lower end and not its upper one.
#[must_use]
pub fn locate(ring: &[Point], p: Point) -> Location {
    let mut inside = false;
    let Some(&last) = ring.last() else {
        return Location::Outside;
    };
    let mut from = last;
    for &to in ring {
        let a = from;
        from = to;
        if a == p {
            return Location::Border;
        }
        let (below, above) = (a.y() <= p.y(), to.y() <= p.y());
        if below != above {
            let (low, high) = if below { (a, to) } else { (to, a) };
            match orientation(low, high, p) {
                Ordering::Equal => return Location::Border,
                Ordering::Greater => inside = !inside,
                Ordering::Less => {}
            }
        } else if a.y() == p.y() && to.y() == p.y() && (a.x() < p.x()) != (to.x() < p.x()) {
            return Location::Border;
        }
    }
    if inside {
        Location::Inside
    } else {
        Location::Outside
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(ring: &[[f64; 2]]) -> Vec<Point> {
        ring.iter().map(|&p| Point::try_from(p).unwrap()).collect()
    }

    #[test]
    fn neighbours_stay_within_their_ring() {
        let mut rings = Rings::one(points(&[[0.0, 0.0], [9.0, 0.0], [0.0, 9.0]]));
        rings.push(points(&[[1.0, 1.0], [2.0, 2.0], [3.0, 1.0], [2.0, 1.0]]));
        assert_eq!((rings.next(2), rings.previous(0)), (0, 2));
        assert_eq!((rings.next(6), rings.previous(3)), (3, 6));
        assert_eq!([0, 2, 3, 6].map(|i| rings.ring_of(i)), [0, 0, 1, 1]);
        assert_eq!(rings.n_rings(), 2);
    }

    #[test]
    fn the_border_is_neither_inside_nor_outside() {
        use Location::{Border, Inside, Outside};
        // A comb: a ray along its spine's level meets vertices, edges along it, and turns.
        let comb = points(&[
            [0.0, 0.0],
            [6.0, 0.0],
            [6.0, 4.0],
            [5.0, 2.0],
            [4.0, 2.0],
            [3.0, 4.0],
            [2.0, 2.0],
            [1.0, 4.0],
            [1.0, 2.0],
            [0.0, 2.0],
        ]);
        let cases = [
            ([-1.0, 2.0], Outside),
            ([0.0, 2.0], Border),
            ([0.5, 2.0], Border),
            ([1.5, 2.0], Inside),
            ([2.0, 2.0], Border),
            ([3.0, 2.0], Inside),
            ([4.5, 2.0], Border),
            ([5.5, 2.0], Inside),
            ([6.0, 2.0], Border),
            ([7.0, 2.0], Outside),
            ([0.0, 0.0], Border),
            ([3.0, 0.0], Border),
            ([-1.0, 0.0], Outside),
            ([-1.0, 4.0], Outside),
            ([3.0, 4.0], Border),
            ([2.0, 4.0], Outside),
            ([2.0, 3.0], Outside),
            ([5.0, 3.0], Outside),
        ];
        for (p, expected) in cases {
            let at = Point::try_from(p).unwrap();
            assert_eq!(locate(&comb, at), expected, "{p:?}");
            let turned: Vec<Point> = comb.iter().rev().copied().collect();
            assert_eq!(locate(&turned, at), expected, "{p:?}, clockwise");
        }
    }
}
