//! Triangulate, then clip: a concave polygon leaves its pieces without bridges when every triangle of it is clipped on its own.
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
//! By [`EarClipping`], and then by [`SutherlandHodgman`] for each triangle: what is left of a convex polygon in a convex region is one convex
//! piece, or none. Two that meet along a diagonal share it bit for bit: [`Pieces::outline`] takes such edges out.
//!
//! *Conventions*, *degenerate*, *exact*: as in the two. *Bound*: the events of one run of ear clipping, and of n − 2 runs of
//! Sutherland–Hodgman on three vertices, with two more for each. *Cost*: the sum of both.
//!
//! *Source*: splitting a concave polygon and clipping its convex parts one by one is the remedy in D. Hearn and M. P. Baker, *Computer
//! Graphics, C Version*, 2nd edition, 1997, section 6-8.
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

use std::collections::{HashMap, HashSet};

use serde::Serialize;

use crate::{
    geom::{Point, Segment, SimplePolygon, pairs_around},
    trace::{Includes, Method, Real, Tell, Told},
};

use super::{
    super::ring::{Happening, Lists, Right, RingClipper, RingEvent},
    ClipRegion, EarClipping, EarClippingEvent, EarClippingHeld, RingOutcome, SutherlandHodgman,
    SutherlandHodgmanEvent, SutherlandHodgmanHeld, SutherlandHodgmanInput, Triangle,
    border::{Borders, NthBorder},
    ear_clipping::cut_all,
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

/// What it works in.
#[derive(Clone, PartialEq, Debug)]
pub struct TriangulateAndClipHeld {
    /// The triangulation.
    pub ears: EarClippingHeld,
    /// How many triangles are done: the number of the one whose turn it is.
    pub triangle_idx: usize,
    /// That triangle, and what it is clipped against.
    pub problem: SutherlandHodgmanInput,
    /// What is left of it.
    pub clip: SutherlandHodgmanHeld<Point>,
    /// What is left of those before.
    pub pieces: Pieces,
}

impl Method for TriangulateAndClip {
    type Input = TriangulateAndClipInput;
    type Held = TriangulateAndClipHeld;
    type Output = Pieces;
    type Event = TriangulateAndClipEvent;

    fn begin(input: &Self::Input) -> Self::Held {
        let problem = SutherlandHodgmanInput {
            region: input.region.clone(),
            vertices: Vec::new(),
        };
        TriangulateAndClipHeld {
            ears: EarClipping::begin(&input.polygon),
            triangle_idx: 0,
            clip: <SutherlandHodgman>::begin(&problem),
            problem,
            pieces: Pieces::default(),
        }
    }

    fn run<R: Real, T: Tell<Self>>(
        input: &Self::Input,
        held: &mut Self::Held,
        tell: &mut T,
    ) -> Told<T::Stop> {
        use EachTriangleEvent::{Finish, Piece, Triangle};
        use TriangulateAndClipEvent as Event;
        if held.ears.cut_off.triangles().len() < input.polygon.vertices().len() - 2 {
            cut_all::<Self, R, T>(held, tell)?;
        }
        let borders = &Borders::by::<Right>(&input.region);
        while let Some(&triangle) = held.ears.cut_off.triangles().get(held.triangle_idx) {
            let triangle_idx = held.triangle_idx;
            if triangle_idx % TRIANGLES_PER_REST == TRIANGLES_PER_REST - 1 {
                tell.rest(held);
            }
            let corners = held.ears.cut_off.corners(triangle);
            held.problem.vertices = corners.to_vec();
            held.clip = <SutherlandHodgman>::begin(&held.problem);
            let turn = Triangle {
                triangle_idx,
                triangle,
                corners,
            };
            tell.tell(held, Event::Each(turn))?;
            let limits = (0..borders.all().len()).map(|idx| NthBorder { borders, idx });
            Self::clip_by_all::<R, T>(held, limits, tell)?;
            let outcome = RingOutcome::of(&corners, held.clip.lists.list());
            tell.tell(held, Event::Clip(SutherlandHodgmanEvent::Done { outcome }))?;
            held.pieces
                .push(triangle_idx, held.clip.lists.list(), outcome);
            let piece = Piece {
                triangle_idx,
                outcome,
            };
            tell.tell(held, Event::Each(piece))?;
            held.triangle_idx += 1;
        }
        let n_pieces = held.pieces.len();
        tell.tell(held, Event::Each(Finish { n_pieces }))
    }

    fn output(held: Self::Held) -> Pieces {
        held.pieces
    }

    fn max_events(input: &Self::Input) -> usize {
        let n_triangles = input.polygon.vertices().len() - 2;
        let problem = SutherlandHodgmanInput {
            region: input.region.clone(),
            vertices: input.polygon.vertices()[..3].to_vec(),
        };
        let per_triangle = <SutherlandHodgman>::max_events(&problem).saturating_add(2);
        EarClipping::max_events(&input.polygon)
            .saturating_add(per_triangle.saturating_mul(n_triangles))
            .saturating_add(1)
    }
}

const TRIANGLES_PER_REST: usize = 64;

impl Includes<EarClipping> for TriangulateAndClip {
    #[inline]
    fn part(held: &Self::Held) -> &EarClippingHeld {
        &held.ears
    }

    #[inline]
    fn part_mut(held: &mut Self::Held) -> &mut EarClippingHeld {
        &mut held.ears
    }

    #[inline]
    fn as_own(event: EarClippingEvent) -> Self::Event {
        TriangulateAndClipEvent::Triangulate(event)
    }
}

impl RingClipper for TriangulateAndClip {
    type Ring = Vec<Point>;
    type Rules = Right;
    type Limit<'a> = NthBorder<'a>;

    #[inline]
    fn lists(held: &Self::Held) -> &Lists<Vec<Point>> {
        &held.clip.lists
    }

    #[inline]
    fn lists_mut(held: &mut Self::Held) -> &mut Lists<Vec<Point>> {
        &mut held.clip.lists
    }

    #[inline]
    fn turn(limit: &NthBorder<'_>) -> Self::Event {
        TriangulateAndClipEvent::Clip(<SutherlandHodgman>::turn(limit))
    }

    #[inline]
    fn passed(limit: &NthBorder<'_>, n_vertices: usize) -> Self::Event {
        TriangulateAndClipEvent::Clip(<SutherlandHodgman>::passed(limit, n_vertices))
    }
}

impl From<Happening<Point>> for TriangulateAndClipEvent {
    #[inline]
    fn from(happening: Happening<Point>) -> Self {
        Self::Clip(happening.into())
    }
}

impl RingEvent<Point> for TriangulateAndClipEvent {
    fn happening(&self) -> Option<Happening<Point>> {
        match self {
            Self::Clip(event) => event.happening(),
            Self::Triangulate(_) | Self::Each(_) => None,
        }
    }
}

impl Pieces {
    fn push(&mut self, triangle_idx: usize, ring: &[Point], outcome: RingOutcome) {
        if matches!(outcome, RingOutcome::Whole | RingOutcome::Cut) {
            self.vertices.extend(ring);
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

    /// Counter-clockwise. Where a triangle only touches the region, rounding may leave a sliver no wider than itself, of either turn.
    #[must_use]
    pub fn rings(&self) -> impl ExactSizeIterator<Item = &[Point]> + '_ {
        (0..self.ends.len()).map(|i| self.ring(i))
    }

    /// The vertices of one piece.
    #[must_use]
    pub fn ring(&self, piece_idx: usize) -> &[Point] {
        let start = piece_idx
            .checked_sub(1)
            .map_or(0, |before| self.ends[before]);
        &self.vertices[start..self.ends[piece_idx]]
    }

    /// The triangle that each piece is left of.
    #[must_use]
    pub fn triangles(&self) -> &[usize] {
        &self.triangles
    }

    /// The edges that no other piece walks the other way: the outline of all pieces together, with the inside on its left.
    #[must_use]
    pub fn outline(&self) -> Vec<Segment> {
        let edges = || self.rings().flat_map(ring_edges);
        let walked: HashSet<_> = edges().map(|edge| [edge.p1, edge.p2].map(key)).collect();
        edges()
            .filter(|edge| !walked.contains(&[edge.p2, edge.p1].map(key)))
            .collect()
    }

    /// The pieces merged: rings to be filled where an odd number goes round. Those that touch in a point may be joined there.
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
    pairs_around(ring).map(|[p1, p2]| Segment { p1, p2 })
}
