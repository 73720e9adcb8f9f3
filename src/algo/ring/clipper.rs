//! Clippers that hold a ring as two lists and clip it against one limit after the other, each told step by step: the same loop
//! whatever the limits are, edges of a window or of a polygon, planes, or the sides of clip space.

use std::ops::Range;

use crate::trace::{Method, Real, Tell, Told};

use super::{Clip, Happening, Limit, Rules};

/// A list of vertices that can grow.
pub trait Ring {
    /// What it is made of.
    type Vertex: Copy;

    /// In order.
    fn vertices(&self) -> &[Self::Vertex];

    /// Appends a vertex.
    fn push(&mut self, vertex: Self::Vertex);

    /// Appends vertices.
    #[inline]
    fn append(&mut self, vertices: &[Self::Vertex]) {
        for &vertex in vertices {
            self.push(vertex);
        }
    }

    /// Takes all vertices away.
    fn clear(&mut self);
}

impl<V: Copy> Ring for Vec<V> {
    type Vertex = V;

    #[inline]
    fn vertices(&self) -> &[V] {
        self
    }

    #[inline]
    fn push(&mut self, vertex: V) {
        self.push(vertex);
    }

    #[inline]
    fn append(&mut self, vertices: &[V]) {
        self.extend_from_slice(vertices);
    }

    #[inline]
    fn clear(&mut self) {
        self.clear();
    }
}

/// Two lists that change places: the one that is clipped and the one that grows.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Lists<P> {
    pub(super) pair: [P; 2],
    pub(super) n_passed: usize,
}

impl<P> Lists<P> {
    #[inline]
    pub(in crate::algo) const fn new(pair: [P; 2]) -> Self {
        let n_passed = 0;
        Self { pair, n_passed }
    }

    /// The list that is clipped; after the end, the answer.
    #[inline]
    #[must_use]
    pub const fn list(&self) -> &P {
        &self.pair[self.n_passed % 2]
    }

    /// The other one: it grows while a limit clips, and is the one that was clipped once the limit is done with.
    #[inline]
    #[must_use]
    pub const fn other(&self) -> &P {
        &self.pair[(self.n_passed + 1) % 2]
    }

    /// How many limits are done with.
    #[must_use]
    pub const fn n_passed(&self) -> usize {
        self.n_passed
    }

    #[inline]
    pub(in crate::algo) const fn list_mut(&mut self) -> &mut P {
        &mut self.pair[self.n_passed % 2]
    }

    #[inline]
    const fn other_mut(&mut self) -> &mut P {
        &mut self.pair[(self.n_passed + 1) % 2]
    }

    #[inline]
    pub(in crate::algo) fn into_list(self) -> P {
        let [first, second] = self.pair;
        if self.n_passed.is_multiple_of(2) {
            first
        } else {
            second
        }
    }
}

type VertexOf<M> = <<M as RingClipper>::Ring as Ring>::Vertex;

/// A clipper of rings.
pub trait RingClipper: Method<Event: From<Happening<VertexOf<Self>>>> {
    type Ring: Ring;
    type Rules: Rules;
    type Limit<'a>: Limit<VertexOf<Self>>;
    /// Of a shorter list nothing is left to clip.
    const FEWEST: usize = 1;

    fn lists(held: &Self::Held) -> &Lists<Self::Ring>;

    fn lists_mut(held: &mut Self::Held) -> &mut Lists<Self::Ring>;

    /// An edge crosses the limit.
    fn crossed(_: &mut Self::Held) {}

