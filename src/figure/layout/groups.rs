//! The views of a column by where they stand.

use crate::figure::{Need, Stand};

use super::way::Way;

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
