//! Brute force: intersect with all four sides, whether needed or not, and move an end that is beyond a side to its crossing.
//!
//! *Degenerate*: a segment parallel to a side has no crossing; a touch is accepted. *Bound*: four sides. *Cost*: at most 16 +, 8
//! ×, 4 ÷ and 24 comparisons. *Source*: the method that every textbook starts from; D. F. Rogers, *Procedural Elements for
//! Computer Graphics*, 2nd ed. 1998, §3-1.
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
    trace::{Method, Real, Tell, Told},
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

#[derive(Clone, Copy, PartialEq, Debug)]
pub struct BruteForceHeld {
    /// Of what is left.
    pub ends: [Point; 2],
    pub visible: Visible,
}

impl Method for BruteForce {
    type Input = WindowInput;
    type Held = BruteForceHeld;
    type Output = Visible;
    type Event = BruteForceEvent;

    #[inline]
    fn begin(input: &WindowInput) -> BruteForceHeld {
        BruteForceHeld {
            ends: [input.segment.p1, input.segment.p2],
            visible: None,
        }
    }

    #[inline]
    fn run<R: Real, T: Tell<Self>>(
        input: &WindowInput,
        held: &mut BruteForceHeld,
        tell: &mut T,
    ) -> Told<T::Stop> {
        use BruteForceEvent as Event;
        let WindowInput { window, segment } = input;
        for edge in Edge::ALL {
            let crossing = intersect::<R>(segment, window, edge);
            tell.tell(held, crossing_event(window, edge, crossing.as_ref()))?;
            let beyond = held.ends.map(|p| is_beyond::<R>(p, window, edge));
            let end = match beyond {
                [true, true] => return tell.tell(held, Event::Reject { edge }),
                [false, false] => {
                    tell.tell(held, Event::Keep { edge })?;
                    continue;
                }
                [true, false] => End::P1,
                [false, true] => End::P2,
            };
            // One end beyond and one not: not parallel.
            let Some(crossing) = crossing else { continue };
            let [[_, free1], [_, free2]] = held.ends.map(|p| split::<R>(p, edge.axis()));
            let free = clamp_between(crossing.free, free1, free2);
            let to = join(edge.axis(), R::new(window.border(edge)), free);
            let from = std::mem::replace(&mut held.ends[end.idx()], to);
            let cut = Event::Cut {
                end,
                edge,
                from,
                to,
            };
            tell.tell(held, cut)?;
        }
        let segment = segment_between(held.ends);
        held.visible = Some(segment);
        tell.tell(held, Event::Accept { segment })
    }

    #[inline]
    fn output(held: BruteForceHeld) -> Visible {
        held.visible
    }

    /// Two for each side, and a verdict.
    fn max_events(_: &WindowInput) -> usize {
        4 * 2 + 1
    }
}

/// The crossing with a side's line; `None` where the two are parallel.
#[inline]
fn intersect<R: Real>(segment: &Segment, window: &Window, edge: Edge) -> Option<Crossing<R>> {
    let [a1, _] = split::<R>(segment.p1, edge.axis());
    let [a2, _] = split::<R>(segment.p2, edge.axis());
    let is_parallel = a1 == a2;
    (!is_parallel).then(|| crossing::<R>(segment, window, edge))
}

#[inline]
fn crossing_event<R: Real>(
    window: &Window,
    edge: Edge,
    crossing: Option<&Crossing<R>>,
) -> BruteForceEvent {
    let Some(crossing) = crossing else {
        return BruteForceEvent::Parallel { edge };
    };
    let [num, den] = crossing.ratio.map(R::get);
    let free = R::new(crossing.free.get().clamp(f64::MIN, f64::MAX));
    BruteForceEvent::Intersect {
        edge,
        u: Ratio { num, den },
        at: join(edge.axis(), R::new(window.border(edge)), free),
    }
}

#[inline]
fn is_beyond<R: Real>(point: Point, window: &Window, edge: Edge) -> bool {
    let [a, _] = split::<R>(point, edge.axis());
    let c = R::new(window.border(edge));
    if edge.is_max() { a > c } else { a < c }
}
