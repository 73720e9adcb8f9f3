//! Sutherland–Hodgman as a pipeline: all clippers at once, one vertex flowing through them.
//!
//! ```text
//!   polygon ─V─► [left] ─V─► [right] ─I─► [bottom] ─V─► [top] ─V─► ring
//!                F, S         F, S         F, S          F, S
//! ```
//!
//! 1. Each clipper holds two vertices: F, the first that came, and S, the one before. What it puts out goes into the next at once.
//! 2. When the polygon has no more vertices, the first clipper closes its ring, then the second, and so on.
//!
//! No list is kept, and a vertex that comes out is final: the paper's *reentrant* form, for hardware and for polygons that do not fit into
//! memory. Each vertex goes through [`SutherlandHodgman`]'s step, so the ring is the same, vertex for vertex.
//!
//! *Conventions*, *degenerate*, *exact*, *cost*: as in [`SutherlandHodgman`]. *Memory*: two vertices a clip edge. *Bound*: ⌊3n/2⌋ vertices
//! leave a clipper that n enter.
//!
//! *Source*: I. E. Sutherland and G. W. Hodgman, "Reentrant Polygon Clipping", Communications of the ACM 17(1), 1974, pp. 32–42,
//! doi:10.1145/360767.360802.
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
    trace::{Method, Real, Tell, Told},
};

#[cfg(doc)]
use super::SutherlandHodgman;
use super::{
    super::line::Ratio,
    super::ring::{Clip, Crossing, EdgeTest, Happening, Known, Right, RingEvent},
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

impl<V: Copy> RingEvent<V> for PipelineEvent<V> {
    fn happening(&self) -> Option<Happening<V>> {
        match *self {
            Self::First {
                at,
                distance,
                inside,
                ..
            } => Some(Happening::First(Known {
                at,
                distance,
                inside,
            })),
            Self::Test {
                ends,
                distances,
                rule,
                ..
            } => Some(Happening::Test(EdgeTest {
                idx: [0; 2],
                ends,
                distances,
                rule,
            })),
            Self::Cross { at, t, .. } => Some(Happening::Cross(Crossing { at, t })),
            Self::Enter { .. } | Self::Output { .. } | Self::Close { .. } | Self::Done { .. } => {
                None
            }
        }
    }
}

/// A clipper's memory.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct PipelineStage<V> {
    /// None where no vertex has come yet.
    clip: Option<Clip<V>>,
    /// Has it closed its ring?
    pub is_closed: bool,
}

impl<V: Copy> PipelineStage<V> {
    /// F, once it has come.
    #[must_use]
    pub fn first(&self) -> Option<V> {
        self.clip.as_ref().map(Clip::first)
    }

    /// The last vertex that came: S of the next edge.
    #[must_use]
    pub fn previous(&self) -> Option<V> {
        self.clip.as_ref().map(Clip::previous)
    }
}

/// What it works in.
#[derive(Clone, PartialEq, Debug)]
pub struct PipelineHeld<V> {
    /// One a clip edge.
    pub stages: Vec<PipelineStage<V>>,
    /// What has come out.
    pub output: Vec<V>,
    outcome: RingOutcome,
}

impl<V: Vertex> Method for Pipeline<V> {
    type Input = SutherlandHodgmanInput<V>;
    type Held = PipelineHeld<V>;
    type Output = ClippedRing<V>;
    type Event = PipelineEvent<V>;

    #[inline]
    fn begin(input: &Self::Input) -> Self::Held {
        let empty = PipelineStage {
            clip: None,
            is_closed: false,
        };
        PipelineHeld {
            stages: vec![empty; input.region.n_edges()],
            output: Vec::new(),
            outcome: RingOutcome::Empty,
        }
    }

    #[inline]
    fn run<R: Real, T: Tell<Self>>(
        input: &Self::Input,
        held: &mut Self::Held,
        tell: &mut T,
    ) -> Told<T::Stop> {
        let mut line = AssemblyLine {
            borders: &Borders::by::<Right>(&input.region),
            waiting: Vec::new(),
            held,
            tell,
        };
        for (idx, &vertex) in input.vertices.iter().enumerate() {
            line.enter::<R>(0, Some(idx), vertex)?;
            line.flow::<R>()?;
        }
        for stage_idx in 0..line.held.stages.len() {
            line.close::<R>(stage_idx)?;
            line.flow::<R>()?;
        }
        let outcome = RingOutcome::of(&input.vertices, &held.output);
        held.outcome = outcome;
        tell.tell(held, PipelineEvent::Done { outcome })
    }

