//! Where the cards of a story stand, and the stairs under them; and the cards themselves.

use crate::figure::{Story, StoryCard, StoryFate};

use super::super::prelude::*;

const CARD_PTS: f32 = 12.0;
pub const NUMBER_PTS: f32 = 11.0;
pub const TITLE: f32 = 23.0;
pub const GAP: f32 = 8.0;
pub const MOST_CARDS: usize = 5;
const MOST_WIDTH: f32 = 1.35;
pub const STAIRS: [f32; 2] = [62.0, 120.0];
const WORD_PTS: f32 = 11.5;
const CHIP: f32 = 18.0;
const LINE: f32 = 18.0;
const PAD: Vec2 = vec2(8.0, 5.0);
const ASIDE: f32 = 9.0;

pub fn margin(slate: &Slate<'_>, story: &Story) -> f32 {
    let words = [&story.opening.1, &story.down];
    let widths = words.map(|value| label(slate, value, slate.theme().soft).size().x);
    widths.into_iter().fold(0.0, f32::max) + slate.pts(14.0)
}

pub fn label(slate: &Slate<'_>, value: &Value, ink: Color32) -> Typeset {
    slate.value(value, (Face::Mono, NUMBER_PTS, ink))
}

pub struct Plan {
    pub room: Rect,
    pub fold: Fold,
    first: Rect,
    step: f32,
    pub before: Rect,
    pub after: Rect,
    pub stairs: Rect,
    /// From the stairs' left edge: where the first comes, and from each to the next.
    pub columns: [f32; 2],
}

impl Plan {
    pub fn new(slate: &Slate<'_>, rect: Rect, story: &Story) -> Self {
        let least = card_size(slate, story);
        let margin = margin(slate, story);
        let gap = slate.pts(GAP);
        let room = rect.width() - margin;
        let n = story.cards.len();
        let stub = folded_width(slate, story);
        let fits = |room: f32| ((room + gap) / (least.x + gap) + 0.01) as usize;
        let is_folded = n > MOST_CARDS || n > fits(room);
        let focus = focus(story);
        let fold = if is_folded {
            let n_fit = fits(room - 2.0 * (stub + gap)).clamp(1, MOST_CARDS);
            Fold::about_middle(n, focus, n_fit)
        } else {
            Fold::about(n, Some(focus), n)
        };
        let stubs = if is_folded { 2.0 * (stub + gap) } else { 0.0 };
        let n_shown = fold.shown.len() as f32;
        let width = (room - stubs - (n_shown - 1.0) * gap) / n_shown;
        let width = width.min(MOST_WIDTH * least.x).max(least.x).floor();
        let left = rect.left() + margin;
        let top = (rect.top() + slate.pts(TITLE)).round();
        let first_left = if is_folded { left + stub + gap } else { left };
        let first = Rect::from_min_size(pos2(first_left, top), vec2(width, least.y));
        let step = width + gap;
        let cards_right = first_left + n_shown * step - gap;
        let at = |left: f32| Rect::from_min_size(pos2(left, top), vec2(stub, least.y));
        let stairs_top = first.bottom() + gap + slate.pts(TITLE);
        let height = rect.bottom() - stairs_top;
        let height = height.clamp(slate.pts(8.0), slate.pts(STAIRS[1]));
        let after = cards_right + gap;
        let right = if is_folded { after + stub } else { cards_right };
        let stairs = Rect::from_min_max(pos2(left, stairs_top), pos2(right, stairs_top + height));
        let columns = if is_folded {
            let each = stairs.width() / n as f32;
            [0.5 * each, each]
        } else {
            [0.5 * width, step]
        };
        Self {
            room: rect,
            fold,
            first,
            step,
            before: at(left),
            after: at(after),
            stairs,
            columns,
        }
    }

    pub fn card(&self, nth: usize) -> Rect {
        self.first.translate(vec2(nth as f32 * self.step, 0.0))
    }

    pub fn column(&self, idx: usize) -> f32 {
        self.stairs.left() + self.columns[0] + idx as f32 * self.columns[1]
    }
}

fn focus(story: &Story) -> usize {
    let is_current = |card: &StoryCard| card.stage == CellStage::Current;
    let has_come = |card: &StoryCard| card.stage != CellStage::ToCome;
    let last = story.cards.iter().rposition(has_come);
    let current = story.cards.iter().position(is_current);
    current.or(last).unwrap_or(0)
}

