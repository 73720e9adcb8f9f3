//! A segment against upright borders, decided by codes as far as they decide: one bit a side. OR = 0: both ends are inside. AND ≠
//! 0: both lie beyond one side. Otherwise cut at the side of the lowest bit set in the OR, which exactly one end has, and look
//! again.
//!
//! The side is chosen from the OR of both codes, not from "the first end that is outside": then the cuts do not depend on the
//! direction of the segment. *Bound*: each cut clears a bit of the OR for good.

use std::{
    fmt::{Debug, Display},
    marker::PhantomData,
    ops::{BitAnd, BitOr},
};

use serde::{Serialize, Serializer};

use crate::{
    algo::{
        parameter::{End, Ratio},
        ring::Right,
    },
    trace::{Method, Real, Tell, Told},
};

use super::{Ends, Fields, LineAnswer, VisibleLine};

/// What is clipped by codes, and against what.
pub trait Coded<const N: usize>: Clone + Send + 'static {
    /// A side that an end may lie beyond.
    type Side: Copy + PartialEq + Debug + Serialize + Send + 'static;
    /// One bit for each of them.
    type Code: Copy
        + PartialEq
        + Default
        + Debug
        + Display
        + Serialize
        + BitOr<Output = Self::Code>
        + BitAnd<Output = Self::Code>
        + Send
        + 'static;
    /// The answer, as a program asks for it.
    type Output: LineAnswer<N>;
    /// How many sides there are.
    const N_SIDES: usize;

    /// P₁ and P₂.
    fn ends(&self) -> Ends<N>;

    /// The code of a point.
    fn code<R: Real>(&self, at: [f64; N]) -> Self::Code;

    /// The side of the lowest bit that is set.
    fn lowest(&self, code: Self::Code) -> Option<Self::Side>;

    /// Is the point of this code beyond a side?
    fn has(&self, code: Self::Code, side: Self::Side) -> bool;

    /// Where the segment crosses a side, kept within what is left, and where along the given segment that is.
    fn crossing<R: Real>(&self, side: Self::Side, left: &Ends<N>) -> ([f64; N], Ratio);
}

/// What is easily got wrong. What is given here is right; [`crate::algo::line::faulty`] has the others.
pub trait CodeRules<const N: usize, I: Coded<N>>: Copy + 'static {
    /// Is what is left after the first cut taken for visible?
    const CUTS_ONCE: bool = false;
    /// Is nothing visible where both ends are outside?
    const REJECTS_TWO_OUTSIDE: bool = false;

    /// Where the segment crosses a side.
    #[inline]
    fn crossing<R: Real>(input: &I, side: I::Side, left: &Ends<N>) -> ([f64; N], Ratio) {
        input.crossing::<R>(side, left)
    }
}

impl<const N: usize, I: Coded<N>> CodeRules<N, I> for Right {}

/// The algorithm on inputs of the kind `I`, by the rules of `L`; see the module.
#[derive(Clone, Copy, Debug)]
pub struct CodeClip<const N: usize, I, L = Right>(PhantomData<(I, L)>);

/// What happens, in order; `C` are codes, `S` sides.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum CodeEvent<const N: usize, C, S> {
    /// An end gets its code.
    Code {
        /// Which end.
        end: End,
        /// Where it lies now.
        at: [f64; N],
        /// Its code.
        code: C,
    },
    /// Both codes are OR-ed: accept if 0.
    Or {
        /// code₁ OR code₂
        or: C,
    },
    /// Both codes are AND-ed: reject unless 0.
    And {
        /// code₁ AND code₂
        and: C,
    },
    /// The side to cut against next.
    Choose {
        /// The end that lies beyond it.
        end: End,
        /// The side of the lowest bit set in the OR.
        side: S,
    },
    /// An end moves to the crossing.
    Cut {
        /// Which end.
        end: End,
        /// The side that is crossed.
        side: S,
        /// Where on the original segment.
        u: Ratio,
        /// From where.
        from: [f64; N],
        /// To where.
        to: [f64; N],
    },
    /// What is left is visible.
    Accept {
        /// The ends of the visible part.
        ends: Ends<N>,
    },
    /// Nothing is visible.
    Reject {
        /// The sides that both ends lie beyond.
        and: C,
    },
}

