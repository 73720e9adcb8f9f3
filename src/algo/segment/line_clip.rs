//! A segment against any planes, in any number of dimensions: P(u) = P₁ + u (P₂ − P₁) is inside a plane where `u·p ≤ q`, q being
//! how far P₁ lies inside, and p how much of that the way to P₂ takes away. What Liang and Barsky do with a window is the same
//! with the faces of a box, with oblique planes, and with the sides x = ±w of clip space: only p, q and the place of a crossing
//! differ ([`Bounds`]).
//!
//! *Exact*: `max`, `min` and `>` on parameters ([`Param::compare`]), so that a touch is told from nothing beyond rounding and
//! both directions decide alike; an end that was inside comes back bit for bit; swapping the ends swaps the answer's, bit for
//! bit. Where u_min = u_max both ends are the same point.
//!
//! *Source*: You-Dong Liang and Brian A. Barsky, "A New Concept and Method for Line Clipping", ACM Transactions on Graphics 3(1),
//! 1984, pp. 1–22, doi:10.1145/357332.357333; sections 5 and 6 have three dimensions and perspective.

use std::{fmt::Debug, marker::PhantomData};

use serde::Serialize;

use crate::{
    algo::{
        parameter::{End, Interval, Param},
        ring::Right,
    },
    trace::{Method, Real, Tell, Told},
};

use super::{Ends, LineAnswer, LineEvent, RowNumbers, VisibleLine};

/// An event of clipping against the bounds `B`.
pub type EventOf<const N: usize, B> = LineEvent<<B as Bounds<N>>::Plane, N, <B as Bounds<N>>::Row>;

/// What is easily got wrong. The values given here are right; [`crate::algo::volume::faulty`] and [`crate::algo::line::faulty`] have
/// the others.
pub trait LineRules: Copy + 'static {
    /// Are both ends divided by w before anything is clipped?
    const DIVIDES_FIRST: bool = false;
    /// Is what lies outside of each plane taken for its inside?
    const TURNS_NORMALS: bool = false;
    /// Is a line that runs parallel to a plane taken for inside, and nobody looks?
    const FORGETS_PARALLEL: bool = false;
}

impl LineRules for Right {}

/// What a segment of `N` coordinates is clipped against.
pub trait Bounds<const N: usize>: Clone + PartialEq + Debug + 'static {
    /// One of its planes. Of two that are crossed at the same place the lesser is that which the point is put on.
    type Plane: Copy + Ord + Send + Debug + Serialize + 'static;
    /// The numbers of a plane's row.
    type Row: RowNumbers + Send;
    /// What a program gives: a segment and these bounds.
    type Input: Given<N, Self> + Send;
    /// What it gets.
    type Output: LineAnswer<N>;

    /// In the order in which they are asked.
    fn planes(&self) -> impl Iterator<Item = Self::Plane>;

    /// Before the first plane: what is told, and P₂ − P₁ where it is worked out once for all planes; `None` where nothing can be
    /// visible. The wrong rules change the ends here.
    #[inline]
    fn begin<R: Real, L: LineRules>(
        &self,
        _ends: &mut Ends<N>,
    ) -> (Option<EventOf<N, Self>>, Option<[R; N]>) {
        (None, Some([R::new(0.0); N]))
    }

    /// p and q, and the row that shows them.
    fn inequality<R: Real>(
        &self,
        plane: Self::Plane,
        ends: &Ends<N>,
        delta: &[R; N],
    ) -> ([R; 2], Self::Row);

    /// q as an event shows it: a zero has no sign.
    #[must_use]
    fn shown(q: f64) -> f64 {
        q + 0.0
    }

    /// Does the line go out? p is not 0.
    fn is_leaving<R: Real>(p: R) -> bool {
        p > R::new(0.0)
    }

    /// q / p, p not being 0. A zero has no sign.
    #[inline]
    fn quotient<R: Real>(&self, _plane: Self::Plane, _ends: &Ends<N>, [p, q]: [R; 2]) -> R {
        R::new((q / p).get() + 0.0)
    }

    /// Signed distances of both ends, inside positive: their signs and their ratio count.
    fn distances(&self, plane: Self::Plane, ends: &Ends<N>) -> [f64; 2];

    /// Of two planes that are crossed at the same place the first sets the bound, unless the other wins.
    fn wins_tie(&self, _other: Self::Plane, _first: Self::Plane) -> bool {
        false
    }

    /// The two planes that meet where the line touches, which is all that is left of it.
    fn touched<R: Real>(
        &self,
        interval: &Interval<R, Self::Plane>,
        ends: &Ends<N>,
    ) -> Option<[Self::Plane; 2]> {
        let is_touch = interval.is_touch(|plane| self.distances(plane, ends));
        interval.borders().filter(|_| is_touch)
    }

    /// Where the segment crosses a plane, inside of all; and the `touched` one, where it meets both there.
    fn crossing<R: Real>(
        &self,
        plane: Self::Plane,
        touched: Option<Self::Plane>,
        ends: &Ends<N>,
    ) -> [f64; N];
}

/// What a program gives.
pub trait Given<const N: usize, B>: Clone + PartialEq + Debug + 'static {
    /// What is clipped against.
    fn bounds(&self) -> &B;

    /// P₁ and P₂, finite.
    fn ends(&self) -> Ends<N>;
}

