//! Brute force: intersect with all four sides, whether needed or not.
//!
//! ```text
//!        ┊       ┊
//!   ┄┄┄┄┄┼───────┼┄×┄┄     every side is a line, and every line that is not parallel to
//!        │     ╱ │         the segment has a crossing with it: four divisions, of which
//!   ┄┄┄┄┄┼───×───×┄┄┄┄     at most two are of any use
//!        ┊ ╱     ┊
//!       ×┊       ┊
//! ```
//!
//! 1. For each side, compute the crossing of the segment's line with the side's line.
//! 2. Both ends of what is left beyond the side: reject. One: it moves to the crossing. None: the crossing
//!    was computed in vain.
//!
//! *Conventions*: closed window, y up. *Degenerate*: a segment parallel to a side has no crossing; a touch
//! is accepted. *Bound*: four sides. *Cost*: at most 16 +, 8 ×, 4 ÷ and 24 comparisons.
//!
//! *Source*: the method that every textbook starts from; D. F. Rogers, *Procedural Elements for Computer
//! Graphics*, 2nd ed. 1998, §3-1.
//!
//! ```
//! use clipscope::{algo::line::{BruteForce, WindowInput}, geom::{Segment, Window}, trace::silent};
//! let window = Window::new(-1.0, -1.0, 1.0, 1.0)?;
//! let corner = Segment::new(-2.0, 0.0, 0.0, 2.0)?;
//! let touch = Segment::new(-1.0, 1.0, -1.0, 1.0)?;
//! assert_eq!(silent::<BruteForce>(&WindowInput { window, segment: corner }), Some(touch));
//! # Ok::<(), clipscope::geom::GeomError>(())
//! ```

use serde::Serialize;

use crate::{
    geom::{Edge, Point, Segment, Window},
    trace::{Algorithm, Real},
};

use super::{
    super::parameter::clamp_between,
    End, Ratio, Visible, WindowInput,
    crossing::{Crossing, crossing, join, split},
    segment_between,
};

/// The algorithm; see the module.
#[derive(Clone, Copy, Debug)]
pub struct BruteForce;

/// What happens, in order.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum BruteForceEvent {
    /// The line meets a side's line.
    Intersect {
        /// The side.
        edge: Edge,
        /// Where on the original segment; outside [0, 1] beyond its ends.
        u: Ratio,
        /// Where in the plane.
        at: Point,
    },
    /// It does not: the two are parallel.
    Parallel {
        /// The side.
        edge: Edge,
    },
    /// Both ends lie inside this side: the crossing is not needed.
    Keep {
        /// The side.
        edge: Edge,
    },
    /// An end moves to the crossing.
    Cut {
        /// Which end.
        end: End,
        /// The side.
        edge: Edge,
        /// From where.
        from: Point,
        /// To where.
        to: Point,
    },
    /// What is left is visible.
    Accept {
        /// The visible part.
        segment: Segment,
    },
    /// Nothing is visible.
    Reject {
        /// The side that both ends lie beyond.
        edge: Edge,
    },
}

/// What a crossing was good for.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum CrossingFate {
    /// There is none.
    Parallel,
    /// It was not needed, or not in the end.
    InVain,
    /// This end stands on it.
    Replaces(End),
}

/// What the picture of a step needs.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct BruteForceState {
    /// The ends of what is left.
    pub ends: [Point; 2],
    /// The side in hand.
    pub edge: Option<Edge>,
    /// The crossings so far, by side, with the parameter.
    pub crossings: [Option<(Point, Ratio)>; 4],
    /// What became of the crossings, by side, once it is decided.
    pub fates: [Option<CrossingFate>; 4],
    /// The answer, once known.
    pub verdict: Option<Visible>,
}

impl Algorithm for BruteForce {
    type Input = WindowInput;
    type Output = Visible;
    type Event = BruteForceEvent;
    type State = BruteForceState;

