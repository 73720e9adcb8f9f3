//! Where an edge of the subject and an edge of the clip polygon meet.
//!
//! ```text
//!        c₂              a₁, a₂   of both ends of the subject's edge from the clip edge's line
//!         ╲ ← a₁ →  ● s₁ b₁, b₂   of both ends of the clip edge from the subject edge's line
//!          ╲     ╱
//!           × ─ ╱        crossing where a₁ and a₂ differ in sign, and b₁ and b₂ too:
//!          ╱ ╲           t = a₁ / (a₁ − a₂) along the subject, u = b₁ / (b₁ − b₂) along the clip polygon
//!      s₂ ●   ╲ c₁
//! ```
//!
//! An edge owns its first end and not its last: every crossing or vertex that both borders share belongs to exactly one pair.

use std::cmp::Ordering;

use serde::Serialize;

use crate::{
    algo::line::Ratio,
    geom::{Point, exponent, lexicographic, times_power},
    trace::Real,
};

use super::{input::List, predicate::side};

/// How two edges meet: Foster, Hormann and Popa's X, T and V.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Contact {
    /// Both within (X).
    Crossing,
    /// A vertex of the subject within an edge of the clip polygon (T).
    SubjectVertex,
    /// A vertex of the clip polygon within an edge of the subject (T).
    ClipVertex,
    /// A vertex of both (V).
    BothVertices,
}

impl Contact {
    /// Is it a vertex of the subject, or of the clip polygon, in this order?
    #[must_use]
    pub const fn at_vertex(self) -> [bool; 2] {
        match self {
            Self::Crossing => [false, false],
            Self::SubjectVertex => [true, false],
            Self::ClipVertex => [false, true],
            Self::BothVertices => [true, true],
        }
    }
}

/// A point that both edges own.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Meeting {
    /// Vertex or crossing.
    pub contact: Contact,
    /// A vertex as given; a crossing rounded, within the boxes of both edges.
    pub at: Point,
    /// Along the subject's edge.
    pub t: Ratio,
    /// Along the edge of the clip polygon.
    pub u: Ratio,
    /// Whose edge a crossing is computed along: see `crossing`.
    pub along: List,
    /// Does the subject come from the right of the clip edge? Of crossings only.
    pub from_right: bool,
}

/// All that two edges own together: where they overlap the other way round it may be two points.
#[inline]
pub fn meetings<R: Real>(s: [Point; 2], c: [Point; 2]) -> [Option<Meeting>; 2] {
    let zero = R::new(0.0);
    let a: [R; 2] = s.map(|p| side(c[0], c[1], p));
    if a[0] > zero && a[1] > zero || a[0] < zero && a[1] < zero {
        return [None; 2];
    }
    let b: [R; 2] = c.map(|p| side(s[0], s[1], p));
    if b[0] > zero && b[1] > zero || b[0] < zero && b[1] < zero {
        return [None; 2];
    }
    if a == [zero; 2] {
        return overlap(s, c);
    }
    // Not parallel from here on: one common point at most.
    let contact = match (a.map(|d| d == zero), b.map(|d| d == zero)) {
        // The last end belongs to the next edge.
        ([_, true], _) | (_, [_, true]) => return [None; 2],
        ([true, _], [true, _]) => Contact::BothVertices,
        ([true, _], _) => Contact::SubjectVertex,
        (_, [true, _]) => Contact::ClipVertex,
        _ => Contact::Crossing,
    };
    let ratio = |[d1, d2]: [R; 2]| Ratio {
        num: d1.get() + 0.0,
        den: (d1 - d2).get(),
    };
    let along = if precedence(s) <= precedence(c) {
        List::Subject
    } else {
        List::Clip
    };
    // Sides have been decided: from here on only the distances' ratio counts.
    let near = if are_plain([s, c], [a, b]) {
        Near {
            edges: [s, c],
            a,
            b,
            by: 0,
        }
    } else {
        Near::of([s, c])
    };
    let at = match (contact, along) {
        (Contact::Crossing, along) => near.crossing(along),
        (Contact::ClipVertex, _) => c[0],
        (Contact::SubjectVertex | Contact::BothVertices, _) => s[0],
    };
    let meeting = Meeting {
        contact,
        at,
        t: ratio(near.a),
        u: ratio(near.b),
        along,
        from_right: a[0] < zero,
    };
    [Some(meeting), None]
}

/// A subject's edge and a clip edge, and their ends' distances as [`meetings`] has them.
struct Near<R> {
    edges: [[Point; 2]; 2],
    a: [R; 2],
    b: [R; 2],
    /// So many times larger they were, as a power of two.
    by: i32,
}

