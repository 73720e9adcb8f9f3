//! One segment at a time: Liang–Barsky as the pipeline calls it.
//!
//! The taught [`LiangBarsky`] divides as soon as it has a q and a p, and asks at every side whether anything
//! is left. That is easy to follow and easy to show; but half of these questions have no likely answer, and a
//! processor that guesses wrong waits longer than a division takes. Here the closed form answers without a
//! branch, and only what rounding could change goes the taught way: the results are the same, bit for bit.
//!
//! ```text
//!   segment ──► closed form ──► certain: the answer
//!                     └───────► uncertain (a tie at a corner, numbers out of range) ──► LiangBarsky
//! ```
//!
//! *Conventions*, *degenerate*, *source*: as in [`LiangBarsky`]. *Cost*: 14 +, 16 ×, 4 ÷ and 44 comparisons,
//! always.
//!
//! ```
//! use clipscope::{algo::line::kernel, geom::{Segment, Window}};
//! let window = Window::new(-1.0, -1.0, 1.0, 1.0)?;
//! let visible = kernel::clip(&window, &Segment::new(-2.0, -1.0, 2.0, 1.5)?);
//! assert_eq!(visible, Some(Segment::new(-1.0, -0.375, 1.0, 0.875)?));
//! # Ok::<(), clipscope::geom::GeomError>(())
//! ```

use crate::{
    geom::{Point, Segment, Window},
    trace::silent,
};

use super::{
    LiangBarsky, Visible, WindowInput,
    closed_form::{self, WindowBorders},
};

/// The visible part of `segment`.
#[inline]
#[must_use]
pub fn clip(window: &Window, segment: &Segment) -> Visible {
    let answer = closed_form::clip(segment.to_array(), &WindowBorders::new(window));
    if answer.uncertain {
        return clip_exactly(window, segment);
    }
    (!answer.hidden).then(|| {
        let [x1, y1, x2, y2] = answer.ends;
        Segment {
            p1: Point::from_finite(x1, y1),
            p2: Point::from_finite(x2, y2),
        }
    })
}

/// [`clip`], the taught way.
#[cold]
pub(super) fn clip_exactly(window: &Window, segment: &Segment) -> Visible {
    silent::<LiangBarsky>(&WindowInput {
        window: *window,
        segment: *segment,
    })
}
