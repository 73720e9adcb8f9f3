//! One clipper against one border, vertex by vertex: what every form of Sutherland–Hodgman here is made of.
//!
//! ```text
//!            border
//!   outside    ┊    inside          from S, the vertex before, to P, this one:
//!              ┊  S ──► P           in → in    P
//!          P ◄─I─── S               in → out   I
//!          S ──I──► P               out → in   I, then P
//!   S ──► P    ┊                    out → out  nothing
//! ```
//!
//! A clipper holds the first vertex, which is put out if it is inside, and the one before. Of the edge that closes the ring only a crossing
//! is put out, as the first vertex already heads the list. An edge that only touches the border with its inside end has no crossing:
//! the other rules put that end out already.

use serde::Serialize;

use crate::{
    algo::parameter::Ratio,
    trace::{Real, Told},
};

/// What may be got wrong, known at compile time. The values given here are right; [`super::super::polygon::faulty`] has the others.
pub trait Rules: Copy {
    /// Is a vertex on the border inside?
    const BORDER_IS_INSIDE: bool = true;
    /// Is the edge from the last vertex to the first one clipped too?
    const CLOSES: bool = true;
    /// How many times a crossing is put out.
    const COPIES: usize = 1;
    /// Does P come before the crossing where an edge comes in?
    const END_FIRST: bool = false;
    /// Has an edge that only touches the border with its inside end a crossing there?
    const CUTS_ON_BORDER: bool = false;
    /// Are the clip edges walked clockwise, with the inside still to their left?
    const CLOCKWISE: bool = false;
}

/// As Sutherland and Hodgman have it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Right;

impl Rules for Right {}

/// What a ring is clipped against: the paper's limiting plane.
pub trait Limit<V>: Copy {
    /// Signed distance of a vertex: not below 0 inside.
    fn distance<R: Real>(&self, vertex: &V) -> R;

    /// Where an edge with one end strictly inside and one outside crosses; `None` where that rounds to the inside end.
    fn crossing<R: Real>(&self, ends: [&V; 2], distances: [R; 2]) -> Option<Crossing<V>>;

    /// The distance of a vertex as an event tells it: infinite where it is larger than any number.
    #[inline]
    fn told(&self, _vertex: &V, distance: f64) -> f64 {
        distance
    }

    /// Is a vertex inside, or on the border?
    #[inline]
    fn is_inside(&self, vertex: &V) -> bool {
        self.distance::<f64>(vertex) >= 0.0
    }

    /// Which of up to 64 vertices are inside: bit i is that of vertex i. Without a branch: nobody can guess where a ring turns.
    #[inline]
    fn inside(&self, vertices: &[V]) -> u64 {
        let put = |bits, vertex| bits << 1 | u64::from(self.is_inside(vertex));
        vertices.iter().rev().fold(0, put)
    }
}

/// Where an edge crosses a limit.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
pub struct Crossing<V> {
    /// On the border.
    pub at: V,
    /// The parameter, from the edge's first end to its second.
    pub t: Ratio,
}

/// What becomes of the edge from S to P.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Rule {
    /// Both inside: P is put out.
    InIn,
    /// It leaves: the crossing is put out.
    InOut,
    /// It comes in: the crossing, then P.
    OutIn,
    /// Both outside: nothing.
    OutOut,
}

impl Rule {
    #[inline]
    const fn of(is_from_inside: bool, is_to_inside: bool) -> Self {
        match (is_from_inside, is_to_inside) {
            (true, true) => Self::InIn,
            (true, false) => Self::InOut,
            (false, true) => Self::OutIn,
            (false, false) => Self::OutOut,
        }
    }

    /// Does the edge end inside?
    #[must_use]
    pub const fn ends_inside(self) -> bool {
        matches!(self, Self::InIn | Self::OutIn)
    }

    /// Does the edge begin inside?
    #[must_use]
    pub const fn starts_inside(self) -> bool {
        matches!(self, Self::InIn | Self::InOut)
    }

    /// Has the edge one end on either side?
    #[must_use]
    pub const fn changes_side(self) -> bool {
        matches!(self, Self::InOut | Self::OutIn)
    }
}

/// A vertex against the limit at work.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
pub struct Known<V> {
    /// The vertex.
    pub at: V,
    /// Its signed distance.
    pub distance: f64,
    /// Is it inside?
    pub inside: bool,
}

/// The edge from S to P, the last one closing the ring, against the limit at work.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
pub struct EdgeTest<V> {
    /// Where S and P stand in the list.
    pub idx: [usize; 2],
    /// S and P.
    pub ends: [V; 2],
    /// Their signed distances.
    pub distances: [f64; 2],
    /// What follows.
    pub rule: Rule,
}

impl<V> EdgeTest<V> {
    /// Are S and P inside?
    #[must_use]
    pub const fn inside(&self) -> [bool; 2] {
        [self.rule.starts_inside(), self.rule.ends_inside()]
    }
}

/// What a clipper does, in order.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Happening<V> {
    /// The first vertex is looked at.
    First(Known<V>),
    /// The edge from S to P is looked at.
    Test(EdgeTest<V>),
    /// The edge crosses the limit.
    Cross(Crossing<V>),
    /// A vertex is put out.
    Output(V),
}

