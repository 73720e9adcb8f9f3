//! Sutherland–Hodgman: clip the whole polygon against one edge of the region, then what is left against the next.
//!
//! ```text
//!        ╱╲              ╱╲               ┊               one clip edge at a time:
//!   ┌───╱──╲───┐        ╱  ╲              ┊ ╲
//!   │  ╱    ╲  │  ──►  ╱____╲   ──►  ──►  ┊__╲    ──► …   the output list of one is the
//!   └─╱──────╲─┘      ┄┄┄┄┄┄┄             ┊               input list of the next
//! ```
//!
//! 1. For each clip edge: put out the first vertex F if it is inside.
//! 2. For each following vertex P, with S the one before, put out: P if both are inside; the crossing I if only S is; I and P if only P
//!    is; nothing if neither is.
//! 3. For the edge that closes the ring, put out its crossing, if any.
//!
//! A crossing is the weighted mean of both ends, (S·|d_P| + P·|d_S|) / (|d_S| + |d_P|), and so is whatever goes with the vertices. An end
//! on the border is its own crossing, and not put out twice. There is one ring of output: where a concave polygon falls apart, its
//! pieces stay joined by *bridges*, edges along the border, walked there and back.
//!
//! *Conventions*: closed, convex region; vertices come out in the order of the input, of either winding. *Degenerate*: [`RingOutcome`];
//! repeated and collinear vertices are kept; clipping again changes nothing. *Exact* against a window, up to the crossings' free
//! coordinates; within a rounding of an oblique edge a vertex may fall on either side, and a polygon that touches it may keep a sliver.
//! *Bound*: at each clip edge n vertices become at most ⌊3n/2⌋, as each that is inside lies between at most two crossings. *Cost* a
//! vertex and upright clip edge: 1 + and 1 comparison; a crossing: 3 +, 2 × and 1 ÷ more, and 5 or so comparisons.
//!
//! *Source*: I. E. Sutherland and G. W. Hodgman, "Reentrant Polygon Clipping", Communications of the ACM 17(1), 1974, pp. 32–42,
//! doi:10.1145/360767.360802.
//!
//! ```
//! use clipscope::{algo::polygon::{RingOutcome, SutherlandHodgman, SutherlandHodgmanInput}, geom::{Polygon, Window}, trace::silent};
//! let region = Window::new(-1.0, -1.0, 1.0, 1.0)?.into();
//! let polygon = Polygon::new(&[[0.0, 0.0], [2.0, 0.0], [0.0, 2.0]])?;
//! let ring = silent::<SutherlandHodgman>(&SutherlandHodgmanInput::new(region, &polygon));
//! assert_eq!(ring.outcome, RingOutcome::Cut);
//! assert_eq!(ring.polygon(), Some(Polygon::new(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])?));
//! # Ok::<(), clipscope::geom::GeomError>(())
//! ```

use std::marker::PhantomData;

use serde::Serialize;

use crate::{
    geom::{Point, Polygon},
    trace::{Method, Real, Tell, Told},
};

use super::{
    super::ring::{Crossing, EdgeTest, Known, Lists, Right, RingClipper, Rules, ring_events},
    ClipRegion, ClippedRing, RingOutcome, Vertex,
    border::{Borders, NthBorder},
};

/// The algorithm, on vertices of kind `V` and by the rules of `L`; see the module.
#[derive(Clone, Copy, Debug)]
pub struct SutherlandHodgman<V = Point, L = Right>(PhantomData<(V, L)>);

/// What to clip, and against what.
#[derive(Clone, PartialEq, Debug)]
pub struct SutherlandHodgmanInput<V = Point> {
    /// Closed and convex.
    pub region: ClipRegion,
    /// A ring of any shape; the last vertex is joined to the first.
    pub vertices: Vec<V>,
}

impl SutherlandHodgmanInput {
    /// The corners of a polygon, and nothing with them.
    #[must_use]
    pub fn new(region: ClipRegion, polygon: &Polygon) -> Self {
        let vertices = polygon.vertices().to_vec();
        Self { region, vertices }
    }
}

