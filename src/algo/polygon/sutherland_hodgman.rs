//! Sutherland–Hodgman: clip the whole polygon against one edge of the region, then what is left against the
//! next.
//!
//! ```text
//!        ╱╲              ╱╲               ┊               one clip edge at a time:
//!   ┌───╱──╲───┐        ╱  ╲              ┊ ╲
//!   │  ╱    ╲  │  ──►  ╱____╲   ──►  ──►  ┊__╲    ──► …   the output list of one is the
//!   └─╱──────╲─┘      ┄┄┄┄┄┄┄             ┊               input list of the next
//! ```
//!
//! 1. For each edge of the region: begin an empty output list.
//! 2. Put out the first vertex F if it is inside.
//! 3. For each following vertex P, with S the one before, put out: P if both are inside; the crossing I if only
//!    S is; I and P if only P is; nothing if neither is.
//! 4. For the edge that closes the ring, from the last vertex to F, put out its crossing, if any.
//! 5. The output list is the next edge's input list. The last one is the answer.
//!
//! A crossing is the weighted mean of both ends, (S·|d_P| + P·|d_S|) / (|d_S| + |d_P|), with d the distances from
//! the border; whatever goes with the vertices is mixed in the same way. Along an axis the border
//! coordinate is assigned. An end on the border is its own crossing, and not put out twice.
//!
//! There is one ring of output, whatever the input. Where a concave polygon falls apart, its pieces stay joined
//! by *bridges*: edges along the border, walked there and back, with no area.
//!
//! *Conventions*: closed, convex region; on its border is inside; vertices come out in the order of the input, of
//! either winding. *Degenerate*: [`RingOutcome`]; repeated and collinear vertices are kept; a polygon that lies
//! inside comes back as it was; clipping again changes nothing. *Exact* against a window, up to the crossings' free
//! coordinates; against an oblique edge distances are rounded too, so that a vertex within a rounding of it may
//! fall on either side, and a polygon that touches it between its vertices may keep a sliver.
//! *Bound*: n vertices become at most ⌊3n/2⌋ at each clip edge, as each that is inside lies between at
//! most two crossings. *Cost* a vertex and upright clip edge: 1 + and 1 comparison; a crossing: 3 +, 2 × and 1 ÷
//! more, and 5 or so comparisons.
//!
//! *Source*: I. E. Sutherland and G. W. Hodgman, "Reentrant Polygon Clipping", Communications of the ACM 17(1),
//! 1974, pp. 32–42, doi:10.1145/360767.360802.
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
    trace::{Algorithm, Real},
};

use super::{
    super::line::Ratio,
    super::ring::{Clip, Crossing, Happening, Right, Rules},
    ClipRegion, ClippedRing, RingOutcome, Rule, Vertex,
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
    First {
        /// F
        at: V,
        /// Its signed distance from the clip edge.
        distance: f64,
        /// Is it inside?
        inside: bool,
    },
    /// The edge from S to P, the last one closing the ring.
    Test {
        /// Where S and P stand in the input list.
        idx: [usize; 2],
        /// S and P.
        ends: [V; 2],
        /// Their signed distances from the clip edge.
        distances: [f64; 2],
        /// What follows.
        rule: Rule,
    },
    /// The edge crosses the clip edge.
    Cross {
        /// I
        at: V,
        /// Where from S to P.
        t: Ratio,
    },
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

/// What the picture of a step needs.
#[derive(Clone, PartialEq, Debug)]
pub struct SutherlandHodgmanState<V> {
    /// The list that is clipped; after the end, the answer.
    pub input: Vec<V>,
    /// The list that grows.
    pub output: Vec<V>,
    /// After a pass, until the next clip edge's turn: the list that was clipped.
    pub passed: Vec<V>,
    /// The clip edge whose turn it is.
    pub edge_idx: Option<usize>,
    /// How far inside the clip edge the vertices lie that have been looked at, and whether that counts as inside.
    pub sides: Vec<(f64, bool)>,
    /// The edge that is looked at.
    pub test: Option<EdgeTest>,
    /// Where that edge crosses.
    pub crossing: Option<(V, Ratio)>,
    /// Every crossing with this clip edge, and between which two vertices it lies.
    pub crossings: Vec<([usize; 2], V)>,
    /// The answer's kind, once known.
    pub outcome: Option<RingOutcome>,
}

/// An edge of the polygon against a clip edge.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct EdgeTest {
    /// Where S and P stand in the input list.
    pub idx: [usize; 2],
    /// Their signed distances from the clip edge.
    pub distances: [f64; 2],
    /// What follows.
    pub rule: Rule,
}

impl<V: Vertex, L: Rules> Algorithm for SutherlandHodgman<V, L> {
    type Input = SutherlandHodgmanInput<V>;
    type Output = ClippedRing<V>;
    type Event = SutherlandHodgmanEvent<V>;
    type State = SutherlandHodgmanState<V>;

