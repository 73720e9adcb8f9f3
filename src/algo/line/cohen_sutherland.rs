//! Cohen–Sutherland: decide by outcodes first, cut only what they leave open.
//!
//! ```text
//!    1001 │ 1000 │ 1010        one bit a side: top bottom right left
//!   ──────┼──────┼──────       OR  = 0000  both ends inside: accept
//!    0001 │ 0000 │ 0010        AND ≠ 0000  both beyond one side: reject
//!   ──────┼──────┼──────       otherwise   cut at the side of the lowest bit
//!    0101 │ 0100 │ 0110                    set, and look again
//! ```
//!
//! 1. Give both ends a code.
//! 2. Accept or reject by OR and AND where that is possible.
//! 3. Take the lowest bit set in the OR. As the AND is 0, exactly one end has it: the segment crosses that
//!    side. Replace that end by the crossing, give it a new code, go to 2.
//!
//! The side is chosen from the OR of both codes, not from "the first end that is outside": then the cuts
//! do not depend on the direction of the segment. Crossings are computed from the original ends, so that
//! no rounding piles up, and kept within the part that is left, so that a bit once cleared stays clear.
//!
//! *Conventions*: closed window, y up. *Degenerate*: a point is accepted or rejected by its codes; a touch
//! is accepted. *Bound*: each cut clears a bit of the OR for good, so there are at most 4. *Cost*: 8
//! comparisons for the codes; 4 +, 2 ×, 1 ÷ and 7 comparisons a cut.
//!
//! *Source*: Danny Cohen and Ivan Sutherland, 1967; first printed in W. M. Newman and R. F. Sproull,
//! *Principles of Interactive Computer Graphics*, 1973, pp. 123–124.
//!
//! ```
//! use clipscope::{algo::line::{BitOrder, CohenSutherland, CohenSutherlandInput}, geom::{Segment, Window}, trace::silent};
//! let window = Window::new(-1.0, -1.0, 1.0, 1.0)?;
//! let segment = Segment::new(-2.0, -1.0, 2.0, 1.5)?;
//! let input = CohenSutherlandInput { window, segment, bit_order: BitOrder::Tbrl };
//! assert_eq!(silent::<CohenSutherland>(&input), Some(Segment::new(-1.0, -0.375, 1.0, 0.875)?));
//! # Ok::<(), clipscope::geom::GeomError>(())
//! ```

use serde::Serialize;

use crate::{
    geom::{Edge, Point, Segment, Window},
    trace::{Algorithm, Real},
};

use super::{
    super::parameter::clamp_between,
    BitOrder, End, Outcode, Ratio, Visible,
    crossing::{crossing_at, join, split},
    segment_between,
};

/// The algorithm; see the module.
#[derive(Clone, Copy, Debug)]
pub struct CohenSutherland;

/// What to clip, and how codes are written.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CohenSutherlandInput {
    /// Closed.
    pub window: Window,
    /// Directed from P₁ to P₂.
    pub segment: Segment,
    /// Also the order of the cuts: lowest bit first.
    pub bit_order: BitOrder,
}

/// What happens, in order.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum CohenSutherlandEvent {
    /// An end gets its code.
    Code {
        /// Which end.
        end: End,
        /// Where it lies now.
        at: Point,
        /// Its code.
        code: Outcode,
    },
    /// Both codes are OR-ed: accept if 0000.
    Or {
        /// code₁ OR code₂
        or: Outcode,
    },
    /// Both codes are AND-ed: reject unless 0000.
    And {
        /// code₁ AND code₂
        and: Outcode,
    },
    /// The side to cut against next.
    Choose {
        /// The end that lies beyond it.
        end: End,
        /// The side of the lowest bit set in the OR.
        edge: Edge,
    },
    /// An end moves to the crossing.
    Cut {
        /// Which end.
        end: End,
        /// The side that is crossed.
        edge: Edge,
        /// Where on the original segment.
        u: Ratio,
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
        /// The sides that both ends lie beyond.
        and: Outcode,
    },
}

