//! Vertex lists side by side, and what links them.

use egui::{Rect, Ui};

use crate::figure::{Link, Lists};

use super::super::Look;

/// Draws the view in `rect`; what it shows under the pointer.
pub fn lists(
    ui: &mut Ui,
    look: Look<'_>,
    rect: Rect,
    shown: &Lists,
    lit: Option<Link>,
) -> Option<Link> {
    let _ = (ui, look, rect, shown, lit);
    None
}
