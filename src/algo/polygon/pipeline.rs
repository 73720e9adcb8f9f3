//! Sutherland–Hodgman as a pipeline: all clippers at once, one vertex flowing through them.
//!
//! ```text
//!   polygon ─V─► [left] ─V─► [right] ─I─► [bottom] ─V─► [top] ─V─► ring
//!                F, S         F, S         F, S          F, S
//! ```
//!
//! 1. Each clipper holds two vertices: F, the first that came, and S, the one before. What it puts out goes into the
//!    next clipper at once, before it does anything else.
//! 2. When the polygon has no more vertices, the first clipper closes its ring: the crossing of its last edge, if any,
//!    flows on. Then the second closes, and so on: by then all of its vertices have come.
//!
//! No list is kept between the clippers, and a vertex that comes out is final: the paper's *reentrant* form, for
//! hardware and for polygons that do not fit into memory. It does to every vertex what [`SutherlandHodgman`] does,
//! with the same step, so that the ring is the same, vertex for vertex. The order in which things happen differs.
//!
//! *Conventions*, *degenerate*, *exact*, *cost*: as in [`SutherlandHodgman`]. *Memory*: two vertices a clip edge.
//! *Bound*: no more than ⌊3n/2⌋ vertices leave a clipper that n enter.
//!
//! *Source*: I. E. Sutherland and G. W. Hodgman, "Reentrant Polygon Clipping", Communications of the ACM 17(1),
//! 1974, pp. 32–42, doi:10.1145/360767.360802.
//!
//! ```
//! use clipscope::{algo::polygon::{Pipeline, SutherlandHodgman, SutherlandHodgmanInput}, geom::{Polygon, Window}, trace::silent};
//! let region = Window::new(-1.0, -1.0, 1.0, 1.0)?.into();
//! let polygon = Polygon::new(&[[-1.5, 0.0], [0.0, -1.5], [1.5, 0.0], [0.0, 1.5]])?;
//! let input = SutherlandHodgmanInput::new(region, &polygon);
//! let ring = silent::<Pipeline>(&input);
//! assert_eq!(ring.vertices.len(), 8);
//! assert_eq!(ring, silent::<SutherlandHodgman>(&input));
//! # Ok::<(), clipscope::geom::GeomError>(())
//! ```

use std::marker::PhantomData;

use serde::Serialize;

use crate::{
    geom::Point,
    trace::{Algorithm, Real},
};

#[cfg(doc)]
use super::SutherlandHodgman;
use super::{
    super::line::Ratio,
    super::ring::{Clip, Crossing, Happening, Right},
    ClippedRing, RingOutcome, Rule, SutherlandHodgmanInput, Vertex,
    border::{Borders, NthBorder},
};

/// The algorithm, on vertices of kind `V`; see the module.
#[derive(Clone, Copy, Debug)]
pub struct Pipeline<V = Point>(PhantomData<V>);

/// What happens, in order.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum PipelineEvent<V> {
    /// A vertex enters a clipper.
    Enter {
        /// The clipper: the clip edge, as the region numbers them.
        stage_idx: usize,
        /// Where it stands in the polygon, if it comes from there and not from the clipper before.
        vertex_idx: Option<usize>,
        /// P
        at: V,
    },
    /// It is the first one: the clipper keeps it.
    First {
        /// The clipper.
        stage_idx: usize,
        /// F
        at: V,
        /// Its signed distance from the clip edge.
        distance: f64,
        /// Is it inside, and goes on?
        inside: bool,
    },
    /// The edge to it from the one before, or the edge that closes the ring.
    Test {
        /// The clipper.
        stage_idx: usize,
        /// S and P, or S and F.
        ends: [V; 2],
        /// Their signed distances from the clip edge.
        distances: [f64; 2],
        /// What follows.
        rule: Rule,
    },
    /// The edge crosses the clip edge.
    Cross {
        /// The clipper.
        stage_idx: usize,
        /// I
        at: V,
        /// Where from S to P.
        t: Ratio,
    },
    /// A vertex leaves the last clipper and joins the ring.
    Output {
        /// For good.
        at: V,
    },
    /// No vertex will come any more: the clipper closes its ring.
    Close {
        /// The clipper.
        stage_idx: usize,
    },
    /// All clippers are closed.
    Done {
        /// What it comes to.
        outcome: RingOutcome,
    },
}

