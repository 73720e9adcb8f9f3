//! Cyrus–Beck: clip the parameter interval against any convex polygon, by the signs of dot products.
//!
//! ```text
//!            ╲  edge
//!             ╲                 n·D > 0: the line comes in across this edge, t raises t_min
//!   P₁ ●───────×──▶────● P₂     n·D < 0: it goes out,                        t lowers t_max
//!         ╲     ╲ ↗ n           n·D = 0: parallel; inside if n·w ≥ 0
//!       w  ╲     ╲
//!           ▼     ╲             w = P₁ − E    D = P₂ − P₁    t = −(n·w) / (n·D)
//!              ┄┄┄ E
//! ```
//!
//! 1. Start with the whole segment: t_min = 0, t_max = 1.
//! 2. For each edge, compute n·w, the signed distance of P₁, and n·D, its growth along the segment.
//!    Parallel and outside (n·D = 0, n·w < 0): reject. Otherwise t raises t_min or lowers t_max.
//! 3. Reject as soon as t_min > t_max. Otherwise the answer is P(t_min) to P(t_max).
//!
//! n·D is computed as the difference d₂ − d₁ of both ends' distances, so that its sign and theirs always
//! agree, and crossings are ordered exactly on these distances ([`Param::compare`]). The crossing is the
//! weighted mean of the ends, (P₁·d₂ − P₂·d₁) / (d₂ − d₁): the same from both ends, bit for bit. On an
//! edge along an axis the border coordinate is assigned, so that a window gives what Liang–Barsky gives.
//!
//! *Conventions*: closed polygon, counter-clockwise, normals pointing inside; of edges crossed at the same
//! t a vertical one sets the interval, else the first. *Degenerate*: a point has all n·D = 0 and is accepted
//! if all n·w ≥ 0; a touched vertex is both ends. *Bound*: one row an edge. *Cost*: for n edges at most
//! 7n +, 4n × and n ÷; for each end that is cut at most 4 +, 4 × and 2 ÷ more.
//!
//! *Source*: M. Cyrus and J. Beck, "Generalized Two- and Three-Dimensional Clipping", Computers & Graphics
//! 3(1), 1978, pp. 23–28, doi:10.1016/0097-8493(78)90021-3.
//!
//! ```
//! use clipscope::{algo::line::{CyrusBeck, CyrusBeckInput}, geom::{ConvexPolygon, Segment}, trace::silent};
//! let clip = ConvexPolygon::new(&[[0.0, -2.0], [2.0, 0.0], [0.0, 2.0], [-2.0, 0.0]])?;
//! let segment = Segment::new(-3.0, 1.0, 1.0, 1.0)?;
//! assert_eq!(silent::<CyrusBeck>(&CyrusBeckInput { clip, segment }), Some(Segment::new(-1.0, 1.0, 1.0, 1.0)?));
//! # Ok::<(), clipscope::geom::GeomError>(())
//! ```

use serde::Serialize;

use crate::{
    geom::{ConvexPolygon, Point, Segment},
    trace::{Algorithm, Real},
};

use super::{
    super::parameter::{Interval, Param},
    End, Visible,
    convex_border::{ConvexBorder, plane_distances},
    segment_between,
};

/// The algorithm; see the module.
#[derive(Clone, Copy, Debug)]
pub struct CyrusBeck;

/// What to clip, and against what.
#[derive(Clone, PartialEq, Debug)]
pub struct CyrusBeckInput {
    /// Closed. Edges are numbered from vertex 0, counter-clockwise.
    pub clip: ConvexPolygon,
    /// Directed from P₁ to P₂.
    pub segment: Segment,
}

