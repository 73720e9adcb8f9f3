//! The ways in which the views of a column may stand.

use crate::figure::Need;

/// Of what views want at least this part is better than nothing.
const LOW: f32 = 0.82;

/// Where that stands which belongs beside the drawing.
#[derive(Clone, Copy)]
pub enum Way {
    /// There.
    Beside,
    /// Under the drawing: the column is narrow.
    Under,
    /// Beside the drawing after all, which is narrow itself: the column is low, too. What measures it is wider.
    Narrow,
    /// Under it after all, and all of them are low.
    Low,
}

impl Way {
    /// What is tried first in columns of this shape: what is higher than it is wide has more room under the drawing.
    pub fn roomy(is_portrait: bool) -> [Self; 3] {
        if is_portrait {
            [Self::Under, Self::Beside, Self::Narrow]
        } else {
            [Self::Beside, Self::Under, Self::Narrow]
        }
    }

    /// What views want at least, if they stand so.
    pub fn wanted(self, needs: &[Need]) -> Vec<Need> {
        let part = match self {
            Self::Beside | Self::Under | Self::Narrow => 1.0,
            Self::Low => LOW,
        };
        let lower = |need: &Need| Need {
            least: [need.least[0], part * need.least[1]],
            ..*need
        };
        needs.iter().map(lower).collect()
    }
}