    fn run<R: Real>(input: &Self::Input, mut emit: impl FnMut(Self::Event)) -> Visible {
        use BruteForceEvent as Event;
        let WindowInput { window, segment } = input;
        let mut ends = [segment.p1, segment.p2];
        for edge in Edge::ALL {
            let crossing = intersect::<R>(segment, window, edge, &mut emit);
            let beyond = ends.map(|p| is_beyond::<R>(p, window, edge));
            let end = match beyond {
                [true, true] => {
                    emit(Event::Reject { edge });
                    return None;
                }
                [false, false] => {
                    emit(Event::Keep { edge });
                    continue;
                }
                [true, false] => End::P1,
                [false, true] => End::P2,
            };
            // One end beyond and one not: not parallel.
            let Some(crossing) = crossing else { continue };
            let [[_, free1], [_, free2]] = ends.map(|p| split::<R>(p, edge.axis()));
            let free = clamp_between(crossing.free, free1, free2);
            let to = join(edge.axis(), R::new(window.border(edge)), free);
            let from = std::mem::replace(&mut ends[end.idx()], to);
            emit(Event::Cut {
                end,
                edge,
                from,
                to,
            });
        }
        let segment = segment_between(ends);
        emit(Event::Accept { segment });
        Some(segment)
    }

    fn start(input: &Self::Input) -> Self::State {
        BruteForceState {
            ends: [input.segment.p1, input.segment.p2],
            edge: None,
            crossings: [None; 4],
            fates: [None; 4],
            verdict: None,
        }
    }

    fn apply(state: &mut Self::State, event: Self::Event) {
        use BruteForceEvent as Event;
        match event {
            Event::Intersect { edge, u, at } => {
                state.edge = Some(edge);
                state.crossings[edge as usize] = Some((at, u));
            }
            Event::Parallel { edge } => {
                state.edge = Some(edge);
                state.fates[edge as usize] = Some(CrossingFate::Parallel);
            }
            Event::Keep { edge } => {
                state.edge = Some(edge);
                state.fates[edge as usize].get_or_insert(CrossingFate::InVain);
            }
            Event::Cut { end, edge, to, .. } => {
                state.ends[end.idx()] = to;
                // The crossing that this end stood on until now is of no use after all.
                for fate in state.fates.iter_mut().flatten() {
                    if *fate == CrossingFate::Replaces(end) {
                        *fate = CrossingFate::InVain;
                    }
                }
                state.fates[edge as usize] = Some(CrossingFate::Replaces(end));
            }
            Event::Accept { segment } => state.verdict = Some(Some(segment)),
            Event::Reject { .. } => state.verdict = Some(None),
        }
    }

    fn finish(state: &Self::State) -> Visible {
        state.verdict.flatten()
    }

    /// Two for each side, and a verdict.
    fn max_events(_: &Self::Input) -> usize {
        4 * 2 + 1
    }
}

/// The crossing with a side's line, needed or not; `None` where the two are parallel.
fn intersect<R: Real>(
    segment: &Segment,
    window: &Window,
    edge: Edge,
    emit: &mut impl FnMut(BruteForceEvent),
) -> Option<Crossing<R>> {
    let [a1, _] = split::<R>(segment.p1, edge.axis());
    let [a2, _] = split::<R>(segment.p2, edge.axis());
    if a1 == a2 {
        emit(BruteForceEvent::Parallel { edge });
        return None;
    }
    let crossing = crossing::<R>(segment, window, edge);
    let [num, den] = crossing.ratio.map(R::get);
    emit(BruteForceEvent::Intersect {
        edge,
        u: Ratio { num, den },
        at: join(
            edge.axis(),
            R::new(window.border(edge)),
            R::new(crossing.free.get().clamp(f64::MIN, f64::MAX)),
        ),
    });
    Some(crossing)
}

fn is_beyond<R: Real>(point: Point, window: &Window, edge: Edge) -> bool {
    let [a, _] = split::<R>(point, edge.axis());
    let c = R::new(window.border(edge));
    if edge.is_max() { a > c } else { a < c }
}