    #[inline]
    fn output(held: Self::Held) -> Self::Output {
        ClippedRing {
            outcome: held.outcome,
            vertices: held.output,
        }
    }

    /// For each clipper: a vertex enters, makes an edge and perhaps a crossing; closing is three more. Then output and verdict.
    fn max_events(input: &Self::Input) -> usize {
        let (mut n, mut total) = (input.vertices.len(), 1_usize);
        for _ in 0..input.region.n_edges() {
            total = n.saturating_mul(3).saturating_add(3).saturating_add(total);
            n = n.saturating_mul(3) / 2;
        }
        total.saturating_add(n)
    }
}

struct AssemblyLine<'a, V, T> {
    borders: &'a Borders,
    /// Vertices that have left one clipper, with the one they go to next. The last moves first: a crossing flows through to the end
    /// before the vertex behind it does.
    waiting: Vec<(usize, V)>,
    held: &'a mut PipelineHeld<V>,
    tell: &'a mut T,
}

impl<V: Vertex, T: Tell<Pipeline<V>>> AssemblyLine<'_, V, T> {
    #[inline]
    fn enter<R: Real>(
        &mut self,
        stage_idx: usize,
        vertex_idx: Option<usize>,
        at: V,
    ) -> Told<T::Stop> {
        let limit = self.border(stage_idx);
        let n_waiting = self.waiting.len();
        let entered = PipelineEvent::Enter {
            stage_idx,
            vertex_idx,
            at,
        };
        self.tell.tell(self.held, entered)?;
        if let Some(mut clip) = self.held.stages[stage_idx].clip {
            let vertex = ([0; 2], at);
            clip.vertex::<Right, R, _>(&limit, vertex, &mut |it| self.note(stage_idx, it))?;
            self.held.stages[stage_idx].clip = Some(clip);
        } else {
            let clip = Clip::begin::<Right, R>(&limit, at);
            self.held.stages[stage_idx].clip = Some(clip);
            clip.tell_first(&limit, &mut |it| self.note(stage_idx, it))?;
        }
        self.waiting[n_waiting..].reverse();
        Told::Continue(())
    }

    #[inline]
    fn close<R: Real>(&mut self, stage_idx: usize) -> Told<T::Stop> {
        self.held.stages[stage_idx].is_closed = true;
        self.tell
            .tell(self.held, PipelineEvent::Close { stage_idx })?;
        if let Some(mut clip) = self.held.stages[stage_idx].clip {
            let limit = self.border(stage_idx);
            clip.close::<Right, R, _>(&limit, [0; 2], &mut |it| self.note(stage_idx, it))?;
            self.held.stages[stage_idx].clip = Some(clip);
        }
        Told::Continue(())
    }

    #[inline]
    fn flow<R: Real>(&mut self) -> Told<T::Stop> {
        while let Some((stage_idx, at)) = self.waiting.pop() {
            if stage_idx < self.held.stages.len() {
                self.enter::<R>(stage_idx, None, at)?;
            } else {
                self.held.output.push(at);
                self.tell.tell(self.held, PipelineEvent::Output { at })?;
            }
        }
        Told::Continue(())
    }

    #[inline]
    fn note(&mut self, stage_idx: usize, happening: Happening<V>) -> Told<T::Stop> {
        let event = match happening {
            Happening::First(first) => PipelineEvent::First {
                stage_idx,
                at: first.at,
                distance: first.distance,
                inside: first.inside,
            },
            Happening::Test(test) => PipelineEvent::Test {
                stage_idx,
                ends: test.ends,
                distances: test.distances,
                rule: test.rule,
            },
            Happening::Cross(Crossing { at, t }) => PipelineEvent::Cross { stage_idx, at, t },
            Happening::Output(at) => {
                self.waiting.push((stage_idx + 1, at));
                return Told::Continue(());
            }
        };
        self.tell.tell(self.held, event)
    }
}

impl<'a, V, T> AssemblyLine<'a, V, T> {
    #[inline]
    const fn border(&self, idx: usize) -> NthBorder<'a> {
        NthBorder {
            borders: self.borders,
            idx,
        }
    }
}
