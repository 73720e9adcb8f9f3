//! Cohen–Sutherland in space: six bits instead of four, 27 regions instead of nine.
//!
//! ```text
//!        ┌──────┬──────┬──────┐           one bit a face, written far near top bottom right left
//!       ╱ 1001 ╱ 1000 ╱ 1010 ╱│
//!      ├──────┼──────┼──────┤ ╱│          before zmin each of the nine codes has 01 in front,
//!     ╱ 0001 ╱ 0000 ╱ 0010 ╱│╱ │          behind zmax 10, between the two 00
//!    ├──────┼──────┼──────┤ ╱│╱
//!   ╱ 0101 ╱ 0100 ╱ 0110 ╱│╱              OR  = 000000  both ends inside: accept
//!  └──────┴──────┴──────┘ ╱               AND ≠ 000000  both beyond one face: reject
//! ```
//!
//! 1. Give both ends a code.
//! 2. Accept or reject by OR and AND where that is possible.
//! 3. Take the lowest bit set in the OR. As the AND is 0, exactly one end has it: the segment crosses that face. Replace that
//!    end by the crossing, give it a new code, go to 2.
//!
//! As in the plane ([`crate::algo::line::CohenSutherland`]) the face is taken from the OR of both codes, crossings come from the
//! ends as they were given, and a cut end is kept within what is left.
//!
//! *Conventions*: closed box, near is zmin. *Degenerate*: a point is accepted or rejected by its codes; a touch is accepted.
//! *Bound*: each cut clears a bit of the OR for good, so there are at most 6. *Cost*: 12 comparisons for the codes; 5 +, 4 ×,
//! 2 ÷ and 12 comparisons a cut.
//!
//! *Source*: Newman and Sproull, *Principles of Interactive Computer Graphics*, 1973, pp. 123–124; in three dimensions J. D.
//! Foley and A. van Dam, *Fundamentals of Interactive Computer Graphics*, 1982, section 8.4.
//!
//! ```
//! use clipscope::{
//!     algo::volume::{CohenSutherland3d, CohenSutherland3dInput},
//!     geom::AlignedBox,
//!     trace::silent,
//! };
//! let bounds = AlignedBox::new([-1.0, -1.0, -1.0, 1.0, 1.0, 1.0])?;
//! let ends = [[-2.0, 0.0, 0.0], [0.0, 0.0, 2.0]];
//! let visible = silent::<CohenSutherland3d>(&CohenSutherland3dInput { bounds, ends });
//! assert_eq!(visible, Some([[-1.0, 0.0, 1.0]; 2]), "it touches an edge of the box");
//! # Ok::<(), clipscope::geom::SpaceError>(())
//! ```

use serde::Serialize;

use crate::{
    algo::parameter::{End, Ratio, clamp_between},
    geom::{AlignedBox, VolumeSide},
    trace::{Algorithm, Real},
};

use super::{SideCode, VisibleLine, liang_barsky_3d::upright};

/// The algorithm; see the module.
#[derive(Clone, Copy, Debug)]
pub struct CohenSutherland3d;

/// What to clip, and against what.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CohenSutherland3dInput {
    /// Closed.
    pub bounds: AlignedBox,
    /// P₁ and P₂, finite.
    pub ends: [[f64; 3]; 2],
}

/// What happens, in order.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum CohenSutherland3dEvent {
    /// An end gets its code.
    Code {
        /// Which end.
        end: End,
        /// Where it lies now.
        at: [f64; 3],
        /// Its code.
        code: SideCode,
    },
    /// Both codes are OR-ed: accept if 000000.
    Or {
        /// code₁ OR code₂
        or: SideCode,
    },
    /// Both codes are AND-ed: reject unless 000000.
    And {
        /// code₁ AND code₂
        and: SideCode,
    },
    /// The face to cut against next.
    Choose {
        /// The end that lies beyond it.
        end: End,
        /// The face of the lowest bit set in the OR.
        side: VolumeSide,
    },
    /// An end moves to the crossing.
    Cut {
        /// Which end.
        end: End,
        /// The face that is crossed.
        side: VolumeSide,
        /// Where on the original segment.
        u: Ratio,
        /// From where.
        from: [f64; 3],
        /// To where.
        to: [f64; 3],
    },
    /// What is left is visible.
    Accept {
        /// The visible part.
        ends: [[f64; 3]; 2],
    },
    /// Nothing is visible.
    Reject {
        /// The faces that both ends lie beyond.
        and: SideCode,
    },
}

