//! Liang–Barsky: clip the parameter interval, not the points.
//!
//! A point P(u) = P₁ + u (P₂ − P₁) is inside the window where four inequalities `u·p ≤ q` hold:
//!
//! ```text
//!   k  side     p     q                p < 0: the line comes in here,  u ≥ r = q/p
//!   1  left    −Δx    x₁ − xmin        p > 0: it goes out here,        u ≤ r
//!   2  right    Δx    xmax − x₁        p = 0: parallel; inside if q ≥ 0
//!   3  bottom  −Δy    y₁ − ymin
//!   4  top      Δy    ymax − y₁        0 ──[u_min ━━━━━ u_max]── 1
//! ```
//!
//! 1. Start with the whole segment: u_min = 0, u_max = 1.
//! 2. For each side, compute p and q. Parallel and outside (p = 0, q < 0): reject. Otherwise r = q/p
//!    raises u_min or lowers u_max.
//! 3. Reject as soon as u_min > u_max. Otherwise the answer is P(u_min) to P(u_max).
//!
//! u_min = u_max is one point, on the border: a touch, accepted. `max`, `min` and `>` on parameters are
//! exact ([`Param::compare`]); an end is put on the border that set its parameter, and at a touched corner
//! both ends are that corner.
//!
//! *Conventions*: closed window, y up. *Degenerate*: a point has all p = 0 and is accepted if all q ≥ 0.
//! *Bound*: four rows. *Cost*: at most 14 +, 4 ×, 6 ÷ and 29 comparisons.
//!
//! *Source*: You-Dong Liang and Brian A. Barsky, "A New Concept and Method for Line Clipping", ACM
//! Transactions on Graphics 3(1), 1984, pp. 1–22, doi:10.1145/357332.357333.
//!
//! ```
//! use clipscope::{algo::line::{LiangBarsky, WindowInput}, geom::{Segment, Window}, trace::silent};
//! let window = Window::new(-1.0, -1.0, 1.0, 1.0)?;
//! let segment = Segment::new(-2.0, -1.0, 2.0, 1.5)?;
//! assert_eq!(
//!     silent::<LiangBarsky>(&WindowInput { window, segment }),
//!     Some(Segment::new(-1.0, -0.375, 1.0, 0.875)?),
//! );
//! # Ok::<(), clipscope::geom::GeomError>(())
//! ```

use serde::Serialize;

use crate::{
    geom::{Edge, Point, Segment},
    trace::{Algorithm, Real},
};

use super::{
    super::parameter::{Interval, Param},
    End, Visible, WindowInput,
    crossing::{corner_between, on_border, signed_distances, upright},
    segment_between,
};

/// The algorithm; see the module.
#[derive(Clone, Copy, Debug)]
pub struct LiangBarsky;

/// What happens, in order.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum LiangBarskyEvent {
    /// The differences Δx and Δy.
    Delta {
        /// x₂ − x₁
        dx: f64,
        /// y₂ − y₁
        dy: f64,
    },
    /// One inequality `u·p ≤ q`.
    Row {
        /// The side.
        edge: Edge,
        /// Which way the line goes: into the window where negative.
        p: f64,
        /// How far P₁ lies inside the side.
        q: f64,
    },
    /// p = 0: this side alone decides nothing if `inside`, everything if not.
    Parallel {
        /// The side.
        edge: Edge,
        /// The row's q.
        q: f64,
        /// q ≥ 0
        inside: bool,
    },
    /// The line comes in across this side.
    Enter {
        /// The side.
        edge: Edge,
        /// q / p
        r: f64,
        /// Does it raise u_min?
        raises: bool,
        /// From now on.
        u_min: f64,
    },
    /// The line goes out across this side.
    Leave {
        /// The side.
        edge: Edge,
        /// q / p
        r: f64,
        /// Does it lower u_max?
        lowers: bool,
        /// From now on.
        u_max: f64,
    },
    /// Is anything left of the interval?
    Interval {
        /// Where it begins.
        u_min: f64,
        /// Where it ends.
        u_max: f64,
        /// u_min > u_max
        empty: bool,
    },
    /// An end is put at its parameter.
    Put {
        /// Which end.
        end: End,
        /// u_min or u_max.
        u: f64,
        /// The side that set it; `None` where the end was inside and stays.
        edge: Option<Edge>,
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
        /// The side at which it was decided.
        edge: Edge,
    },
}

/// One line of the table.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Row {
    /// The side.
    pub edge: Edge,
    /// −Δ or Δ.
    pub p: f64,
    /// Signed distance of P₁.
    pub q: f64,
    /// q / p, where there is one.
    pub r: Option<f64>,
    /// u_min and u_max after it, once known.
    pub left: Option<[f64; 2]>,
}

/// What the picture of a step needs.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct LiangBarskyState {
    /// Δx and Δy, once known.
    pub delta: Option<[f64; 2]>,
    /// The table, by k − 1.
    pub rows: [Option<Row>; 4],
    /// The interval.
    pub interval: [f64; 2],
    /// The sides that set it.
    pub set_by: [Option<Edge>; 2],
    /// Ends already put in place.
    pub ends: [Option<Point>; 2],
    /// The answer, once known.
    pub verdict: Option<Visible>,
}

impl Algorithm for LiangBarsky {
    type Input = WindowInput;
    type Output = Visible;
    type Event = LiangBarskyEvent;
    type State = LiangBarskyState;

