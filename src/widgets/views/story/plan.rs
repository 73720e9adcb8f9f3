//! Where the cards of a story stand, and the stairs under them.

use egui::{Color32, Rect, pos2, vec2};

use crate::{
    figure::{CellStage, Story, StoryCard},
    paint::Typeset,
    text::Value,
};

use super::super::{
    fold::Fold,
    slate::{Face, Slate},
};
use super::card;

/// Numbers on the stairs, in points.
pub const NUMBER_PTS: f32 = 11.0;
/// Height of a title, with the white space under it.
pub const TITLE: f32 = 23.0;
/// Between cards, and from them to the stairs.
pub const GAP: f32 = 8.0;
/// More cards than these are folded.
pub const MOST_CARDS: usize = 5;
/// Width of a card over what stands in it, at most.
const MOST_WIDTH: f32 = 1.35;
/// Height of the stairs: the least, and the most.
pub const STAIRS: [f32; 2] = [62.0, 120.0];

/// Room left of the stairs, for what was held at first.
pub fn margin(slate: &Slate<'_>, story: &Story) -> f32 {
    let words = [&story.opening.1, &story.down];
    let widths = words.map(|value| label(slate, value, slate.theme().soft).size().x);
    widths.into_iter().fold(0.0, f32::max) + slate.pts(14.0)
}

/// A number on the stairs.
pub fn label(slate: &Slate<'_>, value: &Value, ink: Color32) -> Typeset {
    slate.value(value, (Face::Mono, NUMBER_PTS, ink))
}

/// Where everything stands.
pub struct Plan {
    /// All there is.
    pub room: Rect,
    /// Which cards are shown.
    pub fold: Fold,
    first: Rect,
    step: f32,
    /// What is folded before and after the cards.
    pub before: Rect,
    pub after: Rect,
    /// The stairs' place.
    pub stairs: Rect,
    /// From the stairs' left edge: where the first comes, and from each to the next.
    pub columns: [f32; 2],
}

impl Plan {
    pub fn new(slate: &Slate<'_>, rect: Rect, story: &Story) -> Self {
        let least = card::size(slate, story);
        let margin = margin(slate, story);
        let gap = slate.pts(GAP);
        let room = rect.width() - margin;
        let n = story.cards.len();
        let stub = card::folded_width(slate, story);
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
        let right = if is_folded {
            cards_right + gap + stub
        } else {
            cards_right
        };
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
            after: at(cards_right + gap),
            stairs,
            columns,
        }
    }

    /// The place of the nth card that is shown.
    pub fn card(&self, nth: usize) -> Rect {
        self.first.translate(vec2(nth as f32 * self.step, 0.0))
    }

    /// Where one comes on the stairs.
    pub fn column(&self, idx: usize) -> f32 {
        self.stairs.left() + self.columns[0] + idx as f32 * self.columns[1]
    }
}

/// The one that has come last.
fn focus(story: &Story) -> usize {
    let is_current = |card: &StoryCard| card.stage == CellStage::Current;
    let has_come = |card: &StoryCard| card.stage != CellStage::ToCome;
    let last = story.cards.iter().rposition(has_come);
    let current = story.cards.iter().position(is_current);
    current.or(last).unwrap_or(0)
}
