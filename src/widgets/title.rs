//! The strip above a column that names its method.

use egui::{Align2, FontId, Painter, Pos2, vec2};

use crate::paint::fonts::semibold;

use super::Look;

/// Between a method's name and the note on it.
const GAP_PTS: f32 = 12.0;

/// Writes a method's name at a place, and beside it a note where it is wrong on purpose: in the colour of what
/// happens, and after a sign, so that it does not hang on the colour. Where both do not fit, the note goes
/// below.
pub fn column_title(
    painter: &Painter,
    look: Look<'_>,
    (at, align): (Pos2, Align2),
    width: f32,
    name: &str,
    note: Option<&str>,
) {
    let theme = look.theme;
    let size = 13.0 * theme.text_scale;
    let strong = FontId::new(size, semibold());
    let Some(note) = note else {
        painter.text(at, align, name, strong, theme.ink);
        return;
    };
    let note = format!("≠ {note}");
    let name = painter.layout_no_wrap(name.to_owned(), strong, theme.ink);
    let plain = FontId::proportional(size);
    let note = painter.layout_no_wrap(note, plain, theme.signal);
    let is_beside = name.size().x + GAP_PTS + note.size().x <= width;
    let offset = if is_beside {
        vec2(name.size().x + GAP_PTS, name.size().y - note.size().y)
    } else {
        vec2(0.0, name.size().y)
    };
    let height = if is_beside {
        name.size().y
    } else {
        name.size().y + note.size().y
    };
    let top = align.anchor_size(at, vec2(width, height)).min;
    painter.galley(top, name, theme.ink);
    painter.galley(top + offset, note, theme.signal);
}