    fn run<R: Real>(input: &Self::Input, mut emit: impl FnMut(Self::Event)) -> Visible {
        use LiangBarskyEvent as Event;
        let WindowInput { window, segment } = input;
        let [x1, y1] = segment.p1.to_array().map(R::new);
        let [x2, y2] = segment.p2.to_array().map(R::new);
        let (dx, dy) = (x2 - x1, y2 - y1);
        emit(Event::Delta {
            dx: dx.get(),
            dy: dy.get(),
        });
        let mut interval = Interval::whole();
        for edge in Edge::ALL {
            let border = R::new(window.border(edge));
            let (p, q) = match edge {
                Edge::Left => (-dx, x1 - border),
                Edge::Right => (dx, border - x1),
                Edge::Bottom => (-dy, y1 - border),
                Edge::Top => (dy, border - y1),
            };
            let row = Event::Row {
                edge,
                // −Δ of a Δ of zero is shown without a sign.
                p: p.get() + 0.0,
                q: q.get(),
            };
            emit(row);
            let visible = if p == R::new(0.0) {
                let inside = q >= R::new(0.0);
                let q = q.get();
                emit(Event::Parallel { edge, q, inside });
                inside
            } else {
                shrink(&mut interval, Inequality { edge, p, q }, input, &mut emit)
            };
            if !visible {
                emit(Event::Reject { edge });
                return None;
            }
        }
        let corner = touched_corner(&interval, input);
        let ends =
            End::BOTH.map(|end| put(end, &interval.bounds[end.idx()], corner, input, &mut emit));
        let segment = segment_between(ends);
        emit(Event::Accept { segment });
        Some(segment)
    }

    fn start(_: &Self::Input) -> Self::State {
        LiangBarskyState {
            delta: None,
            rows: [None; 4],
            interval: [0.0, 1.0],
            set_by: [None; 2],
            ends: [None; 2],
            verdict: None,
        }
    }

    fn apply(state: &mut Self::State, event: Self::Event) {
        use LiangBarskyEvent as Event;
        match event {
            Event::Delta { dx, dy } => state.delta = Some([dx, dy]),
            Event::Row { edge, p, q } => {
                let (r, left) = (None, None);
                state.rows[edge as usize] = Some(Row {
                    edge,
                    p,
                    q,
                    r,
                    left,
                });
            }
            Event::Enter {
                edge,
                r,
                raises,
                u_min,
            } => state.bound(End::P1, edge, r, raises, u_min),
            Event::Leave {
                edge,
                r,
                lowers,
                u_max,
            } => state.bound(End::P2, edge, r, lowers, u_max),
            Event::Put { end, at, .. } => state.ends[end.idx()] = Some(at),
            Event::Accept { segment } => state.verdict = Some(Some(segment)),
            Event::Reject { .. } => state.verdict = Some(None),
            Event::Parallel { edge, .. } => state.keep(edge),
            Event::Interval { .. } => {}
        }
    }

    fn finish(state: &Self::State) -> Visible {
        state.verdict.flatten()
    }

    /// Δ; three for each of four rows; two ends; a verdict.
    fn max_events(_: &Self::Input) -> usize {
        1 + 4 * 3 + 2 + 1
    }
}

impl LiangBarskyState {
    fn bound(&mut self, end: End, edge: Edge, r: f64, moves: bool, u: f64) {
        if let Some(row) = &mut self.rows[edge as usize] {
            row.r = Some(r);
        }
        self.interval[end.idx()] = u;
        if moves {
            self.set_by[end.idx()] = Some(edge);
        }
        self.keep(edge);
    }

    fn keep(&mut self, edge: Edge) {
        if let Some(row) = &mut self.rows[edge as usize] {
            row.left = Some(self.interval);
        }
    }
}

/// `u·p ≤ q` for one side, with p ≠ 0.
#[derive(Clone, Copy)]
struct Inequality<R> {
    edge: Edge,
    p: R,
    q: R,
}

/// Raises u_min or lowers u_max to q/p. False where nothing is left.
fn shrink<R: Real>(
    interval: &mut Interval<R, Edge>,
    Inequality { edge, p, q }: Inequality<R>,
    WindowInput { window, segment }: &WindowInput,
    emit: &mut impl FnMut(LiangBarskyEvent),
) -> bool {
    use LiangBarskyEvent as Event;
    let leaving = p > R::new(0.0);
    let param = Param {
        u: upright(segment, window, edge).quotient(q, p),
        border: Some(edge),
        leaving,
    };
    let distances = |edge| signed_distances(segment, window, edge);
    let moves = interval.shrink(param, distances, |_| false);
    let (r, [u_min, u_max]) = (param.u.get(), interval.values());
    emit(if leaving {
        let lowers = moves;
        Event::Leave {
            edge,
            r,
            lowers,
            u_max,
        }
    } else {
        let raises = moves;
        Event::Enter {
            edge,
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

/// The corner that the line touches: there it comes in across one side and goes out across the other.
fn touched_corner<R: Real>(
    interval: &Interval<R, Edge>,
    WindowInput { window, segment }: &WindowInput,
) -> Option<Point> {
    let edges = interval.borders()?;
    let is_touch = interval.is_touch(|edge| signed_distances(segment, window, edge));
    is_touch.then(|| corner_between(window, edges))?
}

/// P(u), on the border that set u.
fn put<R: Real>(
    end: End,
    param: &Param<R, Edge>,
    corner: Option<Point>,
    WindowInput { window, segment }: &WindowInput,
    emit: &mut impl FnMut(LiangBarskyEvent),
) -> Point {
    let at = match (param.border, corner) {
        (None, _) => end.of(segment),
        (Some(_), Some(corner)) => corner,
        (Some(edge), None) => on_border::<R>(segment, window, edge),
    };
    emit(LiangBarskyEvent::Put {
        end,
        u: param.u.get(),
        edge: param.border,
        at,
    });
    at
}
