//! Which chips a drawing has, and where they belong.

use crate::{
    figure::{Chip, Mark},
    paint::{Look, Viewport},
};

use super::anchor::Anchor;

pub fn anchored(viewport: &Viewport, look: Look<'_>, marks: &[Mark]) -> Vec<(Chip, Anchor)> {
    let anchored = |chip: &Chip| {
        let anchor = Anchor::of_link(viewport, look.theme, marks, chip.link?)?;
        Some((*chip, anchor))
    };
    look.chips.iter().filter_map(anchored).collect()
}