/// A clipper's memory.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct PipelineStage<V> {
    /// F, once it has come.
    pub first: Option<V>,
    /// The last vertex that came: S of the next edge.
    pub previous: Option<V>,
    /// Has it closed its ring?
    pub is_closed: bool,
}

/// What the picture of a step needs.
#[derive(Clone, PartialEq, Debug)]
pub struct PipelineState<V> {
    /// One a clip edge.
    pub stages: Vec<PipelineStage<V>>,
    /// How far the polygon has been read: the vertex that entered last.
    pub vertex_idx: Option<usize>,
    /// The clipper at work.
    pub stage_idx: Option<usize>,
    /// The vertex that entered it, or left the last one; none while it closes.
    pub moving: Option<V>,
    /// The edge that the clipper looks at: ends, distances, rule.
    pub test: Option<([V; 2], [f64; 2], Rule)>,
    /// Where that edge crosses.
    pub crossing: Option<(V, Ratio)>,
    /// What has come out.
    pub output: Vec<V>,
    /// The answer's kind, once known.
    pub outcome: Option<RingOutcome>,
}

impl<V: Vertex> Algorithm for Pipeline<V> {
    type Input = SutherlandHodgmanInput<V>;
    type Output = ClippedRing<V>;
    type Event = PipelineEvent<V>;
    type State = PipelineState<V>;

    fn run<R: Real>(input: &Self::Input, mut emit: impl FnMut(Self::Event)) -> Self::Output {
        use PipelineEvent as Event;
        let borders = Borders::by::<Right>(&input.region);
        let n_stages = borders.all().len();
        let mut line = AssemblyLine::<V, R> {
            borders: &borders,
            stages: (0..n_stages).map(|_| None).collect(),
            waiting: Vec::new(),
            output: Vec::new(),
        };
        for (idx, &vertex) in input.vertices.iter().enumerate() {
            line.enter(0, Some(idx), vertex, &mut emit);
            line.flow(&mut emit);
        }
        for stage_idx in 0..n_stages {
            emit(Event::Close { stage_idx });
            line.close(stage_idx, &mut emit);
            line.flow(&mut emit);
        }
        let ring = ClippedRing::of(&input.vertices, line.output);
        let outcome = ring.outcome;
        emit(Event::Done { outcome });
        ring
    }

    fn start(input: &Self::Input) -> Self::State {
        let empty = PipelineStage {
            first: None,
            previous: None,
            is_closed: false,
        };
        PipelineState {
            stages: vec![empty; input.region.n_edges()],
            vertex_idx: None,
            stage_idx: None,
            moving: None,
            test: None,
            crossing: None,
            output: Vec::new(),
            outcome: None,
        }
    }

    fn apply(state: &mut Self::State, event: Self::Event) {
        state.apply(event);
    }

    fn finish(state: &Self::State) -> Self::Output {
        ClippedRing {
            outcome: state.outcome.unwrap_or(RingOutcome::Empty),
            vertices: state.output.clone(),
        }
    }

    /// For each clipper: every vertex enters, makes an edge and perhaps a crossing; closing is three events more.
    /// Then what comes out, and the verdict.
    fn max_events(input: &Self::Input) -> usize {
        let (mut n, mut total) = (input.vertices.len(), 1_usize);
        for _ in 0..input.region.n_edges() {
            total = n.saturating_mul(3).saturating_add(3).saturating_add(total);
            n = n.saturating_mul(3) / 2;
        }
        total.saturating_add(n)
    }
}

/// The clippers, and what has left one but not yet entered the next.
struct AssemblyLine<'a, V, R> {
    borders: &'a Borders,
    /// None where no vertex has come yet.
    stages: Vec<Option<Clip<NthBorder<'a>, V, R>>>,
    /// Vertices with the clipper they go to. The last one is the next to move: a clipper's crossing flows
    /// through to the end before the vertex behind it does.
    waiting: Vec<(usize, V)>,
    output: Vec<V>,
}

