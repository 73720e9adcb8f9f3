//! A line in the world to its pixels: project, clip ([`HomogeneousLine`]), divide, rasterise ([`Bresenham`]). An end goes to the
//! pixel that it lies in; on the right or lower edge of the picture to the last one. Of two pixels in place of a segment only the
//! last step is left.
//!
//! *Degenerate*: a segment of which nothing is visible has no pixels. *Bound*: five events, and one a pixel. *Cost*: what its
//! parts cost; three multiplications and three additions a row of the matrix, three divisions an end.
//!
//! ```
//! use clipscope::{algo::{pipeline::{DrawnSegment, LineToPixels, LineToPixelsInput}, surface::Viewport}, geom::{Camera, ViewVolume}, trace::silent};
//! let volume = ViewVolume::perspective(90.0, 1.0, 1.0, 9.0)?;
//! let drawn = DrawnSegment {
//!     ends: [[0.0, 0.0, -2.0], [4.0, 0.0, -2.0]],
//!     camera: Camera::new([0.0; 3], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0], volume)?,
//!     viewport: Viewport::new([8, 8], Viewport::ANSWER_BITS).expect("a picture"),
//! };
//! let pixels = silent::<LineToPixels>(&LineToPixelsInput::Segment(drawn));
//! assert_eq!(pixels, [[4, 4], [5, 4], [6, 4], [7, 4]], "from the middle to the right edge");
//! # Ok::<(), clipscope::geom::SpaceError>(())
//! ```

use serde::Serialize;

use crate::{
    algo::{
        parameter::End,
        surface::Viewport,
        volume::{ClipSpace, HomogeneousLine, LineInput},
    },
    geom::Camera,
    trace::{Listening, Method, Real, Tell, Told, held_after},
};

use super::{Bresenham, BresenhamEvent, BresenhamInput, row_times};

/// The algorithm; see the module.
#[derive(Clone, Copy, Debug)]
pub struct LineToPixels;

/// What is drawn.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum LineToPixelsInput {
    /// From pixel to pixel.
    Pixels(BresenhamInput),
    /// A segment in the world.
    Segment(DrawnSegment),
}

/// A segment in the world, and the picture that it is drawn on.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct DrawnSegment {
    /// P₁ and P₂, finite.
    pub ends: [[f64; 3]; 2],
    /// Who looks.
    pub camera: Camera,
    /// The pixels of the picture.
    pub viewport: Viewport,
}

/// What happens, in order.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum LineToPixelsEvent {
    /// An end goes to clip space.
    Project {
        /// Which one.
        end: End,
        /// x, y, z, w
        clip: [f64; 4],
    },
    /// Clipped against −w ≤ x, y, z ≤ w.
    Clip {
        /// The ends of what is left.
        ends: [[f64; 4]; 2],
    },
    /// Nothing is left.
    Reject,
    /// Divided by w, and scaled to the picture.
    Divide {
        /// Both ends in pixels from the top left, with fractions.
        screen: [[f64; 2]; 2],
    },
    /// The pixels that both ends lie in.
    Round {
        /// Of the first.
        from: [i64; 2],
        /// Of the second.
        to: [i64; 2],
    },
    /// A pixel is put.
    Pixel {
        /// Its column and row.
        at: [i64; 2],
        /// Has the minor axis been gone along, too?
        diagonal: bool,
        /// e at this pixel: on which side of the next midpoint the line runs.
        error: i64,
    },
}

impl From<BresenhamEvent> for LineToPixelsEvent {
    fn from(event: BresenhamEvent) -> Self {
        let BresenhamEvent::Pixel {
            at,
            diagonal,
            error,
        } = event;
        Self::Pixel {
            at,
            diagonal,
            error,
        }
    }
}

impl DrawnSegment {
    /// A pixel for a place on the picture: what lies on its right or lower edge is in the last one.
    #[must_use]
    pub fn pixel(&self, screen: [f64; 2]) -> [i64; 2] {
        let size = self.viewport.size();
        [0, 1].map(|i| {
            let last = f64::from(size[i] - 1);
            screen[i].floor().clamp(0.0, last) as i64
        })
    }

    /// The pixels of both ends, once all before them has been told; none where nothing is left.
    fn ends<R: Real, S>(
        &self,
        tell: &mut impl FnMut(LineToPixelsEvent) -> Told<S>,
    ) -> Told<S, Option<BresenhamInput>> {
        let rows = self.camera.clip_from_world().rows();
        let mut projected = [[0.0; 4]; 2];
        for (end, at) in End::BOTH.into_iter().zip(&mut projected) {
            let from = self.ends[end.idx()].map(R::new);
            *at = rows.map(|row| row_times(row, from).get());
            tell(LineToPixelsEvent::Project { end, clip: *at })?;
        }
        let input = LineInput {
            bounds: ClipSpace,
            ends: projected,
        };
        let left = held_after::<HomogeneousLine, R>(&input);
        // What is inside of all sides has w > 0: but for the eye itself, and for rounding.
        let left = left.filter(|ends| ends.iter().all(|end| R::new(end[3]) > R::new(0.0)));
        let Some(ends) = left else {
            tell(LineToPixelsEvent::Reject)?;
            return Told::Continue(None);
        };
        tell(LineToPixelsEvent::Clip { ends })?;
        let screen = ends.map(|[x, y, _, w]| {
            let [x, y, w] = [x, y, w].map(R::new);
            self.viewport.screen_from_ndc([x / w, y / w]).map(R::get)
        });
        tell(LineToPixelsEvent::Divide { screen })?;
        let [from, to] = screen.map(|at| self.pixel(at));
        tell(LineToPixelsEvent::Round { from, to })?;
        // A picture has at most 4096 pixels a side.
        Told::Continue(BresenhamInput::new(from, to).ok())
    }
}

impl Method for LineToPixels {
    type Input = LineToPixelsInput;
    type Held = Vec<[i64; 2]>;
    type Output = Vec<[i64; 2]>;
    type Event = LineToPixelsEvent;

    #[inline]
    fn begin(_: &Self::Input) -> Self::Held {
        Vec::new()
    }

    #[inline]
    fn run<R: Real, T: Tell<Self>>(
        input: &Self::Input,
        held: &mut Self::Held,
        tell: &mut T,
    ) -> Told<T::Stop> {
        let ends = match input {
            LineToPixelsInput::Pixels(ends) => Some(*ends),
            LineToPixelsInput::Segment(drawn) => {
                drawn.ends::<R, _>(&mut |event| tell.tell(held, event))?
            }
        };
        let Some(ends) = ends else {
            return Told::Continue(());
        };
        held.reserve(Bresenham::max_events(&ends));
        let mut put =
            Listening(|held: &Self::Held, event: BresenhamEvent| tell.tell(held, event.into()));
        Bresenham::run::<R, _>(&ends, held, &mut put)
    }

    #[inline]
    fn output(held: Self::Held) -> Self::Output {
        held
    }

    /// Two ends, the clip, the divide, the pixels of both ends; then one a pixel.
    fn max_events(input: &Self::Input) -> usize {
        match input {
            LineToPixelsInput::Pixels(ends) => Bresenham::max_events(ends),
            LineToPixelsInput::Segment(drawn) => {
                let [columns, rows] = drawn.viewport.size();
                5 + columns.max(rows) as usize
            }
        }
    }
}
