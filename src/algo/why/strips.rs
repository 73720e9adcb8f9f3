//! Why Liang–Barsky takes p < 0 for "in": along the segment x is a straight line over u, and the window is a strip, from left to right. A line
//! that rises enters the strip from below, through left, and leaves it above, through right; one that falls the other way round. So of each strip
//! one border is "in" and one "out", and both strips hold the line from the later "in" to the earlier "out". *Cost*: that of Liang–Barsky.

use serde::Serialize;

use crate::{
    algo::line::WindowInput,
    geom::{Axis, Edge, Point},
    trace::{Real, Told},
};

use super::Proof;

/// The proof; see the module.
#[derive(Clone, Copy, Debug)]
pub struct Strips;

/// What is shown, in order: a fact a border, and the interval.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum StripsFact {
    /// The line comes into its strip here: u.
    In {
        /// p < 0
        edge: Edge,
    },
    /// It goes out: u.
    Out {
        /// p > 0
        edge: Edge,
    },
    /// It is level, and inside this border: how far.
    Level {
        /// p = 0
        edge: Edge,
    },
    /// It is level, and beyond this border all the way: how far. The end.
    Beyond {
        /// p = 0
        edge: Edge,
    },
    /// The latest "in", at least 0.
    From,
    /// The earliest "out", at most 1: the end.
    To,
}

impl Proof for Strips {
    type Input = WindowInput;
    type Fact = StripsFact;

    fn prove<R: Real, S>(
        WindowInput { window, segment }: &WindowInput,
        show: &mut impl FnMut(StripsFact, R) -> Told<S>,
    ) -> Told<S> {
        let zero = R::new(0.0);
        let [mut from, mut to] = [zero, R::new(1.0)];
        for edge in Edge::ALL {
            let along = |at: Point| match edge.axis() {
                Axis::X => R::new(at.x()),
                Axis::Y => R::new(at.y()),
            };
            let (start, border) = (along(segment.p1), R::new(window.border(edge)));
            let delta = along(segment.p2) - start;
            let [p, q] = if edge.is_max() {
                [delta, border - start]
            } else {
                [-delta, start - border]
            };
            if p < zero {
                let u = q / p;
                from = if u > from { u } else { from };
                show(StripsFact::In { edge }, u)?;
            } else if p > zero {
                let u = q / p;
                to = if u < to { u } else { to };
                show(StripsFact::Out { edge }, u)?;
            } else if q < zero {
                return show(StripsFact::Beyond { edge }, -q);
            } else {
                show(StripsFact::Level { edge }, q)?;
            }
        }
        show(StripsFact::From, from)?;
        show(StripsFact::To, to)
    }

    fn max_facts(_: &WindowInput) -> usize {
        6
    }
}
