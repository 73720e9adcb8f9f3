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

    /// The first row whose middle does not lie above y, or column whose middle does not lie left of x: (y − pixel/2) / pixel,
    /// rounded up.
    #[inline]
    pub(super) const fn first_middle(&self, y: i32) -> u32 {
        // y is not negative.
        (2 * y as u32 + (1 << self.subpixel_bits) - 1) >> (self.subpixel_bits + 1)
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
    pub(super) fn snapped(&self, ndc: [f64; 2]) -> [i32; 2] {
        let [x, y] = self.screen_from_ndc(ndc);
        let pixel = self.pixel() as f64;
        let snap = |along: f64, side: u32| {
            // To the nearest: what is cast is not negative.
            let (snapped, most) = (along * pixel + 0.5, f64::from(side) * pixel);
            let snapped = if snapped > 0.0 { snapped } else { 0.0 };
            (if snapped < most { snapped } else { most }) as i32
        };
        [snap(x, self.size[0]), snap(y, self.size[1])]
    }
}
