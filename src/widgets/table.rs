//! Rows and columns of values.

use egui::{Rect, Ui};

use crate::figure::{Link, Table};

use super::Look;

/// Draws the view in `rect`; what it shows under the pointer.
pub fn table(
    ui: &mut Ui,
    look: Look<'_>,
    rect: Rect,
    shown: &Table,
    lit: Option<Link>,
) -> Option<Link> {
    let _ = (ui, look, rect, shown, lit);
    None
}