impl<R: Real> Near<R> {
    /// Both brought near 1.
    #[cold]
    fn of(edges: [[Point; 2]; 2]) -> Self {
        let coordinates = edges.map(|edge| edge.map(Point::to_array));
        // One more, so that no difference overflows.
        let by = 1 + exponent(coordinates.as_flattened().as_flattened());
        let edges = edges.map(|edge| edge.map(|p| times(p, -by)));
        let [s, c] = edges;
        Self {
            edges,
            a: s.map(|p| R::new(side(c[0], c[1], p))),
            b: c.map(|p| R::new(side(s[0], s[1], p))),
            by,
        }
    }

    fn crossing(&self, along: List) -> Point {
        let [s, c] = self.edges;
        let at = match along {
            List::Subject => crossing(s, self.a, c),
            List::Clip => crossing(c, self.b, s),
        };
        if self.by == 0 { at } else { times(at, self.by) }
    }
}

/// Do distances, and products of coordinates and distances, keep all their bits?
fn are_plain<R: Real>(edges: [[Point; 2]; 2], distances: [[R; 2]; 2]) -> bool {
    let points = edges.as_flattened().iter();
    let largest = points.fold(0.0_f64, |most, p| most.max(p.x().abs()).max(p.y().abs()));
    distances.as_flattened().iter().all(|d| {
        let d = d.get().abs();
        d == 0.0 || PLAIN.contains(&d) && PLAIN.contains(&(largest * d))
    })
}

fn times(p: Point, exponent: i32) -> Point {
    let [x, y] = times_power(p.to_array(), exponent);
    Point::from_finite(x, y)
}

/// Edges on one line: the first end of either may lie on the other.
#[cold]
fn overlap(s: [Point; 2], c: [Point; 2]) -> [Option<Meeting>; 2] {
    let meeting = |contact, at| {
        let [t, u] = [s, c].map(|edge| along(edge, at));
        Meeting {
            contact,
            at,
            t,
            u,
            along: List::Subject,
            from_right: false,
        }
    };
    let within = |p: Point, [from, to]: [Point; 2]| {
        let [a, b] = [lexicographic(from, p), lexicographic(p, to)];
        a == b && a != Ordering::Equal
    };
    if s[0] == c[0] {
        return [Some(meeting(Contact::BothVertices, s[0])), None];
    }
    let at_subject = within(s[0], c).then(|| meeting(Contact::SubjectVertex, s[0]));
    let at_clip = within(c[0], s).then(|| meeting(Contact::ClipVertex, c[0]));
    [at_subject, at_clip]
}

/// The parameter of a point of an edge, by the axis along which the edge is longer.
fn along([from, to]: [Point; 2], at: Point) -> Ratio {
    let [from, to, at] = [from, to, at].map(|p| p.to_array().map(|x| 0.5 * x));
    let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
    let axis = usize::from(dy.abs() > dx.abs());
    Ratio {
        num: 2.0 * (at[axis] - from[axis]),
        den: 2.0 * [dx, dy][axis],
    }
}

/// Of two edges the lesser is averaged: an oblique one before one along an axis, whose border coordinate the answer is given
/// anyway; then the one that comes first on the left.
fn precedence([p, q]: [Point; 2]) -> (bool, [[f64; 2]; 2]) {
    let along_an_axis = p.x() == q.x() || p.y() == q.y();
    let ends = if lexicographic(p, q) == Ordering::Less {
        [p.to_array(), q.to_array()]
    } else {
        [q.to_array(), p.to_array()]
    };
    (along_an_axis, ends)
}

/// The common point of two edges that cross, by the ends of the one that [`precedence`] names and their distances from the other:
/// (s₁·|a₂| + s₂·|a₁|) / (|a₁| + |a₂|), kept within the boxes of both. Neither direction nor role changes a bit, and
/// where products and sums are exact it is the correctly rounded true point.
fn crossing<R: Real>(ends: [Point; 2], sides: [R; 2], other: [Point; 2]) -> Point {
    let [w1, w2] = if sides[0].get() < 0.0 {
        [-sides[0], sides[1]]
    } else {
        [sides[0], -sides[1]]
    };
    let whole = w1 + w2;
    let mean = |axis: fn(Point) -> f64| {
        let [o1, o2] = ends.map(|p| R::new(axis(p)));
        let largest = o1.get().abs().max(o2.get().abs());
        let mean = if largest == 0.0 {
            0.0
        } else if PLAIN.contains(&whole.get()) && PLAIN.contains(&(largest * whole.get())) {
            ((o1 * w2 + o2 * w1) / whole).get()
        } else {
            let [t1, t2] = [w1, w2].map(|w| (w / whole).get());
            o1.get() * t2 + o2.get() * t1
        };
        // Rounding may have put it beyond an end.
        let [e, o] = [ends, other].map(|edge| edge.map(axis));
        let low = e[0].min(e[1]).max(o[0].min(o[1]));
        let high = e[0].max(e[1]).min(o[0].max(o[1]));
        mean.max(low).min(high)
    };
    Point::from_finite(mean(Point::x), mean(Point::y))
}

/// Weights and products in this range keep all their bits.
const PLAIN: std::ops::RangeInclusive<f64> = 1e-270..=1e270;