/// What happens, in order.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum SutherlandHodgmanEvent<V> {
    /// The next clip edge's turn.
    Edge {
        /// As the region numbers them.
        edge_idx: usize,
        /// n, pointing inside; of length 1 along an axis only.
        normal: [f64; 2],
        /// E, a point of the clip edge.
        origin: Point,
    },
    /// The first vertex of the input list.
    First(Known<V>),
    /// The edge from S to P, the last one closing the ring.
    Test(EdgeTest<V>),
    /// The edge crosses the clip edge.
    Cross(Crossing<V>),
    /// A vertex is appended to the output list.
    Output {
        /// F, P or I.
        at: V,
    },
    /// The output list becomes the input list.
    Pass {
        /// The clip edge that is done with.
        edge_idx: usize,
        /// How many vertices there are now.
        n_vertices: usize,
    },
    /// No clip edge is left to do, or no vertex.
    Done {
        /// What it comes to.
        outcome: RingOutcome,
    },
}

/// What it works in.
#[derive(Clone, PartialEq, Debug)]
pub struct SutherlandHodgmanHeld<V> {
    /// The list that is clipped, and the one that grows.
    pub lists: Lists<Vec<V>>,
    outcome: RingOutcome,
}

impl<V: Vertex, L: Rules> Method for SutherlandHodgman<V, L> {
    type Input = SutherlandHodgmanInput<V>;
    type Held = SutherlandHodgmanHeld<V>;
    type Output = ClippedRing<V>;
    type Event = SutherlandHodgmanEvent<V>;

    #[inline]
    fn begin(input: &Self::Input) -> Self::Held {
        SutherlandHodgmanHeld {
            lists: Lists::new([input.vertices.clone(), Vec::new()]),
            outcome: RingOutcome::Empty,
        }
    }

    #[inline]
    fn run<R: Real, T: Tell<Self>>(
        input: &Self::Input,
        held: &mut Self::Held,
        tell: &mut T,
    ) -> Told<T::Stop> {
        let borders = &Borders::by::<L>(&input.region);
        let limits = (0..borders.all().len()).map(|idx| NthBorder { borders, idx });
        Self::clip_by_all::<R, T>(held, limits, tell)?;
        let outcome = RingOutcome::of(&input.vertices, held.lists.list());
        held.outcome = outcome;
        tell.tell(held, SutherlandHodgmanEvent::Done { outcome })
    }

    #[inline]
    fn output(held: Self::Held) -> Self::Output {
        ClippedRing {
            outcome: held.outcome,
            vertices: held.lists.into_list(),
        }
    }

    /// For each clip edge: its turn; the first vertex; for each edge a test, a crossing with copies, an end; the pass. Then the verdict.
    fn max_events(input: &Self::Input) -> usize {
        let per_edge = 3 + L::COPIES;
        let (mut n, mut total) = (input.vertices.len(), 1_usize);
        for _ in 0..input.region.n_edges() {
            total = n
                .saturating_mul(per_edge)
                .saturating_add(4)
                .saturating_add(total);
            // Half of them inside, with a crossing on either side of each, is the most.
            n = n.saturating_mul(2 * L::COPIES + 1) / 2;
        }
        total
    }
}

impl<V: Vertex, L: Rules> RingClipper for SutherlandHodgman<V, L> {
    type Ring = Vec<V>;
    type Rules = L;
    type Limit<'a> = NthBorder<'a>;

    #[inline]
    fn lists(held: &Self::Held) -> &Lists<Vec<V>> {
        &held.lists
    }

    #[inline]
    fn lists_mut(held: &mut Self::Held) -> &mut Lists<Vec<V>> {
        &mut held.lists
    }

    #[inline]
    fn turn(limit: &NthBorder<'_>) -> Self::Event {
        let border = limit.border();
        SutherlandHodgmanEvent::Edge {
            edge_idx: border.edge_idx(),
            normal: border.normal(),
            origin: border.origin(),
        }
    }

    #[inline]
    fn passed(limit: &NthBorder<'_>, n_vertices: usize) -> Self::Event {
        SutherlandHodgmanEvent::Pass {
            edge_idx: limit.border().edge_idx(),
            n_vertices,
        }
    }
}

ring_events!([V: Copy] SutherlandHodgmanEvent<V>, V, between: Edge | Pass | Done);
