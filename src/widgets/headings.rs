//! Headings: of a column with its method, of a section of a side panel, and the hairline between two sections.

use egui::{Align2, FontId, Painter, Pos2, Response, RichText, Ui, vec2};

use crate::paint::{Span, Typeset, fonts::semibold, theme};

use super::look::Look;

/// Between a method's name and the note on it.
const GAP_PTS: f32 = 12.0;
/// Of the text, and the least that it is made smaller to so that a strip has room for all of it.
const SIZE_PTS: f32 = 13.0;
const LEAST_PTS: f32 = 10.0;
/// Lines that a strip has room for.
const MAX_ROWS: usize = 2;

/// Writes a method's name at a place, after it the moment that its column shows, and beside it a note where it is wrong on purpose: in the colour of what
/// happens, and after a sign, so that it does not hang on the colour. Where both do not fit, the note goes
/// below, and where that makes too many lines, all is written smaller: it is never cut.
pub fn column_title(
    painter: &Painter,
    look: Look<'_>,
    (at, align): (Pos2, Align2),
    width: f32,
    name: &str,
    [moment, note]: [Option<&str>; 2],
) {
    let theme = look.theme;
    let mut size = SIZE_PTS;
    let (name, note, is_beside) = loop {
        let [strong, plain] = [
            FontId::new(size * theme.title_scale, semibold()),
            FontId::proportional(size * theme.title_scale),
        ];
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
        if is_beside || name.n_rows() + n_note <= MAX_ROWS || size < LEAST_PTS {
            break (name, note, is_beside);
        }
    };
    let Some(note) = note else {
        name.paint(
            painter,
            align.anchor_size(at, name.size()).min,
            Align2::LEFT_TOP,
        );
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

/// A small semibold heading.
pub fn section(ui: &mut Ui, look: Look<'_>, title: &str) -> Response {
    ui.label(
        RichText::new(title)
            .text_style(theme::strong())
            .color(look.theme.soft),
    )
}

/// White space above and below a hairline.
const AIR: f32 = 12.0;

/// A hairline between two sections, with white space on both sides.
pub fn rule(ui: &mut Ui, look: Look<'_>) {
    let spacing = ui.spacing().item_spacing.y;
    ui.add_space(AIR - spacing);
    let (rect, _) =
        ui.allocate_exact_size(egui::vec2(ui.available_width(), 1.0), egui::Sense::hover());
    ui.painter().rect_filled(rect, 0.0, look.theme.hairline);
    ui.add_space(AIR - spacing);
}