/// What the picture of a step needs.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CohenSutherland3dState {
    /// The ends of what is left.
    pub ends: [[f64; 3]; 2],
    /// Their codes, once known.
    pub codes: [Option<SideCode>; 2],
    /// The last OR, until a code changes.
    pub or: Option<SideCode>,
    /// The last AND, until a code changes.
    pub and: Option<SideCode>,
    /// The cut that is about to be made, or was made last.
    pub cut: Option<(End, VolumeSide)>,
    /// Where the segment was cut, in the order of the cuts.
    pub cuts: [Option<[f64; 3]>; 6],
    /// The answer, once known.
    pub verdict: Option<VisibleLine<3>>,
}

impl Algorithm for CohenSutherland3d {
    type Input = CohenSutherland3dInput;
    type Output = VisibleLine<3>;
    type Event = CohenSutherland3dEvent;
    type State = CohenSutherland3dState;

    fn run<R: Real>(input: &Self::Input, mut emit: impl FnMut(Self::Event)) -> VisibleLine<3> {
        use CohenSutherland3dEvent as Event;
        let CohenSutherland3dInput {
            bounds,
            ends: given,
        } = input;
        let mut ends = *given;
        let mut codes = End::BOTH.map(|end| code::<R>(end, &ends, bounds, &mut emit));
        loop {
            let or = codes[0].or(codes[1]);
            emit(Event::Or { or });
            let Some(side) = or.lowest() else {
                emit(Event::Accept { ends });
                return Some(ends);
            };
            let and = codes[0].and(codes[1]);
            emit(Event::And { and });
            if !and.is_inside() {
                emit(Event::Reject { and });
                return None;
            }
            let end = if codes[0].has(side) { End::P1 } else { End::P2 };
            emit(Event::Choose { end, side });
            let share = upright(bounds, side, given).share::<R>();
            let from = ends[end.idx()];
            let to = std::array::from_fn(|axis| {
                if axis == side.axis() {
                    return bounds.border(side);
                }
                let mean = share.mean(given[0][axis], given[1][axis]);
                clamp_between(mean, ends[0][axis], ends[1][axis])
            });
            let u = share.ratio(true);
            ends[end.idx()] = to;
            emit(Event::Cut {
                end,
                side,
                u,
                from,
                to,
            });
            codes[end.idx()] = code::<R>(end, &ends, bounds, &mut emit);
        }
    }

    fn start(input: &Self::Input) -> Self::State {
        CohenSutherland3dState {
            ends: input.ends,
            codes: [None; 2],
            or: None,
            and: None,
            cut: None,
            cuts: [None; 6],
            verdict: None,
        }
    }

    fn apply(state: &mut Self::State, event: Self::Event) {
        use CohenSutherland3dEvent as Event;
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
            Event::Choose { end, side } => state.cut = Some((end, side)),
            Event::Cut { end, side, to, .. } => {
                state.ends[end.idx()] = to;
                state.codes[end.idx()] = None;
                state.cut = Some((end, side));
                if let Some(next) = state.cuts.iter_mut().find(|cut| cut.is_none()) {
                    *next = Some(to);
                }
            }
            Event::Accept { ends } => state.verdict = Some(Some(ends)),
            Event::Reject { .. } => state.verdict = Some(None),
        }
    }

    fn finish(state: &Self::State) -> VisibleLine<3> {
        state.verdict.flatten()
    }

    /// Two codes; at most six rounds of OR, AND, choice, cut and code; OR and AND; a verdict.
    fn max_events(_: &Self::Input) -> usize {
        2 + 6 * 5 + 2 + 1
    }
}

fn code<R: Real>(
    end: End,
    ends: &[[f64; 3]; 2],
    bounds: &AlignedBox,
    emit: &mut impl FnMut(CohenSutherland3dEvent),
) -> SideCode {
    let at = ends[end.idx()];
    let code = SideCode::of_box(at.map(R::new), bounds);
    emit(CohenSutherland3dEvent::Code { end, at, code });
    code
}
