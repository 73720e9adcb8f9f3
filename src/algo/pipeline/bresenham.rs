//! Bresenham's line: the pixels nearest to a line, by additions and the sign of one whole number.
//!
//! Let a be the larger and b the smaller of |Δx| and |Δy|. The error term e is 2a times as much as the line is beyond the midpoint
//! between the two candidates for the next pixel: 2b − a at the first, 2b more for each step along the major axis, 2a less for one
//! along the minor. Exactly between two pixels the smaller coordinate is taken: walking back gives the same pixels.
//!
//! *Bound*: one event a pixel, at most [`BresenhamInput::MOST_PIXELS`]. *Cost*: three additions, and a pixel after the first one
//! comparison, one or two additions; e is a whole number below 2¹⁸, exact in the counting scalar. *Source*: J. E. Bresenham, "Algorithm
//! for computer control of a digital plotter", IBM Systems Journal 4, 1965, pp. 25–30.
//!
//! ```
//! use clipscope::{algo::pipeline::{Bresenham, BresenhamInput}, trace::silent};
//! let pixels = |from, to| silent::<Bresenham>(&BresenhamInput::new(from, to).expect("few pixels"));
//! assert_eq!(pixels([0, 0], [4, 2]), [[0, 0], [1, 0], [2, 1], [3, 1], [4, 2]]);
//! let mut back = pixels([4, 2], [0, 0]);
//! back.reverse();
//! assert_eq!(back, pixels([0, 0], [4, 2]));
//! ```

use serde::Serialize;

use crate::trace::{Method, Real, Tell, Told};

/// The algorithm; see the module.
#[derive(Clone, Copy, Debug)]
pub struct Bresenham;

/// Two pixels, not too far apart.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct BresenhamInput {
    from: [i64; 2],
    to: [i64; 2],
}

/// The line would have more pixels than [`BresenhamInput::MOST_PIXELS`].
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct TooManyPixels {
    /// As many as it would have; of more than `u64` holds, that many.
    pub n_pixels: u64,
}

impl BresenhamInput {
    /// A line has at most so many pixels.
    pub const MOST_PIXELS: u64 = 65_536;

    /// From a pixel to a pixel.
    ///
    /// # Errors
    /// [`TooManyPixels`]
    pub fn new(from: [i64; 2], to: [i64; 2]) -> Result<Self, TooManyPixels> {
        let input = Self { from, to };
        let [x, y] = input.distances();
        let n_pixels = x.max(y).saturating_add(1);
        if n_pixels > Self::MOST_PIXELS {
            return Err(TooManyPixels { n_pixels });
        }
        Ok(input)
    }

    /// The first pixel.
    #[must_use]
    pub const fn from(&self) -> [i64; 2] {
        self.from
    }

    /// The last one.
    #[must_use]
    pub const fn to(&self) -> [i64; 2] {
        self.to
    }

    /// |Δx| and |Δy|: no difference of two i64 is too large for them.
    #[must_use]
    pub fn distances(&self) -> [u64; 2] {
        [0, 1].map(|i| self.to[i].abs_diff(self.from[i]))
    }

    /// The longer axis, x where both are as long: 0 is x.
    #[must_use]
    pub fn major(&self) -> usize {
        let [x, y] = self.distances();
        usize::from(y > x)
    }
}

/// What happens, in order.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum BresenhamEvent {
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

impl Method for Bresenham {
    type Input = BresenhamInput;
    type Held = Vec<[i64; 2]>;
    type Output = Vec<[i64; 2]>;
    type Event = BresenhamEvent;

    #[inline]
    fn begin(input: &Self::Input) -> Self::Held {
        Vec::with_capacity(Self::max_events(input))
    }

    #[inline]
    fn run<R: Real, T: Tell<Self>>(
        input: &Self::Input,
        held: &mut Self::Held,
        tell: &mut T,
    ) -> Told<T::Stop> {
        let BresenhamInput { from, to } = *input;
        let major = input.major();
        let minor = 1 - major;
        let step = [0, 1].map(|i| to[i].saturating_sub(from[i]).signum());
        let distances = input.distances();
        let [a, b] = [major, minor].map(|i| R::new(distances[i] as f64));
        let [two_a, two_b] = [a + a, b + b];
        let mut error = two_b - a;
        let zero = R::new(0.0);
        let mut at = from;
        let mut put = |at: [i64; 2], diagonal: bool, error: R| {
            held.push(at);
            // A whole number below 2¹⁸.
            let error = error.get() as i64;
            let put = BresenhamEvent::Pixel {
                at,
                diagonal,
                error,
            };
            tell.tell(held, put)
        };
        put(at, false, error)?;
        while at[major] != to[major] {
            // Exactly between two: the smaller coordinate, whichever way is walked.
            let is_beyond = if step[minor] < 0 {
                error >= zero
            } else {
                error > zero
            };
            if is_beyond {
                at[minor] += step[minor];
                error = error - two_a;
            }
            at[major] += step[major];
            error = error + two_b;
            put(at, is_beyond, error)?;
        }
        Told::Continue(())
    }

    #[inline]
    fn output(held: Self::Held) -> Self::Output {
        held
    }

    /// One a pixel.
    fn max_events(input: &Self::Input) -> usize {
        input.distances()[input.major()] as usize + 1
    }
}
