//! The views of a column by where they stand, and the ways in which they may stand.

use super::super::extent::{Need, Stand};

pub struct Groups<'a> {
    pub drawing: &'a Need,
    pub insets: Vec<&'a Need>,
    pub over: Vec<&'a Need>,
    pub across: Vec<&'a Need>,
    pub under: Vec<&'a Need>,
    pub beside: Vec<&'a Need>,
}

impl<'a> Groups<'a> {
    pub fn of(needs: &'a [Need], way: Way) -> Option<Self> {
        let stands = |stand| needs.iter().position(|need| need.stand == stand);
        let first = stands(Stand::Drawing).or(stands(Stand::Inset))?;
        let others = needs[..first].iter().chain(&needs[first + 1..]);
        let standing = |stands: &[Stand]| {
            let standing = others.clone().filter(|need| stands.contains(&need.stand));
            standing.collect()
        };
        let mut groups = Self {
            drawing: &needs[first],
            insets: standing(&[Stand::Inset]),
            over: standing(&[Stand::Over]),
            across: standing(&[Stand::Across]),
            under: standing(&[Stand::Under, Stand::Foot]),
            beside: standing(&[Stand::Drawing, Stand::Beside]),
        };
        groups.go(way);
        Some(groups)
    }

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

const LOW: f32 = 0.82;

/// Where that stands which belongs beside the drawing.
#[derive(Clone, Copy)]
pub enum Way {
    Beside,
    Under,
    /// Beside the drawing after all, which is narrow itself: the column is low, too. What measures it is wider.
    Narrow,
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