/// What happens, in order.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum CyrusBeckEvent {
    /// One edge's dot products.
    Edge {
        /// From vertex `edge_idx` to the next.
        edge_idx: usize,
        /// n, pointing inside; of length 1 along an axis only.
        normal: [f64; 2],
        /// E, the vertex that the edge starts from.
        origin: Point,
        /// n·(P₁ − E): how far P₁ lies inside, in lengths of n.
        d1: f64,
        /// n·(P₂ − E): the same for P₂.
        d2: f64,
        /// n·D = d₂ − d₁: into the polygon where positive.
        slope: f64,
    },
    /// n·D = 0: this edge alone decides nothing if `inside`, everything if not.
    Parallel {
        /// The edge.
        edge_idx: usize,
        /// n·w
        d1: f64,
        /// n·w ≥ 0
        inside: bool,
    },
    /// The line comes in across this edge.
    Enter {
        /// The edge.
        edge_idx: usize,
        /// −(n·w) / (n·D)
        t: f64,
        /// Does it raise t_min?
        raises: bool,
        /// From now on.
        t_min: f64,
    },
    /// The line goes out across this edge.
    Leave {
        /// The edge.
        edge_idx: usize,
        /// −(n·w) / (n·D)
        t: f64,
        /// Does it lower t_max?
        lowers: bool,
        /// From now on.
        t_max: f64,
    },
    /// Is anything left of the interval?
    Interval {
        /// Where it begins.
        t_min: f64,
        /// Where it ends.
        t_max: f64,
        /// t_min > t_max
        empty: bool,
    },
    /// An end is put at its parameter.
    Put {
        /// Which end.
        end: End,
        /// t_min or t_max.
        t: f64,
        /// The edge that set it; `None` where the end was inside and stays.
        edge_idx: Option<usize>,
        /// Where.
        at: Point,
    },
    /// What is left is visible.
    Accept {
        /// The visible part.
        segment: Segment,
    },
    /// Nothing is visible.
    Reject {
        /// The edge at which it was decided.
        edge_idx: usize,
    },
}

/// One line of the table.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CyrusBeckRow {
    /// n
    pub normal: [f64; 2],
    /// E
    pub origin: Point,
    /// n·(P₁ − E)
    pub d1: f64,
    /// n·(P₂ − E)
    pub d2: f64,
    /// n·D
    pub slope: f64,
    /// −d₁ / n·D, once known; never where parallel.
    pub t: Option<f64>,
}

/// What the picture of a step needs.
#[derive(Clone, PartialEq, Debug)]
pub struct CyrusBeckState {
    /// The table, by edge, as far as it is filled.
    pub rows: Vec<CyrusBeckRow>,
    /// The interval.
    pub interval: [f64; 2],
    /// The edges that set it.
    pub set_by: [Option<usize>; 2],
    /// Ends already put in place.
    pub ends: [Option<Point>; 2],
    /// The answer, once known.
    pub verdict: Option<Visible>,
}

impl Algorithm for CyrusBeck {
    type Input = CyrusBeckInput;
    type Output = Visible;
    type Event = CyrusBeckEvent;
    type State = CyrusBeckState;

    fn run<R: Real>(input: &Self::Input, mut emit: impl FnMut(Self::Event)) -> Visible {
        use CyrusBeckEvent as Event;
        let CyrusBeckInput { clip, segment } = input;
        let mut interval = Interval::whole();
        for (edge_idx, plane) in clip.half_planes().enumerate() {
            let [d1, d2] = plane_distances::<R>(segment, &plane);
            let slope = d2 - d1;
            emit(Event::Edge {
                edge_idx,
                normal: plane.normal(),
                origin: plane.origin(),
                d1: d1.get(),
                d2: d2.get(),
                slope: slope.get(),
            });
            let visible = if slope == R::new(0.0) {
                let inside = d1 >= R::new(0.0);
                let d1 = d1.get();
                emit(Event::Parallel {
                    edge_idx,
                    d1,
                    inside,
                });
                inside
            } else {
                let border = ConvexBorder {
                    edge_idx,
                    plane,
                    distances: [d1.get(), d2.get()],
                };
                // A zero has no sign.
                let t = R::new((-d1 / slope).get() + 0.0);
                shrink(&mut interval, t, border, &mut emit)
            };
            if !visible {
                emit(Event::Reject { edge_idx });
                return None;
            }
        }
        let vertex = touched_vertex(&interval, clip);
        let ends =
            End::BOTH.map(|end| put(end, &interval.bounds[end.idx()], vertex, input, &mut emit));
        let segment = segment_between(ends);
        emit(Event::Accept { segment });
        Some(segment)
    }

    fn start(_: &Self::Input) -> Self::State {
        CyrusBeckState {
            rows: Vec::new(),
            interval: [0.0, 1.0],
            set_by: [None; 2],
            ends: [None; 2],
            verdict: None,
        }
    }

