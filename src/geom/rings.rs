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

impl Location {
    const fn strictly(inside: bool) -> Self {
        if inside { Self::Inside } else { Self::Outside }
    }
}

/// Closed outlines, numbered through: edge `i` runs from vertex `i` to the next of its ring.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Rings {
    points: Vec<Point>,
    next: Vec<u32>,
    previous: Vec<u32>,
    /// Of each ring the first vertex; and the number of vertices at the end.
    starts: Vec<u32>,
}

impl Rings {
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
        let starts_before = |&start: &u32| start as usize <= vertex_idx;
        self.starts.partition_point(starts_before) - 1
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
        self.locate_by(p, |a, b| a <= b, orientation)
    }

    /// The same by another comparison and another test of sides, which are to be exact: `turn` tells on which side of the line
    /// through the first two points the third one lies.
    pub fn locate_by(
        &self,
        p: Point,
        at_most: impl Fn(f64, f64) -> bool,
        turn: impl Fn(Point, Point, Point) -> Ordering,
    ) -> Location {
        let mut inside = false;
        for ring in self.iter() {
            match locate_by(ring, p, &at_most, &turn) {
                Location::Border => return Location::Border,
                Location::Inside => inside = !inside,
                Location::Outside => {}
            }
        }
        Location::strictly(inside)
    }
}

/// Where a point lies by one simple ring, of either winding. A ray to the right is crossed an odd number of
/// times from inside; an edge counts its lower end and not its upper one.
#[must_use]
pub fn locate(ring: &[Point], p: Point) -> Location {
    locate_by(ring, p, |a, b| a <= b, orientation)
}

fn locate_by(
    ring: &[Point],
    p: Point,
    at_most: impl Fn(f64, f64) -> bool,
    turn: impl Fn(Point, Point, Point) -> Ordering,
) -> Location {
    let mut inside = false;
    let mut from = ring.last().copied().unwrap_or_default();
    for &to in ring {
        let a = std::mem::replace(&mut from, to);
        if a == p {
            return Location::Border;
        }
        let (below, above) = (at_most(a.y(), p.y()), at_most(to.y(), p.y()));
        if below != above {
            let (low, high) = if below { (a, to) } else { (to, a) };
            match turn(low, high, p) {
                Ordering::Equal => return Location::Border,
                Ordering::Greater => inside = !inside,
                Ordering::Less => {}
            }
        } else if a.y() == p.y() && to.y() == p.y() && (a.x() < p.x()) != (to.x() < p.x()) {
            return Location::Border;
        }
    }
    Location::strictly(inside)
}

/// Each of a ring with the one after it, and the last with the first.
pub fn pairs_around<T: Copy>(ring: &[T]) -> impl Iterator<Item = [T; 2]> {
    let next = ring.iter().cycle().skip(1);
    ring.iter().zip(next).map(|(&here, &next)| [here, next])
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
        let xs = [0.0, 6.0, 6.0, 5.0, 4.0, 3.0, 2.0, 1.0, 1.0, 0.0];
        let ys = [0.0, 0.0, 4.0, 2.0, 2.0, 4.0, 2.0, 4.0, 2.0, 2.0];
        let comb = points(&std::array::from_fn::<_, 10, _>(|i| [xs[i], ys[i]]));
        let turned: Vec<Point> = comb.iter().rev().copied().collect();
        let levels: [(f64, Location, &[f64]); 8] = [
            (0.0, Outside, &[-1.0]),
            (0.0, Border, &[0.0, 3.0]),
            (2.0, Outside, &[-1.0, 7.0]),
            (2.0, Border, &[0.0, 0.5, 2.0, 4.5, 6.0]),
            (2.0, Inside, &[1.5, 3.0, 5.5]),
            (3.0, Outside, &[2.0, 5.0]),
            (4.0, Outside, &[-1.0, 2.0]),
            (4.0, Border, &[3.0]),
        ];
        for (y, expected, along) in levels {
            for &x in along {
                let at = Point::new(x, y).unwrap();
                assert_eq!(locate(&comb, at), expected, "{at:?}");
                assert_eq!(locate(&turned, at), expected, "{at:?}, clockwise");
            }
        }
    }
}
