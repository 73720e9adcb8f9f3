//! The views of a column by where they stand, and the ways in which they may stand.

use super::super::extent::{Need, Stand};

/// What one column has to show.
pub struct Groups<'a> {
    /// The drawing, or the inset that is there without one.
    pub drawing: &'a Need,
    /// On the drawing.
    pub insets: Vec<&'a Need>,
    /// Over all the rest.
    pub over: Vec<&'a Need>,
    /// Under all the rest.
    pub across: Vec<&'a Need>,
    /// Under the drawing.
    pub under: Vec<&'a Need>,
    /// Beside it.
    pub beside: Vec<&'a Need>,
}

impl<'a> Groups<'a> {
    /// In their order; none where nothing is drawn.
    pub fn of(needs: &'a [Need], way: Way) -> Option<Self> {
        let stands = |stand| needs.iter().position(|need| need.stand == stand);
        let first = stands(Stand::Drawing).or(stands(Stand::Inset))?;
        let mut groups = Self {
            drawing: &needs[first],
            insets: Vec::new(),
            over: Vec::new(),
            across: Vec::new(),
            under: Vec::new(),
            beside: Vec::new(),
        };
        for need in needs[..first].iter().chain(&needs[first + 1..]) {
            let group = match need.stand {
                Stand::Inset => &mut groups.insets,
                Stand::Over => &mut groups.over,
                Stand::Across => &mut groups.across,
                Stand::Under | Stand::Foot => &mut groups.under,
                Stand::Drawing | Stand::Beside => &mut groups.beside,
            };
            group.push(need);
        }
        groups.go(way);
        Some(groups)
    }

    /// What has no room where it belongs goes elsewhere.
    fn go(&mut self, way: Way) {
        match way {
            Way::Beside => {}
            Way::Under | Way::Low => self.under.append(&mut self.beside),
            Way::Narrow => {
                let wider = self.under.extract_if(.., |need| need.stand == Stand::Under);
                self.across.splice(..0, wider).for_each(drop);
            }
        }
    }
}

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
