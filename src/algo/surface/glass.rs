//! What light comes through: each surface covers what is behind it by its opacity α, and shows itself that much.
//!
//! ```text
//!   C = α·C_s + (1 − α)·C_d         the surface's own brightness C_s over the brightness C_d that is there
//!
//!   wall, then pane:  ½·¼ + ½·0 = ⅛        pane, then wall:  1·0 + 0·⅝ = 0      the order counts
//! ```
//!
//! *Conventions*: brightness is from 0, black, to 1, white; what nothing has been painted on is white paper. *Exact*: α = 1 leaves nothing of
//! what was there. *Cost*: 2 ×, 1 + and 1 −.
//!
//! *Source*: T. Porter and T. Duff, "Compositing digital images", Computer Graphics 18(3) (SIGGRAPH), 1984, pp. 253–259.

use crate::{geom::is_part, trace::Real};

/// How a surface looks, and how much of what is behind it can be seen.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Tint {
    opacity: f64,
    brightness: f64,
}

impl Tint {
    /// White, where nothing is painted.
    pub const PAPER: f64 = 1.0;

    /// Both from 0 to 1; `None` beyond that.
    #[must_use]
    pub fn new(opacity: f64, brightness: f64) -> Option<Self> {
        let is_valid = [opacity, brightness].into_iter().all(is_part);
        is_valid.then_some(Self {
            opacity,
            brightness,
        })
    }

    /// α
    #[must_use]
    pub const fn opacity(self) -> f64 {
        self.opacity
    }

    /// C_s
    #[must_use]
    pub const fn brightness(self) -> f64 {
        self.brightness
    }

    /// This over what is there.
    ///
    /// ```
    /// # use clipscope::algo::surface::Tint;
    /// let pane = Tint::new(0.5, 0.25).expect("parts of one");
    /// assert_eq!(pane.over::<f64>(Tint::PAPER), 0.625);
    /// ```
    #[must_use]
    #[inline]
    pub fn over<R: Real>(self, there: f64) -> f64 {
        let [opacity, own, there] = [self.opacity, self.brightness, there].map(R::new);
        (opacity * own + (R::new(1.0) - opacity) * there).get()
    }
}
