//! The pixels that clip space is mapped to.

use crate::trace::Real;

/// Pixels, row by row from the top left; each is sampled in its middle.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Viewport {
    size: [u32; 2],
    subpixel_bits: u32,
}

impl Viewport {
    /// As wide, and as high, as a picture may be.
    pub const MAX_SIDE: u32 = 4096;
    /// Fractions of a pixel that pictures need.
    pub const PICTURE_BITS: u32 = 8;
    /// Fractions of a pixel that answers need: no sample farther from an edge than that is on the wrong side.
    pub const ANSWER_BITS: u32 = 16;

    /// Columns and rows, each from 1 to [`Viewport::MAX_SIDE`]; vertices are snapped to 2⁻ᵇ of a pixel, b at most 16.
    /// `None` beyond that.
    #[must_use]
    pub fn new(size: [u32; 2], subpixel_bits: u32) -> Option<Self> {
        let is_usable = size.iter().all(|side| (1..=Self::MAX_SIDE).contains(side))
            && subpixel_bits <= Self::ANSWER_BITS;
        is_usable.then_some(Self {
            size,
            subpixel_bits,
        })
    }

    /// Columns and rows.
    #[must_use]
    pub const fn size(&self) -> [u32; 2] {
        self.size
    }

    /// One pixel, in the units that vertices are snapped to.
    #[must_use]
    pub const fn pixel(&self) -> i64 {
        1 << self.subpixel_bits
    }

    /// Where a point of the square −1 to 1 lies, in pixels from the top left, y down.
    #[inline]
    #[must_use]
    pub fn screen_from_ndc<R: Real>(&self, [x, y]: [R; 2]) -> [R; 2] {
        let [width, height] = self.size.map(|side| R::new(f64::from(side)));
        let half = R::new(0.5);
        [(half * x + half) * width, (half - half * y) * height]
    }

    /// The same, snapped; within the picture's edges.
    #[inline]
    pub(super) fn snapped(&self, ndc: [f64; 2]) -> [i64; 2] {
        let pixel = self.pixel() as f64;
        let screen = self.screen_from_ndc(ndc);
        [0, 1].map(|i| {
            let most = f64::from(self.size[i]) * pixel;
            // To the nearest: what is cast is not negative.
            (screen[i] * pixel + 0.5).clamp(0.0, most) as i64
        })
    }
}
