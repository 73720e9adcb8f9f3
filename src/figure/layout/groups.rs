//! The views of a column by where they stand, and the ways in which they may stand.

use super::super::extent::{Need, Stand};

pub struct Groups<'a> {
    pub drawing: &'a Need,
    pub insets: Vec<&'a Need>,
    pub over: Vec<&'a Need>,
    pub across: Vec<&'a Need>,
    pub under: Vec<&'a Need>,
    pub beside: Vec<&'a Need>,
    pub row: Vec<&'a Need>,
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
            row: Vec::new(),
        };
        groups.go(way);
        Some(groups)
    }

    fn go(&mut self, way: Way) {
        match way {
            Way::Beside => {}
            Way::Aside => self.beside.append(&mut self.under),
            Way::Under | Way::Low => self.under.append(&mut self.beside),
            Way::Row => self.row.append(&mut self.beside),
            Way::Board => {
                let text = self.beside.extract_if(.., |need| need.aspect.is_none());
                self.across.extend(text);
            }
            Way::Across => {
                let wider = self.under.extract_if(.., |need| need.stand == Stand::Under);
                self.across.splice(..0, wider).for_each(drop);
            }
        }
    }
}

/// Where that stands which belongs beside the drawing, and what measures the drawing.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Way {
    /// Beside the drawing, and under it.
    Beside,
    /// Both beside it, and a strip that can stand there.
    Aside,
    /// Beside it, and across all of the column.
    Across,
    /// Drawings side by side, and text under all of them.
    Board,
    /// In a row under it.
    Row,
    /// All under it.
    Under,
    /// The same, as low as can be read.
    Low,
}

/// A way to stand, the part of its natural width that what stands beside the drawing has, and the part of the column's.
pub type How = (Way, f32, Option<f32>);

/// Of a column's width, what stands beside a drawing has so much where that is a drawing, too.
const SHARES: [f32; 8] = [0.5, 0.3, 0.35, 0.4, 0.45, 0.55, 0.6, 0.65];

impl Way {
    /// What comes first is taken where the drawing is as large in what comes later.
    pub const ALL: [Self; 7] = [
        Self::Beside,
        Self::Aside,
        Self::Across,
        Self::Board,
        Self::Row,
        Self::Under,
        Self::Low,
    ];

    /// As it stands then.
    pub const fn turned(self, need: Need) -> Need {
        match (self, need.aside) {
            (Self::Aside, Some([least, natural])) => Need {
                stand: Stand::Beside,
                least,
                natural,
                ..need
            },
            _ => need,
        }
    }

    /// The parts of the width that may stand beside the drawing; none where text alone does, which has a width of its own.
    pub fn shares(self, needs: &[Vec<Need>]) -> impl Iterator<Item = Option<f32>> + use<> {
        let drawings = |needs: &Vec<Need>| {
            let drawings = needs.iter().filter(|need| need.stand == Stand::Drawing);
            drawings.count()
        };
        let is_side = matches!(
            self,
            Self::Beside | Self::Aside | Self::Across | Self::Board
        );
        let is_shared = is_side && needs.iter().map(drawings).max() > Some(1);
        let shares = is_shared.then_some(SHARES.map(Some));
        let alone = (!is_shared).then_some(None);
        shares.into_iter().flatten().chain(alone)
    }
}
