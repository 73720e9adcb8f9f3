//! A segment against any planes, in any number of dimensions: one inequality a plane for the parameter.
//!
//! ```text
//!   P(u) = P₁ + u (P₂ − P₁) is inside a plane where  u·p ≤ q       q: how far P₁ lies inside
//!                                                                  p: how much of that the way to P₂ takes away
//!   p < 0  the line comes in,   u ≥ r = q/p
//!   p > 0  it goes out,         u ≤ r              0 ──[u_min ━━━━━ u_max]── 1
//!   p = 0  parallel: inside if q ≥ 0
//! ```
//!
//! What Liang and Barsky do with a window is the same with the six faces of a box, with planes that stand obliquely, and with
//! the sides x = ±w of clip space: only p, q and the place of a crossing depend on what is clipped against ([`Bounds`]).
//!
//! 1. Start with the whole segment: u_min = 0, u_max = 1.
//! 2. For each plane, compute p and q. Parallel and outside: reject. Otherwise r = q/p raises u_min or lowers u_max.
//! 3. Reject as soon as u_min > u_max. Otherwise the answer is P(u_min) to P(u_max).
//!
//! *Exact*: `max`, `min` and `>` on parameters ([`Param::compare`]), so that a touch is told from nothing beyond rounding and
//! both directions decide alike; an end that was inside comes back bit for bit; swapping the ends swaps the answer's, bit for
//! bit. Where u_min = u_max both ends are the same point. *Bound*: what begins the run, three events a plane, two ends, a
//! verdict.
//!
//! *Source*: You-Dong Liang and Brian A. Barsky, "A New Concept and Method for Line Clipping", ACM Transactions on Graphics
//! 3(1), 1984, pp. 1–22, doi:10.1145/357332.357333; sections 5 and 6 have three dimensions and perspective.

use std::{fmt::Debug, marker::PhantomData};

use serde::Serialize;

use crate::{
    algo::{
        parameter::{End, Interval, Param},
        ring::Right,
    },
    trace::{Algorithm, Real},
};

use super::{
    LineRules,
    line_event::{LineEvent, LineRow, VisibleLine},
};

/// What a segment of `N` coordinates is clipped against.
pub trait Bounds<const N: usize>: Clone + PartialEq + Debug + 'static {
    /// One of its planes. Of two that are crossed at the same place the lesser is that which the point is put on.
    type Plane: Copy + Ord + Debug + Serialize + 'static;
    /// What is worked out once for all planes.
    type Once<R: Real>: Copy;

    /// In the order in which they are asked.
    fn planes(&self) -> impl Iterator<Item = Self::Plane>;

    /// Before the first plane; `None` where nothing can be visible. The wrong rules change the ends here.
    fn begin<R: Real, L: LineRules>(
        &self,
        ends: &mut [[f64; N]; 2],
        emit: &mut impl FnMut(LineEvent<Self::Plane, N>),
    ) -> Option<Self::Once<R>>;

    /// p and q.
    fn inequality<R: Real>(
        &self,
        plane: Self::Plane,
        ends: &[[f64; N]; 2],
        once: &Self::Once<R>,
    ) -> [R; 2];

    /// q / p, p not being 0.
    fn quotient<R: Real>(&self, plane: Self::Plane, ends: &[[f64; N]; 2], p_and_q: [R; 2]) -> R;

    /// Signed distances of both ends, inside positive: their signs and their ratio count.
    fn distances(&self, plane: Self::Plane, ends: &[[f64; N]; 2]) -> [f64; 2];

    /// Where the segment crosses a plane, known to be inside of all: on this plane, and on the `touched` one where it meets
    /// both there.
    fn crossing<R: Real>(
        &self,
        plane: Self::Plane,
        touched: Option<Self::Plane>,
        ends: &[[f64; N]; 2],
    ) -> [f64; N];
}

/// The algorithm, against the bounds `B` and by the rules of `L`; see the module.
#[derive(Clone, Copy, Debug)]
pub struct LineClip<const N: usize, B, L = Right>(PhantomData<(B, L)>);

/// What is clipped, and against what.
#[derive(Clone, PartialEq, Debug)]
pub struct LineInput<const N: usize, B> {
    /// Closed.
    pub bounds: B,
    /// P₁ and P₂, finite.
    pub ends: [[f64; N]; 2],
}

/// What the picture of a step needs.
#[derive(Clone, PartialEq, Debug)]
pub struct LineState<P, const N: usize> {
    /// What is clipped: as given, but by wrong rules.
    pub ends: [[f64; N]; 2],
    /// P₂ − P₁, once known and where it is needed.
    pub delta: Option<[f64; N]>,
    /// Which ends lie behind the eye, once known and where there is one.
    pub behind: Option<[bool; 2]>,
    /// The table, as far as it is filled.
    pub rows: Vec<LineRow<P>>,
    /// The interval.
    pub interval: [f64; 2],
    /// The planes that set it.
    pub set_by: [Option<P>; 2],
    /// Ends already put in place.
    pub put: [Option<[f64; N]>; 2],
    /// The answer, once known.
    pub verdict: Option<VisibleLine<N>>,
}

