//! The text of a lesson step: paragraphs, lists, code, and answers that are shown when asked for.

use egui::{
    Align, Color32, FontId, Id, Label, RichText, TextFormat, TextStyle, Ui, UiBuilder,
    style::ScrollAnimation, text::LayoutJob, vec2,
};

use crate::{
    lesson::{Block, BlockMarker, Inline},
    paint::theme,
};

use super::Look;

/// Extra space between lines of running text, as a part of the text's size.
const LEADING: f32 = 0.35;

/// Draws the blocks below each other, with their answers or without. `id` tells this text from another.
pub fn lesson_text(ui: &mut Ui, look: Look<'_>, id: Id, blocks: &[Block], is_answered: bool) {
    ui.spacing_mut().item_spacing.y = 8.0;
    for (i, block) in blocks.iter().enumerate() {
        match block {
            Block::Paragraph(text) => {
                ui.add(Label::new(job(ui, look, text)).selectable(true));
            }
            Block::ListItem {
                depth,
                marker,
                text,
            } => item(ui, look, *depth, *marker, text),
            Block::Code(code) => {
                let code = RichText::new(code.trim_end())
                    .monospace()
                    .color(look.theme.ink);
                ui.add(Label::new(code).selectable(true));
            }
            Block::Answer(blocks) if is_answered => answer(ui, look, id.with(i), blocks),
            Block::Answer(_) => {}
        }
    }
}

fn item(ui: &mut Ui, look: Look<'_>, depth: usize, marker: BlockMarker, text: &[Inline]) {
    let indent = 16.0 * (depth + 1) as f32;
    let row = ui.available_rect_before_wrap();
    let mut inner = row;
    inner.min.x += indent;
    let place = ui.scope_builder(UiBuilder::new().max_rect(inner), |ui| {
        ui.add(Label::new(job(ui, look, text)).selectable(true));
    });
    let font = TextStyle::Body.resolve(ui.style());
    let at = place.response.rect.left_top();
    match marker {
        BlockMarker::Bullet => {
            let centre = at + vec2(-9.0, (font.size * (1.0 + LEADING) * 0.55).round());
            ui.painter().circle_filled(centre, 1.75, look.theme.soft);
        }
        BlockMarker::Number(n) => {
            let at = at + vec2(-6.0, 0.0);
            ui.painter().text(
                at,
                egui::Align2::RIGHT_TOP,
                format!("{n}."),
                font,
                look.theme.soft,
            );
        }
        BlockMarker::Continued => {}
    }
}

/// What was hidden until it was asked for; it scrolls into sight when it appears.
fn answer(ui: &mut Ui, look: Look<'_>, id: Id, blocks: &[Block]) {
    let left = ui.cursor().left();
    let shown = ui.indent(id, |ui| {
        lesson_text(ui, look, id.with("shown"), blocks, true);
    });
    let rect = shown.response.rect;
    let bar = egui::Rect::from_x_y_ranges(left..=left + 2.0, rect.y_range());
    ui.painter().rect_filled(bar, 0.0, look.theme.accent);
    if ui.ctx().read_response(id).is_none() {
        ui.scroll_to_rect_animation(rect, Some(Align::Max), ScrollAnimation::none());
        ui.ctx().request_repaint();
    }
    ui.interact(rect, id, egui::Sense::hover());
}

fn job(ui: &Ui, look: Look<'_>, text: &[Inline]) -> LayoutJob {
    let mut job = LayoutJob::default();
    let body = TextStyle::Body.resolve(ui.style());
    let line_height = Some((body.size * (1.0 + LEADING)).round());
    let format = |font_id: FontId, color: Color32, italics: bool| TextFormat {
        font_id,
        color,
        italics,
        line_height,
        valign: Align::BOTTOM,
        ..TextFormat::default()
    };
    for part in text {
        let (style, colour) = match part {
            Inline { code: true, .. } => (TextStyle::Monospace, look.theme.ink),
            Inline { strong: true, .. } => (theme::strong(), look.theme.ink),
            _ => (TextStyle::Body, look.theme.soft),
        };
        job.append(
            &part.text,
            0.0,
            format(style.resolve(ui.style()), colour, part.emphasis),
        );
    }
    job
}
