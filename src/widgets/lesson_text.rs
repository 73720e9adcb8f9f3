//! The text of a lesson step: paragraphs, lists, code, and answers that are shown when asked for.

use egui::{
    Align, Frame, Label, Margin, RichText, Role, Tooltip, UiBuilder, WidgetInfo,
    style::ScrollAnimation,
};

use crate::{
    lesson::{Block, BlockMarker, Card, Inline, Word},
    paint::theme,
};

use super::{caption::set_label, headings::focus_ring, prelude::*};

const LEADING: f32 = 0.35;
/// Between the dots under a term, and how far above the bottom of its row they stand.
const DOTS: f32 = 3.0;
const UNDER: f32 = 2.0;

/// What of a text is shown, and how.
#[derive(Clone, Copy, Default)]
pub struct TextTold<'a> {
    /// Are its answers?
    pub is_answered: bool,
    /// Which parts of the goal hold.
    pub met: &'a [bool],
    /// Does it end where it waits for what comes to be told?
    pub waits: bool,
}

impl TextTold<'_> {
    /// All of it.
    pub const fn answered() -> Self {
        Self {
            is_answered: true,
            met: &[],
            waits: false,
        }
    }
}

/// The control that was asked for, of those that the text leads to.
pub fn lesson_text(
    ui: &mut Ui,
    look: Look<'_>,
    id: Id,
    blocks: &[Block],
    told: TextTold<'_>,
) -> Option<&'static str> {
    ui.spacing_mut().item_spacing.y = 8.0;
    let mut asked = None;
    let is_end = |block: &&Block| told.waits && **block == Block::Wait;
    let n_shown = blocks.iter().position(|block| is_end(&block));
    let shown = &blocks[..n_shown.unwrap_or(blocks.len())];
    for (i, block) in shown.iter().enumerate() {
        let by_block = match block {
            Block::Paragraph(text) | Block::Note(text) => running(ui, look, text),
            Block::ListItem {
                depth,
                marker,
                text,
            } => item(ui, look, *depth, *marker, text),
            Block::Goal { nth, text } => goal(ui, look, text, told.met.get(*nth) == Some(&true)),
            Block::Code(code) => {
                let code = RichText::new(code.trim_end()).monospace();
                ui.add(Label::new(code.color(look.theme.ink)).selectable(true));
                None
            }
            Block::Answer(blocks) if told.is_answered => answer(ui, look, id.with(i), blocks),
            Block::Answer(_) | Block::Wait => None,
        };
        asked = asked.or(by_block);
    }
    asked
}

/// A part of a goal: with a tick where it holds, else with an open ring.
fn goal(ui: &mut Ui, look: Look<'_>, text: &[Inline], is_met: bool) -> Option<&'static str> {
    const RADIUS: f32 = 6.0;
    let mut inner = ui.available_rect_before_wrap();
    inner.min.x += 20.0;
    let inner = UiBuilder::new().max_rect(inner);
    let place = ui.scope_builder(inner, |ui| running(ui, look, text));
    let font = TextStyle::Body.resolve(ui.style());
    let down = (font.size * (1.0 + LEADING) * 0.5).round();
    let rect = place.response.rect;
    let centre = rect.left_top() + vec2(-11.0, down);
    let painter = ui.painter();
    if is_met {
        painter.circle_filled(centre, RADIUS, look.theme.accent);
        let tick = [[-3.0, 0.0], [-1.0, 2.5], [3.0, -2.5]].map(|[x, y]| centre + vec2(x, y));
        let stroke = look.theme.stroke(1.5, look.theme.background);
        painter.line(tick.to_vec(), stroke);
    } else {
        painter.circle_stroke(
            centre,
            RADIUS - 0.75,
            look.theme.stroke(1.5, look.theme.soft),
        );
    }
    let sign = ui.interact(
        Rect::from_center_size(centre, Vec2::splat(2.0 * RADIUS)),
        place.response.id.with("met"),
        Sense::hover(),
    );
    let said = look.say(if is_met {
        "goal-part-met"
    } else {
        "goal-part-open"
    });
    sign.widget_info(|| WidgetInfo::selected(Role::CheckBox, true, is_met, &said));
    place.inner
}

fn item(
    ui: &mut Ui,
    look: Look<'_>,
    depth: usize,
    marker: BlockMarker,
    text: &[Inline],
) -> Option<&'static str> {
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
    place.inner
}

