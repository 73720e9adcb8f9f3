//! One that has come: its chip, what it brings, how that compares, what becomes of it.

use egui::{Align2, Rect, Shape, Stroke, StrokeKind, Vec2, pos2, vec2};

use crate::{
    figure::{CellStage, Role, Story, StoryCard, StoryFate},
    text::Value,
};

use super::super::{
    on_slate::Links,
    raster::tone,
    slate::{Face, Slate, wash},
};

const NUMBER_PTS: f32 = 12.0;
const WORD_PTS: f32 = 11.5;
/// Side of the chip with the name, at least.
const CHIP: f32 = 18.0;
/// Height of a line.
const LINE: f32 = 18.0;
/// White space inside a card.
const PAD: Vec2 = vec2(8.0, 5.0);
/// Between the chip and the number.
const ASIDE: f32 = 9.0;

fn chip_width(slate: &Slate<'_>, card: &StoryCard) -> f32 {
    let style = (Face::Strong, NUMBER_PTS, slate.theme().ink);
    let name = slate.value(&card.name, style).size().x;
    (name + slate.pts(8.0)).max(slate.pts(CHIP))
}

/// What the largest needs.
pub fn size(slate: &Slate<'_>, story: &Story) -> Vec2 {
    let ink = slate.theme().ink;
    let widths = story.cards.iter().flat_map(|card| {
        let number = |value: &Value| slate.value(value, (Face::Mono, NUMBER_PTS, ink)).size().x;
        let first = chip_width(slate, card) + slate.pts(ASIDE) + number(&card.new.1);
        let word = slate
            .value(&card.word, (Face::Strong, WORD_PTS, ink))
            .size()
            .x;
        [first, number(&card.against), word]
    });
    let widest = widths.fold(slate.pts(46.0), f32::max);
    let pad = slate.pts(1.0) * PAD;
    vec2(widest, slate.pts(3.0 * LINE)) + 2.0 * pad
}

/// Draws it; what is under the pointer stands out.
pub fn draw(slate: &mut Slate<'_>, place: Rect, card: &StoryCard, links: &mut Links) {
    let theme = slate.theme();
    let round = slate.pts(4.0);
    let is_now = card.stage == CellStage::Current;
    let has_come = card.stage != CellStage::ToCome;
    let is_kept = card.fate == StoryFate::Kept;
    let fill = match (is_now, has_come && is_kept) {
        (true, _) => wash(theme, Role::Signal),
        (false, true) => theme.accent_wash,
        (false, false) => theme.background,
    };
    slate.painter.rect_filled(place, round, fill);
    let border = match (is_now, has_come, is_kept) {
        (true, _, _) => slate.stroke(2.0, theme.signal),
        (false, true, true) => slate.stroke(1.5, theme.accent),
        (false, true, false) => slate.stroke(1.25, theme.discarded),
        (false, false, _) => slate.stroke(1.0, theme.hairline),
    };
    border_of(slate, place, border, has_come && !is_kept);
    if links.touch(place, card.link) {
        let ring = slate.stroke(1.25, theme.accent);
        let around = place.expand(slate.pts(2.5));
        slate
            .painter
            .rect_stroke(around, round, ring, StrokeKind::Middle);
    }
    words(slate, place, card);
}

/// What stands in it: its name alone until it has come.
fn words(slate: &mut Slate<'_>, place: Rect, card: &StoryCard) {
    let theme = slate.theme();
    let is_now = card.stage == CellStage::Current;
    let has_come = card.stage != CellStage::ToCome;
    let inner = place.shrink2(slate.pts(1.0) * PAD);
    let line = |nth: usize| inner.top() + (nth as f32 + 0.5) * slate.pts(LINE);
    let [first, second, third] = [0, 1, 2].map(line);
    let chip = Rect::from_center_size(
        pos2(inner.left() + 0.5 * chip_width(slate, card), first),
        vec2(chip_width(slate, card), slate.pts(CHIP - 2.0)),
    );
    let ink = if has_come { theme.ink } else { theme.soft };
    if has_come {
        let (role, shade) = card.tone;
        let tone = tone(theme, role, shade);
        slate.painter.rect_filled(chip, slate.pts(3.0), tone);
    }
    let name = slate.value(&card.name, (Face::Strong, NUMBER_PTS, ink));
    slate.put(&name, chip.center(), Align2::CENTER_CENTER);
    if !has_come {
        return;
    }
    let number = if is_now { theme.signal_text } else { ink };
    let new = slate.value(&card.new.1, (Face::Mono, NUMBER_PTS, number));
    slate.put(&new, pos2(inner.right(), first), Align2::RIGHT_CENTER);
    let against = slate.value(&card.against, (Face::Mono, NUMBER_PTS, theme.soft));
    slate.put(&against, pos2(inner.right(), second), Align2::RIGHT_CENTER);
    let (face, ink) = match (is_now, card.fate == StoryFate::Kept) {
        (true, _) => (Face::Strong, theme.signal_text),
        (false, true) => (Face::Strong, theme.ink),
        (false, false) => (Face::Plain, theme.soft),
    };
    let word = slate.value(&card.word, (face, WORD_PTS, ink));
    slate.put(&word, pos2(inner.left(), third), Align2::LEFT_CENTER);
}

fn border_of(slate: &Slate<'_>, place: Rect, stroke: Stroke, is_dashed: bool) {
    if !is_dashed {
        let round = slate.pts(4.0);
        slate
            .painter
            .rect_stroke(place, round, stroke, StrokeKind::Inside);
        return;
    }
    let inner = place.shrink(0.5 * stroke.width);
    let corners = [
        inner.left_top(),
        inner.right_top(),
        inner.right_bottom(),
        inner.left_bottom(),
        inner.left_top(),
    ];
    let dash = slate.pts(3.5);
    let dashes = Shape::dashed_line(&corners, stroke, dash, 0.75 * dash);
    slate.painter.extend(dashes);
}

fn count_words(count: usize) -> String {
    format!("+{count}")
}

/// What the count of folded cards needs.
pub fn folded_width(slate: &Slate<'_>, story: &Story) -> f32 {
    let words = count_words(story.cards.len());
    let style = (Face::Plain, NUMBER_PTS, slate.theme().soft);
    slate.words(words, style).size().x + slate.pts(8.0)
}

/// How many are folded here.
pub fn folded(slate: &mut Slate<'_>, place: Rect, count: usize) {
    let theme = slate.theme();
    border_of(slate, place, slate.stroke(1.0, theme.discarded), true);
    let style = (Face::Plain, NUMBER_PTS, theme.soft);
    let words = slate.words(count_words(count), style);
    slate.put(&words, place.center(), Align2::CENTER_CENTER);
}
