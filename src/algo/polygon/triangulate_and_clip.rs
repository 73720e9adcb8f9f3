//! Triangulate, then clip: a concave polygon leaves its pieces without bridges when every triangle of it is
//! clipped on its own.
//!
//! ```text
//!     ┌────────────────┐        a U reaches into a window          ┌──┐      ┌──┐
//!     │ ┌──┐      ┌──┐ │                                           │  │      │  │
//!     │ │  │      │  │ │        Sutherland–Hodgman leaves one      └──┴══════┴──┘
//!     └─┼──┼──────┼──┼─┘        ring, with a bridge ══
//!       │  └──────┘  │
//!       │            │          triangle by triangle there are     ┌──┐      ┌──┐
//!       └────────────┘          convex pieces, and no bridge       │ ╲│      │╱ │
//!                                                                  └──┘      └──┘
//! ```
//!
//! 1. Cut the polygon into triangles: [`EarClipping`].
//! 2. Clip each triangle against the region: [`SutherlandHodgman`]. What is left of a convex polygon in a convex
//!    region is convex: one piece, or none. A triangle that only touches the region leaves none, but for what rounding leaves
//!    ([`Pieces::rings`]).
//!
//! The pieces together are the polygon's part in the region. Two of them that meet along a diagonal share it bit
//! for bit, as both triangles do and as a crossing belongs to its edge: [`Pieces::outline`] takes such edges out
//! and leaves what surrounds the pieces when they are merged.
//!
//! *Conventions*, *degenerate*, *exact*: as in the two. *Bound*: the events of one run of ear clipping, and of
//! n − 2 runs of Sutherland–Hodgman on three vertices, with two more for each. *Cost*: the sum of both.
//!
//! *Source*: splitting a concave polygon and clipping its convex parts one by one is the remedy in D. Hearn and
//! M. P. Baker, *Computer Graphics, C Version*, 2nd edition, 1997, section 6-8.
//!
//! ```
//! use clipscope::{
//!     algo::polygon::{TriangulateAndClip, TriangulateAndClipInput},
//!     geom::{SimplePolygon, Window},
//!     trace::silent,
//! };
//! let v_shape = SimplePolygon::new(&[[0.0, 4.0], [2.0, 0.0], [4.0, 4.0], [2.0, 2.0]])?;
//! let window = Window::new(0.0, 3.0, 4.0, 5.0)?;
//! let pieces = silent::<TriangulateAndClip>(&TriangulateAndClipInput { region: window.into(), polygon: v_shape });
//! let rings: Vec<Vec<[f64; 2]>> = pieces.rings().map(|ring| ring.iter().map(|p| p.to_array()).collect()).collect();
//! assert_eq!(rings, [[[1.0, 3.0], [0.0, 4.0], [0.5, 3.0]], [[3.5, 3.0], [4.0, 4.0], [3.0, 3.0]]]);
//! # Ok::<(), clipscope::geom::GeomError>(())
//! ```

use std::{
    collections::{HashMap, HashSet},
    convert::Infallible,
};

use serde::Serialize;

use crate::{
    geom::{Point, Segment, SimplePolygon},
    trace::{
        Algorithm, Real,
        told::{Listening, Method, Told},
    },
};

use super::{
    ClipRegion, ClippedRing, EarClipping, EarClippingEvent, RingOutcome, SutherlandHodgman,
    SutherlandHodgmanEvent, SutherlandHodgmanInput, SutherlandHodgmanState, Triangle,
    Triangulation, ear_clipping::order_of,
};

/// The algorithm; see the module.
#[derive(Clone, Copy, Debug)]
pub struct TriangulateAndClip;

/// What to clip, and against what.
#[derive(Clone, PartialEq, Debug)]
pub struct TriangulateAndClipInput {
    /// Closed and convex.
    pub region: ClipRegion,
    /// Convex or not.
    pub polygon: SimplePolygon,
}

/// What happens, in order.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
#[serde(tag = "phase", rename_all = "kebab-case")]
pub enum TriangulateAndClipEvent {
    /// While the polygon is cut into triangles.
    Triangulate(EarClippingEvent),
    /// Between them.
    Each(EachTriangleEvent),
    /// While a triangle is clipped.
    Clip(SutherlandHodgmanEvent<Point>),
}

