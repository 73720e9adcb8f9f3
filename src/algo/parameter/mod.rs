//! The parameter along a segment, P(u) = P₁ + u (P₂ − P₁): the arithmetic that its clippers share. Nothing here knows
//! how many dimensions there are: a border is known by the signed distances of both ends from it.

mod interval;
mod mean;
mod moves;
mod order;
mod upright;

use serde::Serialize;

pub use interval::Interval;
pub use mean::{Ratio, Share, clamp_between, weighted_mean};
pub use moves::moves_allowed;
pub(super) use moves::{least_move, nearest_move};
pub use order::{Param, compare_products};
pub use upright::Upright;

/// One of a segment's two ends.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum End {
    /// P₁, where u = 0.
    P1,
    /// P₂, where u = 1.
    P2,
}

impl End {
    /// Both, first end first.
    pub const BOTH: [Self; 2] = [Self::P1, Self::P2];

    /// 0 or 1.
    #[must_use]
    pub const fn idx(self) -> usize {
        self as usize
    }
}