impl<const N: usize, C: Serialize, Side: Serialize> Serialize for CodeEvent<N, C, Side> {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let side_field = if N == 2 { "edge" } else { "side" };
        let fields = match self {
            Self::Code { end, at, code } => {
                let fields = Fields::of(to, "code")?.with("end", end)?;
                fields.with("at", &at[..])?.with("code", code)?
            }
            Self::Or { or } => Fields::of(to, "or")?.with("or", or)?,
            Self::And { and } => Fields::of(to, "and")?.with("and", and)?,
            Self::Choose { end, side } => {
                let fields = Fields::of(to, "choose")?.with("end", end)?;
                fields.with(side_field, side)?
            }
            Self::Cut {
                end,
                side,
                u,
                from,
                to: there,
            } => {
                let fields = Fields::of(to, "cut")?.with("end", end)?;
                let fields = fields.with(side_field, side)?.with("u", u)?;
                fields.with("from", &from[..])?.with("to", &there[..])?
            }
            Self::Accept { ends } => Fields::of(to, "accept")?.with_ends(ends)?,
            Self::Reject { and } => Fields::of(to, "reject")?.with("and", and)?,
        };
        fields.end()
    }
}

#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CodeHeld<const N: usize> {
    /// Of what is left.
    pub ends: Ends<N>,
    pub visible: VisibleLine<N>,
}

impl<const N: usize, I: Coded<N>, L: CodeRules<N, I>> Method for CodeClip<N, I, L> {
    type Input = I;
    type Held = CodeHeld<N>;
    type Output = I::Output;
    type Event = CodeEvent<N, I::Code, I::Side>;

    #[inline]
    fn begin(input: &I) -> CodeHeld<N> {
        CodeHeld {
            ends: input.ends(),
            visible: None,
        }
    }

    #[inline]
    fn run<R: Real, T: Tell<Self>>(
        input: &I,
        held: &mut CodeHeld<N>,
        tell: &mut T,
    ) -> Told<T::Stop> {
        let mut codes = [I::Code::default(); 2];
        for end in End::BOTH {
            codes[end.idx()] = code::<N, I, R, L, T>(end, input, held, tell)?;
        }
        let none = I::Code::default();
        let mut is_cut = false;
        loop {
            let or = codes[0] | codes[1];
            tell.tell(held, CodeEvent::Or { or })?;
            let Some(side) = input.lowest(or).filter(|_| !(L::CUTS_ONCE && is_cut)) else {
                let ends = held.ends;
                held.visible = Some(ends);
                return tell.tell(held, CodeEvent::Accept { ends });
            };
            let and = codes[0] & codes[1];
            tell.tell(held, CodeEvent::And { and })?;
            let two_outside = L::REJECTS_TWO_OUTSIDE && codes.iter().all(|&code| code != none);
            if and != none || two_outside {
                return tell.tell(held, CodeEvent::Reject { and });
            }
            let is_first = input.has(codes[0], side);
            let end = if is_first { End::P1 } else { End::P2 };
            tell.tell(held, CodeEvent::Choose { end, side })?;
            let (to, u) = L::crossing::<R>(input, side, &held.ends);
            let from = std::mem::replace(&mut held.ends[end.idx()], to);
            let cut = CodeEvent::Cut {
                end,
                side,
                u,
                from,
                to,
            };
            tell.tell(held, cut)?;
            codes[end.idx()] = code::<N, I, R, L, T>(end, input, held, tell)?;
            is_cut = true;
        }
    }

    #[inline]
    fn output(held: CodeHeld<N>) -> I::Output {
        I::Output::of(held.visible)
    }

    /// Two codes; at most one round of OR, AND, choice, cut and code a side; OR and AND; a verdict.
    fn max_events(_: &I) -> usize {
        2 + I::N_SIDES * 5 + 2 + 1
    }
}

#[inline]
fn code<const N: usize, I: Coded<N>, R: Real, L: CodeRules<N, I>, T: Tell<CodeClip<N, I, L>>>(
    end: End,
    input: &I,
    held: &CodeHeld<N>,
    tell: &mut T,
) -> Told<T::Stop, I::Code> {
    let at = held.ends[end.idx()];
    let code = input.code::<R>(at);
    tell.tell(held, CodeEvent::Code { end, at, code })?;
    Told::Continue(code)
}