fn chip_width(slate: &Slate<'_>, card: &StoryCard) -> f32 {
    let name = slate.width(&card.name, Face::Strong, CARD_PTS);
    (name + slate.pts(8.0)).max(slate.pts(CHIP))
}

pub fn card_size(slate: &Slate<'_>, story: &Story) -> Vec2 {
    let number = |value: &Value| slate.width(value, Face::Mono, CARD_PTS);
    let widths = story.cards.iter().flat_map(|card| {
        let first = chip_width(slate, card) + slate.pts(ASIDE) + number(&card.new.1);
        let word = slate.width(&card.word, Face::Strong, WORD_PTS);
        [first, number(&card.against), word]
    });
    let widest = widths.fold(slate.pts(46.0), f32::max);
    let pad = slate.pts(1.0) * PAD;
    vec2(widest, slate.pts(3.0 * LINE)) + 2.0 * pad
}

pub fn draw_card(slate: &mut Slate<'_>, place: Rect, card: &StoryCard, links: &mut Links) {
    let theme = slate.theme();
    let round = slate.pts(4.0);
    let is_now = card.stage == CellStage::Current;
    let has_come = card.stage != CellStage::ToCome;
    let is_kept = card.fate == StoryFate::Kept;
    let (fill, width, border) = match (is_now, has_come, is_kept) {
        (true, ..) => (wash(theme, Role::Signal), 2.0, theme.signal),
        (false, true, true) => (theme.accent_wash, 1.5, theme.accent),
        (false, true, false) => (theme.background, 1.25, theme.discarded),
        (false, false, _) => (theme.background, 1.0, theme.hairline),
    };
    slate.painter.rect_filled(place, round, fill);
    let border = slate.stroke(width, border);
    border_of(slate, place, border, has_come && !is_kept);
    if links.touch(place, card.link) {
        slate.ring(place.expand(slate.pts(2.5)), round, 1.25);
    }
    words(slate, place, card);
}

fn words(slate: &mut Slate<'_>, place: Rect, card: &StoryCard) {
    let theme = slate.theme();
    let is_now = card.stage == CellStage::Current;
    let has_come = card.stage != CellStage::ToCome;
    let inner = place.shrink2(slate.pts(1.0) * PAD);
    let line = |nth: usize| inner.top() + (nth as f32 + 0.5) * slate.pts(LINE);
    let [first, second, third] = [0, 1, 2].map(line);
    let size = vec2(chip_width(slate, card), slate.pts(CHIP - 2.0));
    let chip = Rect::from_center_size(pos2(inner.left() + 0.5 * size.x, first), size);
    let ink = if has_come { theme.ink } else { theme.soft };
    if has_come {
        let (role, shade) = card.tone;
        let tone = tone(theme, role, shade);
        slate.painter.rect_filled(chip, slate.pts(3.0), tone);
    }
    let name = slate.value(&card.name, (Face::Strong, CARD_PTS, ink));
    slate.put(&name, chip.center(), Align2::CENTER_CENTER);
    if !has_come {
        return;
    }
    let number = if is_now { theme.signal_text } else { ink };
    let new = slate.value(&card.new.1, (Face::Mono, CARD_PTS, number));
    slate.put(&new, pos2(inner.right(), first), Align2::RIGHT_CENTER);
    let against = slate.value(&card.against, (Face::Mono, CARD_PTS, theme.soft));
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
    if is_dashed {
        slate.dashed_box(place.shrink(0.5 * stroke.width), stroke, 0.75);
    } else {
        slate.rim(place, slate.pts(4.0), stroke, StrokeKind::Inside);
    }
}

fn count(slate: &Slate<'_>, n: usize) -> Typeset {
    let style = (Face::Plain, CARD_PTS, slate.theme().soft);
    slate.words(format!("+{n}"), style)
}

fn folded_width(slate: &Slate<'_>, story: &Story) -> f32 {
    count(slate, story.cards.len()).size().x + slate.pts(8.0)
}

pub fn folded(slate: &mut Slate<'_>, place: Rect, n: usize) {
    let border = slate.stroke(1.0, slate.theme().discarded);
    border_of(slate, place, border, true);
    let words = count(slate, n);
    slate.put(&words, place.center(), Align2::CENTER_CENTER);
}