    fn apply(state: &mut Self::State, event: Self::Event) {
        use CyrusBeckEvent as Event;
        match event {
            Event::Edge {
                normal,
                origin,
                d1,
                d2,
                slope,
                ..
            } => state.rows.push(CyrusBeckRow {
                normal,
                origin,
                d1,
                d2,
                slope,
                t: None,
            }),
            Event::Enter {
                edge_idx,
                t,
                raises,
                t_min,
            } => state.bound(End::P1, edge_idx, t, raises, t_min),
            Event::Leave {
                edge_idx,
                t,
                lowers,
                t_max,
            } => state.bound(End::P2, edge_idx, t, lowers, t_max),
            Event::Put { end, at, .. } => state.ends[end.idx()] = Some(at),
            Event::Accept { segment } => state.verdict = Some(Some(segment)),
            Event::Reject { .. } => state.verdict = Some(None),
            Event::Parallel { .. } | Event::Interval { .. } => {}
        }
    }

    fn finish(state: &Self::State) -> Visible {
        state.verdict.flatten()
    }

    /// Three for each edge; two ends; a verdict.
    fn max_events(input: &Self::Input) -> usize {
        input.clip.vertices().len() * 3 + 2 + 1
    }
}

impl CyrusBeckState {
    fn bound(&mut self, end: End, edge_idx: usize, t: f64, moves: bool, bound: f64) {
        if let Some(row) = self.rows.get_mut(edge_idx) {
            row.t = Some(t);
        }
        self.interval[end.idx()] = bound;
        if moves {
            self.set_by[end.idx()] = Some(edge_idx);
        }
    }
}

/// Raises t_min or lowers t_max to t. False where nothing is left.
fn shrink<R: Real>(
    interval: &mut Interval<R, ConvexBorder>,
    t: R,
    border: ConvexBorder,
    emit: &mut impl FnMut(CyrusBeckEvent),
) -> bool {
    use CyrusBeckEvent as Event;
    let (edge_idx, [d1, d2]) = (border.edge_idx, border.distances);
    let param = Param {
        u: t,
        border: Some(border),
        leaving: d2 < d1,
    };
    // Of two at the same place a vertical one wins.
    let wins_tie = |old: ConvexBorder| border.is_vertical() && !old.is_vertical();
    let moves = interval.shrink(param, |b| b.distances, wins_tie);
    let (t, [t_min, t_max]) = (t.get(), interval.values());
    emit(if param.leaving {
        let lowers = moves;
        Event::Leave {
            edge_idx,
            t,
            lowers,
            t_max,
        }
    } else {
        let raises = moves;
        Event::Enter {
            edge_idx,
            t,
            raises,
            t_min,
        }
    });
    let empty = interval.is_empty(|b| b.distances);
    emit(Event::Interval {
        t_min,
        t_max,
        empty,
    });
    !empty
}

/// The vertex that the line touches: there it comes in across one edge and goes out across its neighbour.
fn touched_vertex<R: Real>(
    interval: &Interval<R, ConvexBorder>,
    clip: &ConvexPolygon,
) -> Option<Point> {
    let [i, j] = interval.borders()?.map(|b| b.edge_idx);
    let n = clip.vertices().len();
    let vertex_idx = if (i + 1) % n == j {
        j
    } else if (j + 1) % n == i {
        i
    } else {
        return None;
    };
    let is_touch = interval.is_touch(|b| b.distances);
    is_touch.then(|| clip.vertices()[vertex_idx])
}

/// P(t), on the edge that set t.
fn put<R: Real>(
    end: End,
    param: &Param<R, ConvexBorder>,
    vertex: Option<Point>,
    CyrusBeckInput { clip, segment }: &CyrusBeckInput,
    emit: &mut impl FnMut(CyrusBeckEvent),
) -> Point {
    let at = match (param.border, vertex) {
        (None, _) => end.of(segment),
        (Some(_), Some(vertex)) => vertex,
        (Some(border), None) => border.crossing::<R>(segment, clip),
    };
    emit(CyrusBeckEvent::Put {
        end,
        t: param.u.get(),
        edge_idx: param.border.map(|b| b.edge_idx),
        at,
    });
    at
}