/// What happens before and after each triangle.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum EachTriangleEvent {
    /// The next triangle's turn.
    Triangle {
        /// In the order in which they were cut off.
        triangle_idx: usize,
        /// Its vertices' numbers.
        triangle: Triangle,
        /// Where they are.
        corners: [Point; 3],
    },
    /// What is left of it.
    Piece {
        /// Which triangle.
        triangle_idx: usize,
        /// A piece where `Whole` or `Cut`, else none.
        outcome: RingOutcome,
    },
    /// No triangle is left to do.
    Finish {
        /// How many pieces there are.
        n_pieces: usize,
    },
}

/// Convex polygons that overlap nowhere, one after the other.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Pieces {
    vertices: Vec<Point>,
    ends: Vec<usize>,
    triangles: Vec<usize>,
}

/// What the picture of a step needs.
#[derive(Clone, PartialEq, Debug)]
pub struct TriangulateAndClipState {
    /// The triangulation, as far as it has come.
    pub ears: EarsSoFar,
    /// Each triangle is clipped against this.
    pub region: ClipRegion,
    /// The triangle that is clipped, or was clipped last.
    pub triangle_idx: Option<usize>,
    /// How far that has come.
    pub clip: Option<SutherlandHodgmanState<Point>>,
    /// Those of the triangles before.
    pub pieces: Pieces,
    /// Are all triangles done?
    pub is_done: bool,
}

/// A polygon that is cut into triangles, and how far that has come.
#[derive(Clone, PartialEq, Debug)]
pub struct EarsSoFar {
    /// The polygon.
    pub polygon: SimplePolygon,
    /// How many events that is.
    pub n_steps: usize,
    /// What has been cut off.
    pub cut_off: Triangulation,
}

impl Algorithm for TriangulateAndClip {
    type Input = TriangulateAndClipInput;
    type Output = Pieces;
    type Event = TriangulateAndClipEvent;
    type State = TriangulateAndClipState;

    fn run<R: Real>(input: &Self::Input, mut emit: impl FnMut(Self::Event)) -> Pieces {
        use EachTriangleEvent::{Finish, Piece, Triangle};
        use TriangulateAndClipEvent as Event;
        let mut ears = EarClipping::begin(&input.polygon);
        let mut telling = Listening(|_: &_, event| {
            emit(Event::Triangulate(event));
            Told::<Infallible>::Continue(())
        });
        let Told::Continue(()) = EarClipping::run::<R, _>(&input.polygon, &mut ears, &mut telling);
        let whole = EarClipping::output(ears);
        let mut pieces = Pieces::default();
        for (triangle_idx, &triangle) in whole.triangles().iter().enumerate() {
            let corners = whole.corners(triangle);
            emit(Event::Each(Triangle {
                triangle_idx,
                triangle,
                corners,
            }));
            let problem = one_triangle(&input.region, corners);
            let ring = <SutherlandHodgman>::run::<R>(&problem, |e| emit(Event::Clip(e)));
            let outcome = ring.outcome;
            pieces.push(triangle_idx, &ring);
            emit(Event::Each(Piece {
                triangle_idx,
                outcome,
            }));
        }
        let n_pieces = pieces.len();
        emit(Event::Each(Finish { n_pieces }));
        pieces
    }

    fn start(input: &Self::Input) -> Self::State {
        TriangulateAndClipState {
            ears: EarsSoFar {
                polygon: input.polygon.clone(),
                n_steps: 0,
                cut_off: Triangulation::new(&input.polygon, &order_of(&input.polygon)),
            },
            region: input.region.clone(),
            triangle_idx: None,
            clip: None,
            pieces: Pieces::default(),
            is_done: false,
        }
    }

    fn apply(state: &mut Self::State, event: Self::Event) {
        use EachTriangleEvent::{Finish, Piece, Triangle};
        use TriangulateAndClipEvent as Event;
        match event {
            Event::Triangulate(event) => {
                state.ears.n_steps += 1;
                if let EarClippingEvent::Cut { triangle, .. }
                | EarClippingEvent::Last { triangle } = event
                {
                    state.ears.cut_off.push(triangle);
                }
            }
            Event::Clip(event) => {
                if let Some(clip) = &mut state.clip {
                    <SutherlandHodgman>::apply(clip, event);
                }
            }
            Event::Each(Triangle {
                triangle_idx,
                corners,
                ..
            }) => {
                let problem = one_triangle(&state.region, corners);
                state.triangle_idx = Some(triangle_idx);
                state.clip = Some(<SutherlandHodgman>::start(&problem));
            }
            Event::Each(Piece { triangle_idx, .. }) => {
                if let Some(clip) = &state.clip {
                    let ring = <SutherlandHodgman>::finish(clip);
                    state.pieces.push(triangle_idx, &ring);
                }
            }
            Event::Each(Finish { .. }) => {
                (state.triangle_idx, state.clip) = (None, None);
                state.is_done = true;
            }
        }
    }

