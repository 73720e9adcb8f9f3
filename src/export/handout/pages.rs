//! Leaves on pages: one under the other, each page with its foot.

use egui::{Pos2, Vec2, pos2};

use crate::export::vector::{PdfPage, PdfPart, Tag};

use super::leaves::{Leaf, MARGIN, Press};

/// Between the last leaf and the foot.
const OVER_FOOT: f32 = 26.0;

/// A page with its leaves, and where each stands.
pub struct Sheet {
    size: Vec2,
    leaves: Vec<(Leaf, Pos2)>,
}

impl Sheet {
    pub fn page(&self) -> PdfPage<'_> {
        let parts = self.leaves.iter().map(|(leaf, at)| PdfPart {
            tag: leaf.tag.clone(),
            drawing: &leaf.drawing,
            at: *at,
            scale: leaf.scale,
            link: leaf.link.clone(),
        });
        PdfPage {
            size: self.size,
            parts: parts.collect(),
        }
    }
}

/// Those that stay together go on the next page together, where that is high enough for all of them.
pub fn paged(press: &mut Press<'_>, leaves: Vec<Leaf>, title: &str) -> Vec<Sheet> {
    let size = press.paper;
    let bottom = size.y - MARGIN - OVER_FOOT;
    let mut pages: Vec<Vec<(Leaf, Pos2)>> = vec![Vec::new()];
    let mut y = MARGIN;
    let mut rest = leaves.into_iter().peekable();
    while rest.peek().is_some() {
        let mut group = Vec::new();
        for leaf in rest.by_ref() {
            let keeps = leaf.keeps;
            group.push(leaf);
            if !keeps {
                break;
            }
        }
        let heights = group.iter().map(|leaf| leaf.above + leaf.height());
        let is_first = pages.last().is_none_or(Vec::is_empty);
        if !is_first && y + heights.sum::<f32>() > bottom {
            pages.push(Vec::new());
            y = MARGIN;
        }
        for leaf in group {
            let is_first = pages.last().is_none_or(Vec::is_empty);
            let above = if is_first { 0.0 } else { leaf.above };
            if !is_first && y + above + leaf.height() > bottom {
                pages.push(Vec::new());
                y = MARGIN;
            } else {
                y += above;
            }
            let at = leaf.place(pos2(MARGIN, y));
            y += leaf.height();
            if let Some(page) = pages.last_mut() {
                page.push((leaf, at));
            }
        }
    }
    let n_pages = pages.len();
    let mut sheets = Vec::new();
    for (nth, mut leaves) in pages.into_iter().enumerate() {
        let words = format!("Clipscope · {title} · {}/{n_pages}", nth + 1);
        let foot = press.small(&words, Tag::Furniture, None);
        let at = pos2(MARGIN, size.y - MARGIN);
        leaves.push((foot, at));
        sheets.push(Sheet { size, leaves });
    }
    sheets
}