fn answer(ui: &mut Ui, look: Look<'_>, id: Id, blocks: &[Block]) -> Option<&'static str> {
    let left = ui.cursor().left();
    let inner = id.with("shown");
    let shown = ui.indent(id, |ui| {
        lesson_text(ui, look, inner, blocks, TextTold::answered())
    });
    let rect = shown.response.rect;
    let bar = Rect::from_x_y_ranges(left..=left + 2.0, rect.y_range());
    ui.painter().rect_filled(bar, 0.0, look.theme.accent);
    if ui.ctx().read_response(id).is_none() {
        ui.scroll_to_rect_animation(rect, Some(Align::Max), ScrollAnimation::none());
        ui.ctx().request_repaint();
    }
    ui.interact(rect, id, Sense::hover());
    shown.inner
}

fn running(ui: &mut Ui, look: Look<'_>, text: &[Inline]) -> Option<&'static str> {
    let spans = text.iter().map(|part| {
        let (style, colour) = match part {
            Inline { code: true, .. } => (TextStyle::Monospace, look.theme.ink),
            Inline {
                control: Some(_), ..
            } => (TextStyle::Body, look.theme.accent),
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
    let shown = ui.add(Label::new(set.galley()).selectable(true));
    let (mut first, mut asked) = (0, None);
    for (part, span) in text.iter().zip(&spans) {
        let end = first + span.n_chars();
        let boxes = || {
            let boxes = set.boxes(first..end).into_iter();
            let boxes = boxes.map(|it| it.translate(shown.rect.min.to_vec2()));
            boxes.collect::<Vec<_>>()
        };
        let id = shown.id.with(first);
        if part.control.is_some() && control(ui, look, id, part, &boxes()) {
            asked = part.control;
        } else if let Some(word) = part.term {
            term(ui, look, id, (part, word), &boxes());
        }
        first = end;
    }
    asked
}

/// Words that lead to a control, underlined: have they been pressed?
fn control(ui: &Ui, look: Look<'_>, id: Id, part: &Inline, boxes: &[Rect]) -> bool {
    let places = boxes.iter().enumerate();
    let parts = places.map(|(i, &rect)| ui.interact(rect, id.with(i), Sense::click()));
    let Some(response) = parts.reduce(|all, part| all | part) else {
        return false;
    };
    response.widget_info(|| WidgetInfo::labeled(Role::Link, true, &part.text));
    let width = if response.hovered() { 2.0 } else { 1.0 };
    let stroke = look.theme.stroke(width, look.theme.accent);
    for rect in boxes {
        ui.painter()
            .hline(rect.x_range(), rect.bottom() - UNDER, stroke);
    }
    focus_ring(ui.painter(), look, &response, response.rect, 2.0);
    let about = look.say("lesson-to-control");
    let response = response.on_hover_cursor(CursorIcon::PointingHand);
    response.on_hover_text(about).clicked()
}

/// A mention of a term: dotted under it, and said in a sentence where it is pointed at or has the focus.
fn term(ui: &Ui, look: Look<'_>, id: Id, (part, word): (&Inline, &Word), boxes: &[Rect]) {
    let Some(&first) = boxes.first() else {
        return;
    };
    let sense = Sense::focusable_noninteractive();
    let mut response = ui.interact(first, id, sense);
    for (i, &rest) in boxes.iter().enumerate().skip(1) {
        response |= ui.interact(rest, id.with(i), Sense::hover());
    }
    let is_lit = response.hovered() || response.has_focus();
    let colour = if is_lit {
        look.theme.accent
    } else {
        look.theme.faint
    };
    for rect in boxes {
        let y = rect.bottom() - UNDER;
        let dots = (0..).map(|i| rect.left() + 1.0 + DOTS * i as f32);
        for x in dots.take_while(|&x| x < rect.right()) {
            ui.painter().circle_filled(pos2(x, y), 0.6, colour);
        }
    }
    let says = || format!("{}: {}", part.text, word.says);
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, says()));
    let mut tooltip = Tooltip::for_enabled(&response);
    if response.has_focus() {
        tooltip = Tooltip::for_widget(&response);
    }
    tooltip.show(|ui| ui.label(&word.says));
}

pub fn step_title(ui: &mut Ui, look: Look<'_>, title: &str) {
    let text = Inline {
        text: title.to_owned(),
        strong: true,
        ..Inline::default()
    };
    running(ui, look, &[text]);
}

/// What a step shows, under its title.
pub fn claimed(ui: &mut Ui, look: Look<'_>, claim: &str) {
    let font = TextStyle::Body.resolve(ui.style());
    let span = Span::text(claim, font, look.theme.accent);
    set_label(ui, &[span], claim);
}

/// What is to be kept of a lesson: a row for each thing, under the word that says what it is.
pub fn card(ui: &mut Ui, look: Look<'_>, card: &Card) {
    ui.add_space(8.0);
    let frame = Frame::new().fill(look.theme.hover).corner_radius(4.0);
    frame.inner_margin(Margin::same(10)).show(ui, |ui| {
        ui.spacing_mut().item_spacing.y = 4.0;
        ui.set_min_width(ui.available_width());
        let mut before = None;
        for (row, text) in &card.rows {
            if before != Some(*row) {
                if before.is_some() {
                    ui.add_space(6.0);
                }
                let word = look.say(row.name_key());
                ui.label(RichText::new(word).small().color(look.theme.accent));
            }
            running(ui, look, text);
            before = Some(*row);
        }
    });
}