    fn finish(state: &Self::State) -> Pieces {
        state.pieces.clone()
    }

    /// Those of the triangulation; for each triangle its turn, its clipping and its piece; the end.
    fn max_events(input: &Self::Input) -> usize {
        let n_triangles = input.polygon.vertices().len() - 2;
        let corner = input.polygon.vertices()[0];
        let problem = one_triangle(&input.region, [corner; 3]);
        let per_triangle = <SutherlandHodgman>::max_events(&problem).saturating_add(2);
        EarClipping::max_events(&input.polygon)
            .saturating_add(per_triangle.saturating_mul(n_triangles))
            .saturating_add(1)
    }
}

fn one_triangle(region: &ClipRegion, corners: [Point; 3]) -> SutherlandHodgmanInput {
    SutherlandHodgmanInput {
        region: region.clone(),
        vertices: corners.to_vec(),
    }
}

impl Pieces {
    fn push(&mut self, triangle_idx: usize, ring: &ClippedRing<Point>) {
        if matches!(ring.outcome, RingOutcome::Whole | RingOutcome::Cut) {
            self.vertices.extend(&ring.vertices);
            self.ends.push(self.vertices.len());
            self.triangles.push(triangle_idx);
        }
    }

    /// How many there are.
    #[must_use]
    pub const fn len(&self) -> usize {
        self.ends.len()
    }

    /// Is there none?
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }

    /// Each piece's vertices, counter-clockwise. Where a triangle only touches the region in a point off its vertices,
    /// and the crossings there are rounded, a sliver may be left that is no wider than that rounding, and turns
    /// either way.
    #[must_use]
    pub fn rings(&self) -> impl ExactSizeIterator<Item = &[Point]> + '_ {
        (0..self.ends.len()).map(|i| {
            let start = i.checked_sub(1).map_or(0, |before| self.ends[before]);
            &self.vertices[start..self.ends[i]]
        })
    }

    /// The triangle that each piece is left of.
    #[must_use]
    pub fn triangles(&self) -> &[usize] {
        &self.triangles
    }

    /// The edges that no other piece walks the other way: what surrounds the pieces once they are merged, with
    /// the inside on the left.
    #[must_use]
    pub fn outline(&self) -> Vec<Segment> {
        let edges = || self.rings().flat_map(ring_edges);
        let walked: HashSet<_> = edges().map(|edge| [edge.p1, edge.p2].map(key)).collect();
        edges()
            .filter(|edge| !walked.contains(&[edge.p2, edge.p1].map(key)))
            .collect()
    }

    /// The pieces merged: rings that surround them, to be filled where an odd number of them goes round. Where rings
    /// touch in a point they may be joined there; what they surround is the same.
    #[must_use]
    pub fn merged(&self) -> Vec<Vec<Point>> {
        let outline = self.outline();
        let mut leaving: HashMap<[u64; 2], Vec<usize>> = HashMap::new();
        for (edge_idx, edge) in outline.iter().enumerate() {
            leaving.entry(key(edge.p1)).or_default().push(edge_idx);
        }
        // As many edges leave a point as reach it: a walk along unused ones ends where it began.
        let mut next = |p: Point| leaving.get_mut(&key(p)).and_then(Vec::pop);
        let mut rings = Vec::new();
        for edge in &outline {
            let mut ring = Vec::new();
            let mut at = edge.p1;
            while let Some(edge_idx) = next(at) {
                ring.push(at);
                at = outline[edge_idx].p2;
            }
            if !ring.is_empty() {
                rings.push(ring);
            }
        }
        rings
    }
}

/// A place, whatever the sign of a zero.
fn key(p: Point) -> [u64; 2] {
    p.to_array().map(|x| (x + 0.0).to_bits())
}

fn ring_edges(ring: &[Point]) -> impl Iterator<Item = Segment> + '_ {
    let next = ring.iter().cycle().skip(1);
    ring.iter().zip(next).map(|(&p1, &p2)| Segment { p1, p2 })
}
