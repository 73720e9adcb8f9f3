//! The text of a lesson step: paragraphs, lists, code, and answers that are shown when asked for.

use egui::{Align, Label, RichText, UiBuilder, style::ScrollAnimation};

use crate::{
    lesson::{Block, BlockMarker, Inline},
    paint::theme,
};

use super::prelude::*;

const LEADING: f32 = 0.35;

pub fn lesson_text(ui: &mut Ui, look: Look<'_>, id: Id, blocks: &[Block], is_answered: bool) {
    ui.spacing_mut().item_spacing.y = 8.0;
    for (i, block) in blocks.iter().enumerate() {
        match block {
            Block::Paragraph(text) => running(ui, look, text),
            Block::ListItem {
                depth,
                marker,
                text,
            } => item(ui, look, *depth, *marker, text),
            Block::Code(code) => {
                let code = RichText::new(code.trim_end()).monospace();
                ui.add(Label::new(code.color(look.theme.ink)).selectable(true));
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
    let inner = UiBuilder::new().max_rect(inner);
    let place = ui.scope_builder(inner, |ui| running(ui, look, text));
    let font = TextStyle::Body.resolve(ui.style());
    let at = place.response.rect.left_top();
    match marker {
        BlockMarker::Bullet => {
            let centre = at + vec2(-9.0, (font.size * (1.0 + LEADING) * 0.55).round());
            ui.painter().circle_filled(centre, 1.75, look.theme.soft);
        }
        BlockMarker::Number(n) => {
            let at = at + vec2(-6.0, 0.0);
            let painter = ui.painter();
            painter.text(
                at,
                Align2::RIGHT_TOP,
                format!("{n}."),
                font,
                look.theme.soft,
            );
        }
        BlockMarker::Continued => {}
    }
}

fn answer(ui: &mut Ui, look: Look<'_>, id: Id, blocks: &[Block]) {
    let left = ui.cursor().left();
    let inner = id.with("shown");
    let shown = ui.indent(id, |ui| lesson_text(ui, look, inner, blocks, true));
    let rect = shown.response.rect;
    let bar = Rect::from_x_y_ranges(left..=left + 2.0, rect.y_range());
    ui.painter().rect_filled(bar, 0.0, look.theme.accent);
    if ui.ctx().read_response(id).is_none() {
        ui.scroll_to_rect_animation(rect, Some(Align::Max), ScrollAnimation::none());
        ui.ctx().request_repaint();
    }
    ui.interact(rect, id, Sense::hover());
}

fn running(ui: &mut Ui, look: Look<'_>, text: &[Inline]) {
    let spans = text.iter().map(|part| {
        let (style, colour) = match part {
            Inline { code: true, .. } => (TextStyle::Monospace, look.theme.ink),
            Inline { strong: true, .. } => (theme::strong(), look.theme.ink),
            _ => (TextStyle::Body, look.theme.soft),
        };
        let span = Span::text(&part.text, style.resolve(ui.style()), colour);
        span.slanted(part.emphasis)
    });
    let spans: Vec<Span> = spans.collect();
    let size = TextStyle::Body.resolve(ui.style()).size;
    let line_height = (size * (1.0 + LEADING)).round();
    let set = Typeset::running(ui.painter(), &spans, ui.available_width(), line_height);
    ui.add(Label::new(set.galley()).selectable(true));
}

pub fn step_title(ui: &mut Ui, look: Look<'_>, title: &str) {
    let text = Inline {
        text: title.to_owned(),
        strong: true,
        ..Inline::default()
    };
    running(ui, look, &[text]);
}