impl<V: Copy> Known<V> {
    #[inline]
    fn find<L: Rules, R: Real>(limit: &impl Limit<V>, at: V) -> Self {
        let distance = limit.distance::<R>(&at);
        let zero = R::new(0.0);
        let inside = if L::BORDER_IS_INSIDE {
            distance >= zero
        } else {
            distance > zero
        };
        let distance = distance.get();
        Self {
            at,
            distance,
            inside,
        }
    }
}

/// What a clipper remembers: the first vertex, and the one before the next.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Clip<V> {
    first: Known<V>,
    previous: Known<V>,
}

impl<V: Copy> Clip<V> {
    /// Takes the first vertex.
    #[inline]
    pub fn begin<L: Rules, R: Real>(limit: &impl Limit<V>, vertex: V) -> Self {
        let first = Known::find::<L, R>(limit, vertex);
        Self {
            first,
            previous: first,
        }
    }

    /// Tells what becomes of the first vertex.
    #[inline]
    pub fn tell_first<S>(
        &self,
        limit: &impl Limit<V>,
        tell: &mut impl FnMut(Happening<V>) -> Told<S>,
    ) -> Told<S> {
        let first = self.first;
        let distance = limit.told(&first.at, first.distance);
        tell(Happening::First(Known { distance, ..first }))?;
        put_out(first.inside.then_some(first.at), 1, tell)
    }

    /// Takes the next vertex, which stands at `idx[1]` of the list, after the one at `idx[0]`.
    #[inline]
    pub fn vertex<L: Rules, R: Real, S>(
        &mut self,
        limit: &impl Limit<V>,
        (idx, vertex): ([usize; 2], V),
        tell: &mut impl FnMut(Happening<V>) -> Told<S>,
    ) -> Told<S> {
        let p = Known::find::<L, R>(limit, vertex);
        let (rule, crossing) = edge::<L, V, R, S>(limit, idx, [self.previous, p], tell)?;
        let end = rule.ends_inside().then_some(vertex);
        if L::END_FIRST {
            put_out(end, 1, tell)?;
            put_out(crossing, L::COPIES, tell)?;
        } else {
            put_out(crossing, L::COPIES, tell)?;
            put_out(end, 1, tell)?;
        }
        self.previous = p;
        Told::Continue(())
    }

    /// Goes on from `vertex`, which is on the same side as the one before the next.
    #[inline]
    pub fn go_to(&mut self, limit: &impl Limit<V>, vertex: V) {
        self.previous = Known::find::<Right, f64>(limit, vertex);
    }

    pub const fn first(&self) -> V {
        self.first.at
    }

    pub const fn previous(&self) -> V {
        self.previous.at
    }

    /// Is the vertex before the next one inside?
    #[inline]
    pub const fn is_inside(&self) -> bool {
        self.previous.inside
    }

    /// Closes the ring.
    #[inline]
    pub fn close<L: Rules, R: Real, S>(
        &mut self,
        limit: &impl Limit<V>,
        idx: [usize; 2],
        tell: &mut impl FnMut(Happening<V>) -> Told<S>,
    ) -> Told<S> {
        if L::CLOSES {
            let (_, crossing) = edge::<L, V, R, S>(limit, idx, [self.previous, self.first], tell)?;
            put_out(crossing, L::COPIES, tell)?;
            self.previous = self.first;
        }
        Told::Continue(())
    }
}

#[inline]
fn edge<L: Rules, V: Copy, R: Real, S>(
    limit: &impl Limit<V>,
    idx: [usize; 2],
    [s, p]: [Known<V>; 2],
    tell: &mut impl FnMut(Happening<V>) -> Told<S>,
) -> Told<S, (Rule, Option<V>)> {
    let rule = Rule::of(s.inside, p.inside);
    let distances = [s.distance, p.distance];
    tell(Happening::Test(EdgeTest {
        idx,
        ends: [s.at, p.at],
        distances: [limit.told(&s.at, s.distance), limit.told(&p.at, p.distance)],
        rule,
    }))?;
    let distances = distances.map(R::new);
    let crossing = if rule.changes_side() && crosses(distances) {
        limit.crossing([&s.at, &p.at], distances)
    } else {
        None
    };
    if let Some(crossing) = crossing {
        tell(Happening::Cross(crossing))?;
    }
    let touched = if p.inside { p.at } else { s.at };
    let touched = (L::CUTS_ON_BORDER && rule.changes_side()).then_some(touched);
    Told::Continue((rule, crossing.map(|crossing| crossing.at).or(touched)))
}

/// Has it an end strictly on either side? One of the ends is outside.
#[inline]
fn crosses<R: Real>([d1, d2]: [R; 2]) -> bool {
    let zero = R::new(0.0);
    if d1 > zero {
        d2 < zero
    } else {
        d1 < zero && d2 > zero
    }
}

#[inline]
fn put_out<V: Copy, S>(
    vertex: Option<V>,
    copies: usize,
    tell: &mut impl FnMut(Happening<V>) -> Told<S>,
) -> Told<S> {
    if let Some(vertex) = vertex {
        for _ in 0..copies {
            tell(Happening::Output(vertex))?;
        }
    }
    Told::Continue(())
}