impl<V: Vertex, R: Real> AssemblyLine<'_, V, R> {
    fn enter(
        &mut self,
        stage_idx: usize,
        vertex_idx: Option<usize>,
        at: V,
        emit: &mut impl FnMut(PipelineEvent<V>),
    ) {
        emit(PipelineEvent::Enter {
            stage_idx,
            vertex_idx,
            at,
        });
        let n_waiting = self.waiting.len();
        let mut tell = |happening| tell(stage_idx, happening, &mut self.waiting, emit);
        match &mut self.stages[stage_idx] {
            Some(stage) => stage.vertex::<Right>(at, &mut tell),
            empty => {
                *empty = Some(Clip::begin::<Right>(
                    NthBorder {
                        borders: self.borders,
                        idx: stage_idx,
                    },
                    at,
                    &mut tell,
                ));
            }
        }
        self.waiting[n_waiting..].reverse();
    }

    fn close(&mut self, stage_idx: usize, emit: &mut impl FnMut(PipelineEvent<V>)) {
        if let Some(stage) = &self.stages[stage_idx] {
            stage.close::<Right>(&mut |happening| {
                tell(stage_idx, happening, &mut self.waiting, emit);
            });
        }
    }

    /// Lets everything that waits flow on as far as it goes.
    fn flow(&mut self, emit: &mut impl FnMut(PipelineEvent<V>)) {
        while let Some((stage_idx, at)) = self.waiting.pop() {
            if stage_idx < self.stages.len() {
                self.enter(stage_idx, None, at, emit);
            } else {
                self.output.push(at);
                emit(PipelineEvent::Output { at });
            }
        }
    }
}

/// What a clipper does, as an event; what it puts out is to go to the next.
fn tell<V>(
    stage_idx: usize,
    happening: Happening<V>,
    waiting: &mut Vec<(usize, V)>,
    emit: &mut impl FnMut(PipelineEvent<V>),
) {
    use PipelineEvent as Event;
    match happening {
        Happening::First {
            at,
            distance,
            inside,
        } => emit(Event::First {
            stage_idx,
            at,
            distance,
            inside,
        }),
        Happening::Test {
            ends,
            distances,
            rule,
        } => emit(Event::Test {
            stage_idx,
            ends,
            distances,
            rule,
        }),
        Happening::Cross(Crossing { at, t }) => emit(Event::Cross { stage_idx, at, t }),
        Happening::Output(at) => waiting.push((stage_idx + 1, at)),
    }
}

impl<V: Vertex> PipelineState<V> {
    fn apply(&mut self, event: PipelineEvent<V>) {
        use PipelineEvent as Event;
        match event {
            Event::Enter {
                stage_idx,
                vertex_idx,
                at,
            } => {
                self.at_work(stage_idx, Some(at));
                self.vertex_idx = vertex_idx.or(self.vertex_idx);
            }
            Event::First { stage_idx, at, .. } => {
                let stage = &mut self.stages[stage_idx];
                (stage.first, stage.previous) = (Some(at), Some(at));
            }
            Event::Test {
                stage_idx,
                ends,
                distances,
                rule,
            } => {
                self.stages[stage_idx].previous = Some(ends[1]);
                self.test = Some((ends, distances, rule));
            }
            Event::Cross { at, t, .. } => self.crossing = Some((at, t)),
            Event::Output { at } => {
                (self.stage_idx, self.moving) = (None, Some(at));
                (self.test, self.crossing) = (None, None);
                self.output.push(at);
            }
            Event::Close { stage_idx } => {
                self.at_work(stage_idx, None);
                self.stages[stage_idx].is_closed = true;
            }
            Event::Done { outcome } => {
                (self.stage_idx, self.moving) = (None, None);
                (self.test, self.crossing) = (None, None);
                self.outcome = Some(outcome);
            }
        }
    }

    fn at_work(&mut self, stage_idx: usize, moving: Option<V>) {
        (self.stage_idx, self.moving) = (Some(stage_idx), moving);
        (self.test, self.crossing) = (None, None);
    }
}
