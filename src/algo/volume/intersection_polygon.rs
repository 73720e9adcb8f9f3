//! A triangle against planes, as one polygon: each plane clips it as Sutherland and Hodgman do, and it is cut into triangles, the
//! fan from its first vertex, when all planes have had their turn. Each plane adds one vertex at most, and n vertices make n − 2
//! triangles: never more than [`super::PlaneAtATime`] leaves, whose diagonals are cut again by later planes.
//!
//! *Exact*: on a plane across an axis the crossing's coordinate is assigned; triangles that share an edge share its crossings,
//! bit for bit; clipping again changes nothing. *Degenerate*: a triangle without area leaves none, nor does one that only
//! touches. *Cost*: three multiplications, three additions and a comparison a vertex and plane; for a crossing a mean of each
//! coordinate.
//!
//! *Source*: I. E. Sutherland and G. W. Hodgman, "Reentrant polygon clipping", Communications of the ACM 17, 1974, pp. 32–42.
//!
//! ```
//! use clipscope::{algo::volume::{IntersectionPolygon, SpaceVertex, TrianglePlanes}, geom::Plane, trace::silent};
//! let planes = vec![Plane::new([1.0, 0.0, 0.0, 0.0])?, Plane::new([0.0, 1.0, 0.0, 0.0])?];
//! let triangle = [[-1.0, 1.0, 0.0], [2.0, -2.0, 0.0], [2.0, 4.0, 0.0]].map(SpaceVertex::new);
//! let left = silent::<IntersectionPolygon>(&TrianglePlanes { planes, triangle });
//! // The edge from (−1, 1) to (2, −2) runs through the corner (0, 0).
//! assert_eq!(left.triangles.len(), 2);
//! assert_eq!(left.triangles[0][0].at, [0.0; 3]);
//! # Ok::<(), clipscope::geom::SpaceError>(())
//! ```

use std::marker::PhantomData;

use serde::Serialize;

use crate::{
    algo::ring::{Crossing, EdgeTest, Known, Lists, Right, RingClipper, clip_ring, ring_events},
    trace::{Method, Real, Tell, Told},
};

use super::{
    CutTriangles, SpaceVertex, TrianglePlanes, VolumeRules, has_area,
    space_vertex::{LastPlane, fan},
};

/// The algorithm, by the rules of `L`; see the module.
#[derive(Clone, Copy, Debug)]
pub struct IntersectionPolygon<L = Right>(PhantomData<L>);

/// What happens, in order.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum IntersectionPolygonEvent {
    /// The next plane's turn.
    Plane {
        /// As they were given.
        plane_idx: usize,
    },
    /// The first vertex of the input list.
    First(Known<SpaceVertex>),
    /// The edge from S to P, the last one closing the ring.
    Test(EdgeTest<SpaceVertex>),
    /// The edge crosses the plane.
    Cross(Crossing<SpaceVertex>),
    /// A vertex is appended to the output list.
    Output {
        /// F, P or I.
        at: SpaceVertex,
    },
    /// The output list becomes the input list.
    Pass {
        /// The plane that is done with.
        plane_idx: usize,
        /// How many vertices there are now.
        n_vertices: usize,
    },
    /// A triangle of the fan.
    Fan {
        /// Its corners, the polygon's first vertex among them.
        triangle: [SpaceVertex; 3],
    },
    /// Nothing is left to do.
    Done {
        /// How many triangles are left.
        n_triangles: usize,
    },
}

/// What it works in.
#[derive(Clone, PartialEq, Debug)]
pub struct IntersectionPolygonHeld {
    /// The list that is clipped, after the last plane the polygon; and the list that grows.
    pub lists: Lists<Vec<SpaceVertex>>,
    /// How many of the list belong together: one ring, or by a mistake three edges.
    paths: Vec<usize>,
    /// The fan as far as it goes, and what all has cost so far.
    pub left: CutTriangles,
}

impl<L: VolumeRules> Method for IntersectionPolygon<L> {
    type Input = TrianglePlanes;
    type Held = IntersectionPolygonHeld;
    type Output = CutTriangles;
    type Event = IntersectionPolygonEvent;