impl<const N: usize, B: Bounds<N>, L: LineRules> Algorithm for LineClip<N, B, L> {
    type Input = LineInput<N, B>;
    type Output = VisibleLine<N>;
    type Event = LineEvent<B::Plane, N>;
    type State = LineState<B::Plane, N>;

    fn run<R: Real>(input: &Self::Input, mut emit: impl FnMut(Self::Event)) -> VisibleLine<N> {
        use LineEvent as Event;
        let LineInput { bounds, mut ends } = input.clone();
        let Some(once) = bounds.begin::<R, L>(&mut ends, &mut emit) else {
            emit(Event::Reject { plane: None });
            return None;
        };
        let mut interval = Interval::whole();
        for plane in bounds.planes() {
            let [p, q] = bounds.inequality(plane, &ends, &once);
            emit(Event::Row {
                plane,
                // −Δ of a Δ of zero is shown without a sign.
                p: p.get() + 0.0,
                q: q.get() + 0.0,
            });
            let visible = if p == R::new(0.0) {
                let inside = q >= R::new(0.0);
                let q = q.get() + 0.0;
                emit(Event::Parallel { plane, q, inside });
                inside
            } else {
                let param = Param {
                    u: bounds.quotient(plane, &ends, [p, q]),
                    border: Some(plane),
                    leaving: p > R::new(0.0),
                };
                let distances = |plane| bounds.distances(plane, &ends);
                shrink(&mut interval, param, plane, distances, &mut emit)
            };
            if !visible {
                emit(Event::Reject { plane: Some(plane) });
                return None;
            }
        }
        let is_touch = interval.is_touch(|plane| bounds.distances(plane, &ends));
        let touched = interval.borders().filter(|_| is_touch);
        let ends = End::BOTH.map(|end| {
            let param = &interval.bounds[end.idx()];
            let at = match (param.border, touched) {
                (None, _) => ends[end.idx()],
                (Some(_), Some([a, b])) => bounds.crossing::<R>(a.min(b), Some(a.max(b)), &ends),
                (Some(plane), None) => bounds.crossing::<R>(plane, None, &ends),
            };
            emit(Event::Put {
                end,
                u: param.u.get(),
                plane: param.border,
                at,
            });
            at
        });
        emit(Event::Accept { ends });
        Some(ends)
    }

    fn start(input: &Self::Input) -> Self::State {
        LineState {
            ends: input.ends,
            delta: None,
            behind: None,
            rows: Vec::new(),
            interval: [0.0, 1.0],
            set_by: [None; 2],
            put: [None; 2],
            verdict: None,
        }
    }

    fn apply(state: &mut Self::State, event: Self::Event) {
        use LineEvent as Event;
        match event {
            Event::Delta { delta } => state.delta = Some(delta),
            Event::Depths { ends, behind } => {
                (state.ends, state.behind) = (ends, Some(behind));
            }
            Event::Row { plane, p, q } => state.rows.push(LineRow {
                plane,
                p,
                q,
                r: None,
                left: None,
            }),
            Event::Enter {
                plane,
                r,
                raises,
                u_min,
            } => state.bound(End::P1, plane, r, raises, u_min),
            Event::Leave {
                plane,
                r,
                lowers,
                u_max,
            } => state.bound(End::P2, plane, r, lowers, u_max),
            Event::Parallel { .. } => state.keep(),
            Event::Interval { .. } => {}
            Event::Put { end, at, .. } => state.put[end.idx()] = Some(at),
            Event::Accept { ends } => state.verdict = Some(Some(ends)),
            Event::Reject { .. } => state.verdict = Some(None),
        }
    }

    fn finish(state: &Self::State) -> VisibleLine<N> {
        state.verdict.flatten()
    }

    /// What begins; three for each plane; two ends; a verdict.
    fn max_events(input: &Self::Input) -> usize {
        1 + 3 * input.bounds.planes().count() + 2 + 1
    }
}

impl<P: Copy, const N: usize> LineState<P, N> {
    fn bound(&mut self, end: End, plane: P, r: f64, moves: bool, u: f64) {
        if let Some(row) = self.rows.last_mut() {
            row.r = Some(r);
        }
        self.interval[end.idx()] = u;
        if moves {
            self.set_by[end.idx()] = Some(plane);
        }
        self.keep();
    }

    fn keep(&mut self) {
        if let Some(row) = self.rows.last_mut() {
            row.left = Some(self.interval);
        }
    }
}

/// Raises u_min or lowers u_max to a parameter. False where nothing is left.
fn shrink<R: Real, P: Copy, const N: usize>(
    interval: &mut Interval<R, P>,
    param: Param<R, P>,
    plane: P,
    distances: impl Fn(P) -> [f64; 2],
    emit: &mut impl FnMut(LineEvent<P, N>),
) -> bool {
    use LineEvent as Event;
    let moves = interval.shrink(param, &distances, |_| false);
    let (r, [u_min, u_max]) = (param.u.get(), interval.values());
    emit(if param.leaving {
        let lowers = moves;
        Event::Leave {
            plane,
            r,
            lowers,
            u_max,
        }
    } else {
        let raises = moves;
        Event::Enter {
            plane,
            r,
            raises,
            u_min,
        }
    });
    let empty = interval.is_empty(distances);
    emit(Event::Interval {
        u_min,
        u_max,
        empty,
    });
    !empty
}
