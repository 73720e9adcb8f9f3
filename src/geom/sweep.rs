//! Do the edges of some rings meet anywhere but in the vertices that neighbours share? A line sweeps from left to right and stops
//! at every vertex; two edges that meet are neighbours on it just before they do, so that only neighbours are compared.
//!
//! *Source*: M. I. Shamos and D. Hoey, "Geometric intersection problems", 17th Annual Symposium on Foundations of Computer
//! Science, 1976, pp. 208–215, doi:10.1109/SFCS.1976.16. *Cost*: O(n log n) predicates; the order is kept in a flat list, which
//! moves at most as many numbers as edges are cut at once.

use std::cmp::Ordering;

use super::{Point, Rings, lexicographic, orientation};

/// Two edges that cross, touch or overlap, where there are any. Neighbours in a ring may share their vertex alone.
pub fn first_meeting(rings: &Rings) -> Option<[usize; 2]> {
    let points = rings.points().iter().enumerate();
    let mut order: Vec<_> = points.map(|(i, p)| (p.x(), p.y(), i)).collect();
    order.sort_unstable_by(|a, b| a.partial_cmp(b).unwrap_or(Ordering::Equal));
    let ascending = |edge: usize| {
        let [a, b] = rings.edge(edge);
        match lexicographic(a, b) {
            Ordering::Less => [a, b],
            _ => [b, a],
        }
    };
    let mut sweep = Sweep {
        rings,
        edges: (0..order.len()).map(ascending).collect(),
        cut: Vec::new(),
    };
    let mut before = None;
    for (x, y, vertex) in order {
        if let Some((bx, by, other)) = before
            && (bx, by) == (x, y)
        {
            return Some([other, vertex]);
        }
        before = Some((x, y, vertex));
        if let Some(meeting) = sweep.pass(vertex) {
            return Some(meeting);
        }
    }
    None
}

struct Sweep<'a> {
    rings: &'a Rings,
    /// Each from the end that the line meets first.
    edges: Vec<[Point; 2]>,
    /// The edges that the line cuts, from the lowest to the highest.
    cut: Vec<u32>,
}

impl Sweep<'_> {
    /// Goes past a vertex: edges that end there go, edges that start there come.
    fn pass(&mut self, vertex: usize) -> Option<[usize; 2]> {
        let at = self.rings.points()[vertex];
        let [arriving, departing] = [self.rings.previous(vertex), vertex];
        let both = [
            (arriving, self.rings.points()[arriving]),
            (departing, self.rings.points()[self.rings.next(vertex)]),
        ];
        let ends_here = |far: Point| lexicographic(far, at) == Ordering::Less;
        let n_ending = both.iter().filter(|&&(_, far)| ends_here(far)).count();

        let low = self
            .cut
            .partition_point(|&edge| self.side(edge as usize, at) == Ordering::Greater);
        let high = low + n_ending;
        for idx in low..high {
            // All that the vertex lies on must end here.
            let edge = self.cut.get(idx).map_or(arriving, |&edge| edge as usize);
            if idx >= self.cut.len() || edge != arriving && edge != departing {
                return Some([edge, departing]);
            }
        }
        if let Some(&edge) = self.cut.get(high)
            && self.side(edge as usize, at) == Ordering::Equal
        {
            return Some([edge as usize, departing]);
        }

        let n_starting = 2 - n_ending;
        let starting = match n_ending {
            0 => match orientation(at, both[0].1, both[1].1) {
                Ordering::Greater => [arriving, departing],
                Ordering::Less => [departing, arriving],
                Ordering::Equal => return Some([arriving, departing]),
            },
            1 if ends_here(both[0].1) => [departing; 2],
            _ => [arriving; 2],
        };
        let starting = starting.map(|edge| edge as u32);
        if n_ending == 1 {
            // The common case moves nothing.
            self.cut[low] = starting[0];
        } else {
            self.cut
                .splice(low..high, starting[..n_starting].iter().copied());
        }
        let above = low + n_starting;
        let below = low.checked_sub(1);
        let first = below.and_then(|below| self.compare(below, low));
        if first.is_some() || n_starting == 0 {
            return first;
        }
        self.compare(above - 1, above)
    }

    /// `Greater` where a point lies above an edge.
    fn side(&self, edge: usize, p: Point) -> Ordering {
        let [a, b] = self.edges[edge];
        orientation(a, b, p)
    }

    /// Two that have become neighbours on the line, by their places in it.
    fn compare(&self, i: usize, j: usize) -> Option<[usize; 2]> {
        let [e, f] = [*self.cut.get(i)?, *self.cut.get(j)?].map(|edge| edge as usize);
        let share_a_vertex = self.rings.next(e) == f || self.rings.next(f) == e;
        (!share_a_vertex && meet(self.edges[e], self.edges[f])).then_some([e, f])
    }
}

/// Have two closed segments a point in common?
pub fn meet([a, b]: [Point; 2], [c, d]: [Point; 2]) -> bool {
    let apart = |axis: fn(Point) -> f64| {
        let [a, b, c, d] = [a, b, c, d].map(axis);
        a.max(b) < c.min(d) || c.max(d) < a.min(b)
    };
    let on_one_side = |[a, b]: [Point; 2], [c, d]: [Point; 2]| {
        let side = orientation(a, b, c);
        side != Ordering::Equal && side == orientation(a, b, d)
    };
    !apart(Point::x)
        && !apart(Point::y)
        && !on_one_side([a, b], [c, d])
        && !on_one_side([c, d], [a, b])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geom::random_bits;

    fn rings(ring: &[[f64; 2]]) -> Rings {
        Rings::one(ring.iter().map(|&p| Point::try_from(p).unwrap()))
    }

    /// Every pair of edges, by definition.
    fn any_two_meet(rings: &Rings) -> bool {
        let n = rings.points().len();
        (0..n).any(|e| {
            (e + 1..n).any(|f| match (rings.next(e) == f, rings.next(f) == e) {
                (false, false) => meet(rings.edge(e), rings.edge(f)),
                (true, _) => overlap(rings.edge(e), rings.edge(f)),
                (_, true) => overlap(rings.edge(f), rings.edge(e)),
            })
        })
    }

    /// Does the second edge go back over the first?
    fn overlap([a, b]: [Point; 2], [_, c]: [Point; 2]) -> bool {
        orientation(a, b, c) == Ordering::Equal && lexicographic(a, b) != lexicographic(b, c)
    }

    #[test]
    fn neighbours_alone_find_every_meeting() {
        // Outlines on a small grid, so that touches and overlaps abound.
        let mut bits = random_bits(1);
        let mut next = |n: u64| (bits() >> 33) % n;
        let mut n_simple = 0;
        for _ in 0..40_000 {
            let n = 3 + next(5);
            let ring: Vec<[f64; 2]> = (0..n).map(|_| [next(5) as f64, next(5) as f64]).collect();
            if (0..ring.len()).any(|i| ring[i] == ring[(i + 1) % ring.len()]) {
                continue;
            }
            let rings = rings(&ring);
            let found = first_meeting(&rings);
            assert_eq!(found.is_some(), any_two_meet(&rings), "{ring:?}: {found:?}");
            n_simple += usize::from(found.is_none());
            if let Some([e, f]) = found {
                let told = meet(rings.edge(e), rings.edge(f));
                assert!(e != f && told, "{ring:?}: edges {e} and {f} meet");
            }
        }
        assert!(n_simple > 1000, "{n_simple} simple outlines");
    }
}