/// The algorithm, against the bounds `B` and by the rules of `L`; see the module.
#[derive(Clone, Copy, Debug)]
pub struct LineClip<const N: usize, B, L = Right>(PhantomData<(B, L)>);

/// What is clipped, and against what.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct LineInput<const N: usize, B> {
    /// Closed.
    pub bounds: B,
    /// P₁ and P₂, finite.
    pub ends: Ends<N>,
}

impl<const N: usize, B: Bounds<N>> Given<N, B> for LineInput<N, B> {
    fn bounds(&self) -> &B {
        &self.bounds
    }

    fn ends(&self) -> Ends<N> {
        self.ends
    }
}

impl<const N: usize, B: Bounds<N>, L: LineRules> Method for LineClip<N, B, L> {
    type Input = B::Input;
    type Held = VisibleLine<N>;
    type Output = B::Output;
    type Event = EventOf<N, B>;

    #[inline]
    fn begin(_: &B::Input) -> VisibleLine<N> {
        None
    }

    #[inline]
    fn run<R: Real, T: Tell<Self>>(
        input: &B::Input,
        held: &mut VisibleLine<N>,
        tell: &mut T,
    ) -> Told<T::Stop> {
        use LineEvent as Event;
        let (bounds, mut ends) = (input.bounds(), input.ends());
        let (first, delta) = bounds.begin::<R, L>(&mut ends);
        if let Some(event) = first {
            tell.tell(held, event)?;
        }
        let Some(delta) = delta else {
            return tell.tell(held, Event::Reject { plane: None });
        };
        let distances = |plane| turned::<L>(bounds.distances(plane, &ends));
        let mut interval = Interval::whole();
        for plane in bounds.planes() {
            let ([mut p, mut q], mut row) = bounds.inequality(plane, &ends, &delta);
            if L::TURNS_NORMALS {
                ([p, q], row) = ([-p, -q], row.turned());
            }
            tell.tell(held, Event::Row { plane, row })?;
            let visible = if p == R::new(0.0) {
                let inside = L::FORGETS_PARALLEL || q >= R::new(0.0);
                let q = B::shown(q.get());
                tell.tell(held, Event::Parallel { plane, q, inside })?;
                inside
            } else {
                let param = Param {
                    u: bounds.quotient(plane, &ends, [p, q]),
                    border: Some(plane),
                    leaving: B::is_leaving(p),
                };
                let wins_tie = |first| bounds.wins_tie(plane, first);
                let moves = interval.shrink(param, distances, wins_tie);
                let [u_min, u_max] = interval.values();
                tell.tell(
                    held,
                    bound((plane, param.u.get()), param.leaving, moves, [u_min, u_max]),
                )?;
                let empty = interval.is_empty(distances);
                let left = Event::Interval {
                    u_min,
                    u_max,
                    empty,
                };
                tell.tell(held, left)?;
                !empty
            };
            if !visible {
                return tell.tell(held, Event::Reject { plane: Some(plane) });
            }
        }
        let visible = put::<N, B, L, R, T>(bounds, &ends, &interval, held, tell)?;
        *held = Some(visible);
        tell.tell(held, Event::Accept { ends: visible })
    }

    #[inline]
    fn output(held: VisibleLine<N>) -> B::Output {
        B::Output::of(held)
    }

    /// What begins; three for each plane; two ends; a verdict.
    fn max_events(input: &B::Input) -> usize {
        1 + 3 * input.bounds().planes().count() + 2 + 1
    }
}

/// From the side that the rules take for the inside.
#[inline]
fn turned<L: LineRules>(distances: [f64; 2]) -> [f64; 2] {
    if L::TURNS_NORMALS {
        distances.map(|d| -d)
    } else {
        distances
    }
}

/// A plane that is met at `r`, and the bound that it may have moved.
#[inline]
fn bound<P, const N: usize, W>(
    (plane, r): (P, f64),
    is_leaving: bool,
    moves: bool,
    [u_min, u_max]: [f64; 2],
) -> LineEvent<P, N, W> {
    if is_leaving {
        LineEvent::Leave {
            plane,
            r,
            lowers: moves,
            u_max,
        }
    } else {
        LineEvent::Enter {
            plane,
            r,
            raises: moves,
            u_min,
        }
    }
}

/// Both ends at their parameters; where the line only touches, both at the same point.
#[inline]
fn put<const N: usize, B, L, R, T>(
    bounds: &B,
    ends: &Ends<N>,
    interval: &Interval<R, B::Plane>,
    held: &VisibleLine<N>,
    tell: &mut T,
) -> Told<T::Stop, Ends<N>>
where
    B: Bounds<N>,
    L: LineRules,
    R: Real,
    T: Tell<LineClip<N, B, L>>,
{
    let touched = bounds.touched(interval, ends);
    let mut visible = *ends;
    for end in End::BOTH {
        let param = &interval.bounds[end.idx()];
        let at = match (param.border, touched) {
            (None, _) => ends[end.idx()],
            (Some(_), Some([a, b])) => bounds.crossing::<R>(a.min(b), Some(a.max(b)), ends),
            (Some(plane), None) => bounds.crossing::<R>(plane, None, ends),
        };
        visible[end.idx()] = at;
        let (u, plane) = (param.u.get(), param.border);
        tell.tell(held, LineEvent::Put { end, u, plane, at })?;
    }
    Told::Continue(visible)
}