    fn turn(limit: &Self::Limit<'_>) -> Self::Event;

    /// The limit is done with, and so many vertices are left.
    fn passed(limit: &Self::Limit<'_>, n_vertices: usize) -> Self::Event;

    /// Clips the list against one limit.
    #[inline]
    fn clip<R: Real, T: Tell<Self>>(
        held: &mut Self::Held,
        limit: &Self::Limit<'_>,
        tell: &mut T,
    ) -> Told<T::Stop> {
        let ring = 0..Self::lists(held).list().vertices().len();
        clip_ring::<Self, R, T>(held, ring, limit, tell)
    }

    /// Clips the list against one limit after the other.
    #[inline]
    fn clip_by_all<'a, R: Real, T: Tell<Self>>(
        held: &mut Self::Held,
        limits: impl Iterator<Item = Self::Limit<'a>>,
        tell: &mut T,
    ) -> Told<T::Stop> {
        for limit in limits {
            if Self::lists(held).list().vertices().len() < Self::FEWEST {
                break;
            }
            Self::lists_mut(held).other_mut().clear();
            tell.tell(held, Self::turn(&limit))?;
            Self::clip::<R, T>(held, &limit, tell)?;
            let lists = Self::lists_mut(held);
            lists.n_passed += 1;
            let n_vertices = lists.list().vertices().len();
            tell.tell(held, Self::passed(&limit, n_vertices))?;
        }
        Told::Continue(())
    }
}

/// Clips a part of the list, which is a ring, against one limit.
#[inline]
pub fn clip_ring<M: RingClipper, R: Real, T: Tell<M>>(
    held: &mut M::Held,
    ring: Range<usize>,
    limit: &M::Limit<'_>,
    tell: &mut T,
) -> Told<T::Stop> {
    if ring.is_empty() {
        return Told::Continue(());
    }
    let vertex = |held: &M::Held, i: usize| M::lists(held).list().vertices()[i];
    let mut note = |held: &mut M::Held, happening: Happening<VertexOf<M>>| {
        match happening {
            Happening::Output(at) => M::lists_mut(held).other_mut().push(at),
            Happening::Cross(_) => M::crossed(held),
            Happening::First(_) | Happening::Test(_) => {}
        }
        tell.tell(held, M::Event::from(happening))
    };
    let first = vertex(held, ring.start);
    let mut clip = Clip::begin::<M::Rules, R>(limit, first);
    clip.tell_first(limit, &mut |happening| note(held, happening))?;
    for i in ring.start + 1..ring.end {
        let vertex = ([i - 1, i], vertex(held, i));
        clip.vertex::<M::Rules, R, _>(limit, vertex, &mut |happening| note(held, happening))?;
    }
    let idx = [ring.end - 1, ring.start];
    clip.close::<M::Rules, R, _>(limit, idx, &mut |happening| note(held, happening))
}

/// An event of a clipper of rings: what happens to a vertex or an edge, or something between limits.
pub trait RingEvent<V> {
    /// What happens to a vertex or an edge; none between limits.
    fn happening(&self) -> Option<Happening<V>>;
}

/// Writes both ways between a [`Happening`] and an enum of events that has the variants `First`, `Test`, `Cross` and `Output`.
macro_rules! ring_events {
    ([$($generics:tt)*] $Event:ty, $V:ty, between: $($between:ident)|+) => {
        impl<$($generics)*> From<$crate::algo::ring::Happening<$V>> for $Event {
            #[inline]
            fn from(happening: $crate::algo::ring::Happening<$V>) -> Self {
                use $crate::algo::ring::Happening;
                match happening {
                    Happening::First(first) => Self::First(first),
                    Happening::Test(test) => Self::Test(test),
                    Happening::Cross(crossing) => Self::Cross(crossing),
                    Happening::Output(at) => Self::Output { at },
                }
            }
        }

        impl<$($generics)*> $crate::algo::ring::RingEvent<$V> for $Event {
            fn happening(&self) -> Option<$crate::algo::ring::Happening<$V>> {
                use $crate::algo::ring::Happening;
                Some(match *self {
                    Self::First(first) => Happening::First(first),
                    Self::Test(test) => Happening::Test(test),
                    Self::Cross(crossing) => Happening::Cross(crossing),
                    Self::Output { at } => Happening::Output(at),
                    $(Self::$between { .. })|+ => return None,
                })
            }
        }
    };
}

pub(in crate::algo) use ring_events;
