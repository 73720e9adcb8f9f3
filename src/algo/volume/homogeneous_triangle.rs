//! A triangle against the clip volume −w ≤ x, y, z ≤ w, before anything is divided by w. Codes first: OR = 0 keeps it whole, AND
//! ≠ 0 leaves nothing. Else it is clipped as Sutherland and Hodgman do, by those sides that a code names: one convex polygon of
//! at most nine vertices.
//!
//! *Exact*: signs of w ± x; a clipped coordinate is assigned (x = w, bit for bit); triangles that share an edge share its cuts,
//! bit for bit, and a cut stays inside every side that both ends of its edge are inside of. *Cost*: six comparisons a vertex; a
//! side costs an addition and a comparison a vertex, a crossing a mean for each coordinate but one and for each attribute.
//!
//! *Source*: J. F. Blinn and M. E. Newell, "Clipping using homogeneous coordinates", SIGGRAPH 1978, pp. 245–251.
//!
//! ```
//! use clipscope::{algo::volume::{ClipVertex, HomogeneousTriangle}, trace::silent};
//! // One vertex behind the eye.
//! let at = |at| ClipVertex { at, attributes: () };
//! let triangle = [at([0.0, 0.0, 0.0, 1.0]), at([4.0, 0.0, 0.0, 1.0]), at([0.0, 2.0, 0.0, -1.0])];
//! let polygon = silent::<HomogeneousTriangle>(&triangle);
//! assert!(polygon.vertices().iter().all(|v| v.at[3] > 0.0));
//! ```

use std::marker::PhantomData;

use serde::Serialize;

use crate::{
    algo::ring::{Crossing, EdgeTest, Known, Lists, Right, Ring, RingClipper, ring_events},
    geom::VolumeSide,
    trace::{Method, Real, Tell, Told},
};

use super::{
    VolumeRules,
    clip_vertex::{Attributes, ClipPolygon, ClipVertex, divided},
    side_code::SideCode,
};

/// The algorithm, on vertices with attributes `A` and by the rules of `L`; see the module.
#[derive(Clone, Copy, Debug)]
pub struct HomogeneousTriangle<A = (), L = Right>(PhantomData<(A, L)>);

/// What happens, in order.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum HomogeneousTriangleEvent<A> {
    /// By a mistake: the vertices are divided by w before anything is clipped.
    Divide {
        /// What comes of them.
        triangle: [ClipVertex<A>; 3],
    },
    /// The vertices' codes.
    Codes {
        /// Of each vertex.
        codes: [SideCode; 3],
        /// Of all three: the sides that clip.
        or: SideCode,
        /// Of all three: a side that all lie beyond.
        and: SideCode,
    },
    /// The next side's turn.
    Side {
        /// That a code names.
        side: VolumeSide,
    },
    /// The first vertex of the input list.
    First(Known<ClipVertex<A>>),
    /// The edge from S to P, the last one closing the ring.
    Test(EdgeTest<ClipVertex<A>>),
    /// The edge crosses the side.
    Cross(Crossing<ClipVertex<A>>),
    /// A vertex is appended to the output list.
    Output {
        /// F, P or I.
        at: ClipVertex<A>,
    },
    /// The output list becomes the input list.
    Pass {
        /// The side that is done with.
        side: VolumeSide,
        /// How many vertices there are now.
        n_vertices: usize,
    },
    /// No side is left to do, or no vertex.
    Done {
        /// How many vertices are left.
        n_vertices: usize,
    },
}

impl<A: Attributes, L: VolumeRules> Method for HomogeneousTriangle<A, L> {
    type Input = [ClipVertex<A>; 3];
    type Held = Lists<ClipPolygon<A>>;
    type Output = ClipPolygon<A>;
    type Event = HomogeneousTriangleEvent<A>;

    #[inline]
    fn begin(triangle: &Self::Input) -> Self::Held {
        let polygon = ClipPolygon::of(triangle);
        Lists::new([polygon, polygon.emptied()])
    }

    #[inline]
    fn run<R: Real, T: Tell<Self>>(
        triangle: &Self::Input,
        held: &mut Self::Held,
        tell: &mut T,
    ) -> Told<T::Stop> {
        use HomogeneousTriangleEvent as Event;
        let by_mistake;
        let triangle = if L::DIVIDES_FIRST {
            by_mistake = triangle.map(|v| ClipVertex {
                at: divided::<R>(v.at),
                ..v
            });
            *held = Self::begin(&by_mistake);
            let triangle = by_mistake;
            tell.tell(held, Event::Divide { triangle })?;
            &by_mistake
        } else {
            triangle
        };
        let codes = triangle.each_ref().map(|v| SideCode::of(v.at.map(R::new)));
        let [a, b, c] = codes;
        let (or, and) = (a.or(b).or(c), a.and(b).and(c));
        tell.tell(held, Event::Codes { codes, or, and })?;
        if L::ASKS_CODES && !and.is_inside() {
            held.list_mut().clear();
        } else {
            Self::clip_by_sides::<R, T>(or, held, tell)?;
        }
        let n_vertices = held.list().vertices().len();
        tell.tell(held, Event::Done { n_vertices })
    }

    #[inline]
    fn output(held: Self::Held) -> Self::Output {
        held.into_list()
    }

    /// A division by mistake, codes and end; for each of six sides its turn, the first vertex with its output, three events and as many copies of
    /// the crossing as there are for each of at most nine edges, and the pass.
    fn max_events(_: &Self::Input) -> usize {
        3 + 6 * (4 + ClipPolygon::<A>::MAX_VERTICES * (3 + L::COPIES))
    }
}

impl<A: Attributes, L: VolumeRules> HomogeneousTriangle<A, L> {
    /// By one side after the other of those that are named.
    #[inline]
    fn clip_by_sides<R: Real, T: Tell<Self>>(
        named: SideCode,
        held: &mut Lists<ClipPolygon<A>>,
        tell: &mut T,
    ) -> Told<T::Stop> {
        let is_named = |side: &VolumeSide| !L::ASKS_CODES || named.has(*side);
        let sides = VolumeSide::ALL.into_iter().filter(is_named);
        Self::clip_by_all::<R, T>(held, sides, tell)
    }
}

impl<A: Attributes, L: VolumeRules> RingClipper for HomogeneousTriangle<A, L> {
    type Ring = ClipPolygon<A>;
    type Rules = L;
    type Limit<'a> = VolumeSide;

    #[inline]
    fn lists(held: &Self::Held) -> &Lists<ClipPolygon<A>> {
        held
    }

    #[inline]
    fn lists_mut(held: &mut Self::Held) -> &mut Lists<ClipPolygon<A>> {
        held
    }

    #[inline]
    fn turn(&side: &VolumeSide) -> Self::Event {
        HomogeneousTriangleEvent::Side { side }
    }

    #[inline]
    fn passed(&side: &VolumeSide, n_vertices: usize) -> Self::Event {
        HomogeneousTriangleEvent::Pass { side, n_vertices }
    }
}

ring_events!([A: Copy] HomogeneousTriangleEvent<A>, ClipVertex<A>, between: Divide | Codes | Side | Pass | Done);
