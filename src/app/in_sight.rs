//! What comes to a column that scrolls is brought into sight.

use super::prelude::*;

/// Scrolls to the newest of so many things when there are more of them than before, in two frames: what stands below is laid out one
/// later.
pub fn scroll_to_new(ui: &Ui, name: &'static str, count: usize, newest: Rect) {
    let id = Id::unique(name);
    let (before, was_new): (usize, bool) = ui.data(|data| data.get_temp(id)).unwrap_or_default();
    let is_new = count > before;
    if count != before || was_new {
        ui.data_mut(|data| data.insert_temp(id, (count, is_new)));
    }
    if is_new || was_new {
        ui.scroll_to_rect(newest, None);
        ui.ctx().request_repaint();
    }
}