    fn run<R: Real>(input: &Self::Input, mut emit: impl FnMut(Self::Event)) -> Self::Output {
        use SutherlandHodgmanEvent as Event;
        let borders = Borders::by::<L>(&input.region);
        let (mut list, mut output) = (input.vertices.clone(), Vec::new());
        for (idx, border) in borders.all().iter().enumerate() {
            if list.is_empty() {
                break;
            }
            let edge_idx = border.edge_idx();
            emit(Event::Edge {
                edge_idx,
                normal: border.normal(),
                origin: border.origin(),
            });
            clip_edge::<L, V, R>(&borders, idx, &list, &mut output, &mut emit);
            std::mem::swap(&mut list, &mut output);
            output.clear();
            let n_vertices = list.len();
            emit(Event::Pass {
                edge_idx,
                n_vertices,
            });
        }
        let ring = ClippedRing::of(&input.vertices, list);
        let outcome = ring.outcome;
        emit(Event::Done { outcome });
        ring
    }

    fn start(input: &Self::Input) -> Self::State {
        SutherlandHodgmanState {
            input: input.vertices.clone(),
            output: Vec::new(),
            passed: Vec::new(),
            edge_idx: None,
            sides: Vec::new(),
            test: None,
            crossing: None,
            crossings: Vec::new(),
            outcome: None,
        }
    }

    fn apply(state: &mut Self::State, event: Self::Event) {
        state.apply(event);
    }

    fn finish(state: &Self::State) -> Self::Output {
        ClippedRing {
            outcome: state.outcome.unwrap_or(RingOutcome::Empty),
            vertices: state.input.clone(),
        }
    }

    /// For each clip edge: its turn; the first vertex, perhaps put out; for each polygon edge a test, a crossing
    /// with its copies, and an end; the pass. Then the verdict.
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

/// Clips `input` against one edge and appends what is left to `output`.
fn clip_edge<L: Rules, V: Vertex, R: Real>(
    borders: &Borders,
    idx: usize,
    input: &[V],
    output: &mut Vec<V>,
    emit: &mut impl FnMut(SutherlandHodgmanEvent<V>),
) {
    use SutherlandHodgmanEvent as Event;
    let Some((&first, following)) = input.split_first() else {
        return;
    };
    let mut tell = |idx: [usize; 2], happening| match happening {
        Happening::First {
            at,
            distance,
            inside,
        } => emit(Event::First {
            at,
            distance,
            inside,
        }),
        Happening::Test {
            ends,
            distances,
            rule,
        } => emit(Event::Test {
            idx,
            ends,
            distances,
            rule,
        }),
        Happening::Cross(Crossing { at, t }) => emit(Event::Cross { at, t }),
        Happening::Output(at) => {
            output.push(at);
            emit(Event::Output { at });
        }
    };
    let mut clip =
        Clip::<_, V, R>::begin::<L>(NthBorder { borders, idx }, first, &mut |happening| {
            tell([0, 0], happening);
        });
    for (i, &vertex) in following.iter().enumerate() {
        clip.vertex::<L>(vertex, &mut |happening| tell([i, i + 1], happening));
    }
    let idx = [input.len() - 1, 0];
    clip.close::<L>(&mut |happening| tell(idx, happening));
}

impl<V: Vertex> SutherlandHodgmanState<V> {
    fn apply(&mut self, event: SutherlandHodgmanEvent<V>) {
        use SutherlandHodgmanEvent as Event;
        match event {
            Event::Edge { edge_idx, .. } => {
                self.edge_idx = Some(edge_idx);
                self.passed.clear();
                self.sides.clear();
                self.crossings.clear();
            }
            Event::First {
                distance, inside, ..
            } => self.sides.push((distance, inside)),
            Event::Test {
                idx,
                distances,
                rule,
                ..
            } => {
                self.test = Some(EdgeTest {
                    idx,
                    distances,
                    rule,
                });
                // The edge that closes the ring ends where it began.
                if idx[1] == self.sides.len() {
                    self.sides.push((distances[1], rule.ends_inside()));
                }
                self.crossing = None;
            }
            Event::Cross { at, t } => {
                self.crossing = Some((at, t));
                let between = self.test.map(|test| (test.idx, at));
                self.crossings.extend(between);
            }
            Event::Output { at } => self.output.push(at),
            Event::Pass { .. } => {
                let put_out = std::mem::take(&mut self.output);
                self.passed = std::mem::replace(&mut self.input, put_out);
                (self.test, self.crossing) = (None, None);
            }
            Event::Done { outcome } => {
                self.edge_idx = None;
                self.outcome = Some(outcome);
            }
        }
    }
}