/// What the picture of a step needs.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CohenSutherlandState {
    /// The ends of what is left.
    pub ends: [Point; 2],
    /// Their codes, once known.
    pub codes: [Option<Outcode>; 2],
    /// The last OR, until a code changes.
    pub or: Option<Outcode>,
    /// The last AND, until a code changes.
    pub and: Option<Outcode>,
    /// The cut that is about to be made, or was made last.
    pub cut: Option<(End, Edge)>,
    /// Where the segment was cut, in the order of the cuts.
    pub cuts: [Option<Point>; 4],
    /// The answer, once known.
    pub verdict: Option<Visible>,
}

impl Algorithm for CohenSutherland {
    type Input = CohenSutherlandInput;
    type Output = Visible;
    type Event = CohenSutherlandEvent;
    type State = CohenSutherlandState;

    fn run<R: Real>(input: &Self::Input, mut emit: impl FnMut(Self::Event)) -> Visible {
        use CohenSutherlandEvent as Event;
        let CohenSutherlandInput {
            window,
            segment,
            bit_order: order,
        } = *input;
        let mut ends = [segment.p1, segment.p2];
        let mut codes = End::BOTH.map(|end| code::<R>(end, &ends, &window, order, &mut emit));
        loop {
            let or = codes[0].or(codes[1]);
            emit(Event::Or { or });
            let Some(edge) = or.lowest(order) else {
                let segment = segment_between(ends);
                emit(Event::Accept { segment });
                return Some(segment);
            };
            let and = codes[0].and(codes[1]);
            emit(Event::And { and });
            if !and.is_inside() {
                emit(Event::Reject { and });
                return None;
            }
            let end = if codes[0].has(edge, order) {
                End::P1
            } else {
                End::P2
            };
            emit(Event::Choose { end, edge });
            let border = window.border(edge);
            let cut = crossing_at::<R>(&segment, edge.axis(), border);
            let [[_, free1], [_, free2]] = ends.map(|p| split::<R>(p, edge.axis()));
            let free = clamp_between(cut.free, free1, free2);
            let from = ends[end.idx()];
            let to = join(edge.axis(), R::new(border), free);
            let [num, den] = cut.ratio.map(R::get);
            let u = Ratio { num, den };
            ends[end.idx()] = to;
            emit(Event::Cut {
                end,
                edge,
                u,
                from,
                to,
            });
            codes[end.idx()] = code::<R>(end, &ends, &window, order, &mut emit);
        }
    }

    fn start(input: &Self::Input) -> Self::State {
        CohenSutherlandState {
            ends: [input.segment.p1, input.segment.p2],
            codes: [None; 2],
            or: None,
            and: None,
            cut: None,
            cuts: [None; 4],
            verdict: None,
        }
    }

    fn apply(state: &mut Self::State, event: Self::Event) {
        use CohenSutherlandEvent as Event;
        match event {
            Event::Code { end, code, .. } => {
                state.codes[end.idx()] = Some(code);
                (state.or, state.and) = (None, None);
            }
            Event::Or { or } => {
                state.or = Some(or);
                state.cut = None;
            }
            Event::And { and } => state.and = Some(and),
            Event::Choose { end, edge } => state.cut = Some((end, edge)),
            Event::Cut { end, edge, to, .. } => {
                state.ends[end.idx()] = to;
                state.codes[end.idx()] = None;
                state.cut = Some((end, edge));
                if let Some(next) = state.cuts.iter_mut().find(|cut| cut.is_none()) {
                    *next = Some(to);
                }
            }
            Event::Accept { segment } => state.verdict = Some(Some(segment)),
            Event::Reject { .. } => state.verdict = Some(None),
        }
    }

    fn finish(state: &Self::State) -> Visible {
        state.verdict.flatten()
    }

    /// Two codes; at most four rounds of OR, AND, choice, cut and code; OR and AND; a verdict.
    fn max_events(_: &Self::Input) -> usize {
        2 + 4 * 5 + 2 + 1
    }
}

fn code<R: Real>(
    end: End,
    ends: &[Point; 2],
    window: &Window,
    order: BitOrder,
    emit: &mut impl FnMut(CohenSutherlandEvent),
) -> Outcode {
    let at = ends[end.idx()];
    let code = Outcode::of::<R>(at.to_array().map(R::new), window, order);
    emit(CohenSutherlandEvent::Code { end, at, code });
    code
}
