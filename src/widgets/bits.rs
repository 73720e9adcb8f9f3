//! Codes over each other, bit by bit.

use egui::{Rect, Ui};

use crate::figure::{Bits, Link};

use super::Look;

/// Draws the view in `rect`; what it shows under the pointer.
pub fn bits(
    ui: &mut Ui,
    look: Look<'_>,
    rect: Rect,
    shown: &Bits,
    lit: Option<Link>,
) -> Option<Link> {
    let _ = (ui, look, rect, shown, lit);
    None
}
