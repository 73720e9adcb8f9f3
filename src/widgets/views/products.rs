//! Dot products, each with its own small drawing.

use egui::{Rect, Ui};

use crate::figure::{Link, Products};

use super::super::Look;

/// Draws the view in `rect`; what it shows under the pointer.
pub fn products(
    ui: &mut Ui,
    look: Look<'_>,
    rect: Rect,
    shown: &Products,
    lit: Option<Link>,
) -> Option<Link> {
    let _ = (ui, look, rect, shown, lit);
    None
}
