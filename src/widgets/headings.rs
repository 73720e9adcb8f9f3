//! Headings: of a column with its method, of a section of a side panel, and the hairline between two sections.

use egui::{Button, RichText};

use crate::paint::{fonts::semibold, theme};

use super::prelude::*;

const GAP_PTS: f32 = 12.0;
const SIZE_PTS: f32 = 13.0;
const LEAST_PTS: f32 = 10.0;
const MAX_ROWS: usize = 2;

/// Writes a method's name at a place, after it the moment that its column shows, and beside it, after a sign, a note where it
/// is wrong on purpose. Where both do not fit, the note goes below; where that makes too many lines, all is smaller.
pub fn column_title(
    painter: &Painter,
    look: Look<'_>,
    (at, align): (Pos2, Align2),
    width: f32,
    name: &str,
    [moment, note]: [Option<&str>; 2],
) {
    let theme = look.theme;
    let least = theme.least_text.max(LEAST_PTS);
    let mut size = SIZE_PTS;
    let (name, note, is_beside) = loop {
        let strong = FontId::new(size * theme.title_scale, semibold());
        let plain = FontId::proportional(size * theme.title_scale);
        let mut spans = vec![Span::text(name, strong, theme.ink)];
        if let Some(moment) = moment {
            let moment = format!("\u{2003}{moment}");
            spans.push(Span::text(&moment, plain.clone(), theme.soft));
        }
        let name = Typeset::wrapped(painter, &spans, width);
        let note = note.map(|note| Span::text(&format!("≠ {note}"), plain, theme.signal_text));
        let note = note.map(|note| Typeset::wrapped(painter, &[note], width));
        let note_width = note.as_ref().map_or(0.0, |note| GAP_PTS + note.size().x);
        let is_beside = name.size().x + note_width <= width;
        let n_note = note.as_ref().map_or(0, Typeset::n_rows);
        size -= 1.0;
        if is_beside || name.n_rows() + n_note <= MAX_ROWS || size * theme.title_scale < least {
            break (name, note, is_beside);
        }
    };
    let Some(note) = note else {
        let top = align.anchor_size(at, name.size()).min;
        name.paint(painter, top, Align2::LEFT_TOP);
        return;
    };
    let offset = if is_beside {
        vec2(name.size().x + GAP_PTS, name.baseline() - note.baseline())
    } else {
        vec2(0.0, name.size().y)
    };
    let height = name.size().y.max(offset.y + note.size().y);
    let top = align.anchor_size(at, vec2(width, height)).min;
    name.paint(painter, top, Align2::LEFT_TOP);
    note.paint(painter, top + offset, Align2::LEFT_TOP);
}

/// The ring of what has the keyboard's focus.
pub fn focus_ring(painter: &Painter, look: Look<'_>, response: &Response, rect: Rect, corner: f32) {
    if response.has_focus() {
        let ring = look.theme.stroke(2.0, look.theme.accent);
        painter.rect_stroke(rect, corner, ring, StrokeKind::Inside);
    }
}

/// A button that is words alone: a ring tells that it has the focus.
pub fn quiet_button(ui: &mut Ui, look: Look<'_>, button: Button<'_>) -> Response {
    let response = ui.add(button.frame(false));
    focus_ring(
        ui.painter(),
        look,
        &response,
        response.rect.expand(2.0),
        3.0,
    );
    response
}

pub fn section(ui: &mut Ui, look: Look<'_>, title: &str) -> Response {
    let title = RichText::new(title).text_style(theme::strong());
    ui.label(title.color(look.theme.soft))
}

const AIR: f32 = 12.0;

pub fn rule(ui: &mut Ui, look: Look<'_>) {
    let spacing = ui.spacing().item_spacing.y;
    ui.add_space(AIR - spacing);
    let size = vec2(ui.available_width(), 1.0);
    let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
    ui.painter().rect_filled(rect, 0.0, look.theme.hairline);
    ui.add_space(AIR - spacing);
}