    #[inline]
    fn begin(input: &Self::Input) -> Self::Held {
        let [a, b, c] = input.triangle;
        let (list, paths) = if L::EDGE_BY_EDGE {
            (vec![a, b, b, c, c, a], vec![2; 3])
        } else {
            (vec![a, b, c], vec![3])
        };
        IntersectionPolygonHeld {
            lists: Lists::new([list, Vec::new()]),
            paths,
            left: CutTriangles {
                has_uv: input.has_uv(),
                ..CutTriangles::default()
            },
        }
    }

    #[inline]
    fn run<R: Real, T: Tell<Self>>(
        input: &Self::Input,
        held: &mut Self::Held,
        tell: &mut T,
    ) -> Told<T::Stop> {
        use IntersectionPolygonEvent as Event;
        if has_area(&input.triangle) {
            Self::clip_by_all::<R, T>(held, LastPlane::all(&input.planes), tell)?;
        }
        let triangles = if L::EDGE_BY_EDGE {
            fan(&joined(held.lists.list()))
        } else {
            fan(held.lists.list())
        };
        let n_triangles = triangles.len();
        held.left.triangles.reserve(n_triangles);
        for triangle in triangles {
            held.left.triangles.push(triangle);
            tell.tell(held, Event::Fan { triangle })?;
        }
        tell.tell(held, Event::Done { n_triangles })
    }

    #[inline]
    fn output(held: Self::Held) -> Self::Output {
        held.left
    }

    /// For each plane its turn; for each path, of which there are three at most, its first vertex, perhaps put out; for each edge
    /// a test, a crossing with its output, and an end; the pass. Then a triangle a vertex, and the end.
    fn max_events(input: &Self::Input) -> usize {
        let (mut n, mut total) = (6_usize, 1_usize);
        for _ in &input.planes {
            let clipped = n.saturating_mul(4).saturating_add(2 + 3 * 2);
            total = total.saturating_add(clipped);
            // Half of them inside, with a crossing on either side of each, is the most.
            n = n.saturating_mul(3) / 2;
        }
        total.saturating_add(n)
    }
}

impl<L: VolumeRules> RingClipper for IntersectionPolygon<L> {
    type Ring = Vec<SpaceVertex>;
    type Rules = L;
    type Limit<'a> = LastPlane<'a, L>;
    const FEWEST: usize = 3;

    #[inline]
    fn lists(held: &Self::Held) -> &Lists<Vec<SpaceVertex>> {
        &held.lists
    }

    #[inline]
    fn lists_mut(held: &mut Self::Held) -> &mut Lists<Vec<SpaceVertex>> {
        &mut held.lists
    }

    #[inline]
    fn crossed(held: &mut Self::Held) {
        held.left.n_crossings += 1;
    }

    #[inline]
    fn turn(plane: &LastPlane<'_, L>) -> Self::Event {
        let plane_idx = plane.idx();
        IntersectionPolygonEvent::Plane { plane_idx }
    }

    #[inline]
    fn passed(plane: &LastPlane<'_, L>, n_vertices: usize) -> Self::Event {
        IntersectionPolygonEvent::Pass {
            plane_idx: plane.idx(),
            n_vertices,
        }
    }

    /// Each path by itself.
    #[inline]
    fn clip<R: Real, T: Tell<Self>>(
        held: &mut Self::Held,
        plane: &LastPlane<'_, L>,
        tell: &mut T,
    ) -> Told<T::Stop> {
        let mut start = 0;
        for i in 0..held.paths.len() {
            let end = start + held.paths[i];
            let n_before = held.lists.other().len();
            clip_ring::<Self, R, T>(held, start..end, plane, tell)?;
            held.paths[i] = held.lists.other().len() - n_before;
            start = end;
        }
        Told::Continue(())
    }
}

ring_events!([] IntersectionPolygonEvent, SpaceVertex, between: Plane | Pass | Fan | Done);

/// Takes the ends of edges that meet for one vertex.
fn joined(list: &[SpaceVertex]) -> Vec<SpaceVertex> {
    let mut ring = list.to_vec();
    ring.dedup_by_key(|vertex| vertex.at);
    while ring.len() > 1 && ring.first().map(|v| v.at) == ring.last().map(|v| v.at) {
        ring.pop();
    }
    ring
}
