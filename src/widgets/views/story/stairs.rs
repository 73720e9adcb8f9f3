//! What was held, as stairs: filled dots on them were kept, hollow ones above them were not.

use crate::figure::{Story, StoryCard, StoryFate};

use super::{
    super::prelude::*,
    plan::{NUMBER_PTS, Plan, label},
};

const DOT: f32 = 4.5;
const AIR: f32 = 8.0;
const BEYOND: f32 = 0.24;

struct Scale {
    room: Rect,
    ends: [f64; 2],
    is_reversed: bool,
    has_infinite: bool,
}

impl Scale {
    /// Of everything that comes, from the start, so that nothing moves.
    fn of(slate: &Slate<'_>, story: &Story, stairs: Rect) -> Self {
        let cards = story.cards.iter().map(|card| card.new.0);
        let held: Vec<f64> = std::iter::once(story.opening.0).chain(cards).collect();
        let numbers = held.iter().copied().filter(|x| x.is_finite());
        let low = numbers.clone().fold(f64::INFINITY, f64::min);
        let high = numbers.fold(f64::NEG_INFINITY, f64::max);
        Self {
            room: stairs.shrink2(vec2(0.0, slate.pts(AIR))),
            ends: [low, high],
            is_reversed: story.is_reversed,
            has_infinite: held.iter().any(|x| !x.is_finite()),
        }
    }

    fn y(&self, x: f64) -> f32 {
        let [low, high] = self.ends;
        if !x.is_finite() {
            // Farther than everything, or nearer.
            let is_far = (x > 0.0) != self.is_reversed;
            let room = self.room.y_range();
            return if is_far { room.min } else { room.max };
        }
        let part = if high > low {
            ((x - low) / (high - low)) as f32
        } else {
            0.5
        };
        let down = if self.is_reversed { part } else { 1.0 - part };
        let top = if self.has_infinite { BEYOND } else { 0.0 };
        self.room.top() + self.room.height() * (top + (1.0 - top) * down)
    }
}

type Dot<'s> = (Pos2, &'s StoryCard, bool);

pub fn draw(slate: &mut Slate<'_>, story: &Story, plan: &Plan, links: &mut Links) {
    if plan.fold.before + plan.fold.after > 0 {
        // Where on the whole stairs the cards stand that are shown.
        let half = 0.5 * plan.columns[1];
        let left = plan.column(plan.fold.shown.start) - half;
        let right = plan.column(plan.fold.shown.end.saturating_sub(1)) + half;
        let band = Rect::from_x_y_ranges(left..=right, plan.stairs.y_range());
        slate.painter.rect_filled(band, 3.0, slate.theme().panel);
    }
    // Strokes first: numbers find their places beside them.
    let dots = treads(slate, story, plan);
    let square = |at: Pos2, side: f32| Rect::from_center_size(at, Vec2::splat(side));
    for &(at, card, is_now) in &dots {
        dot(slate, at, card, is_now);
        links.touch(square(at, slate.pts(4.0 * DOT)), card.link);
    }
    // The current one's number first, then the last ones': where there is little room, the first ones have none.
    let now = dots.iter().filter(|(.., is_now)| *is_now);
    let others = dots.iter().rev().filter(|(.., is_now)| !is_now);
    let reach = slate.pts(2.0 * DOT);
    let around: Vec<Rect> = dots.iter().map(|(at, ..)| square(*at, reach)).collect();
    for &(at, card, is_now) in now.chain(others) {
        number(slate, plan, (at, &around), card, is_now);
    }
}

fn treads<'s>(slate: &mut Slate<'_>, story: &'s Story, plan: &Plan) -> Vec<Dot<'s>> {
    let scale = Scale::of(slate, story, plan.stairs);
    let theme = slate.theme();
    let line = slate.stroke(2.25, theme.accent);
    let mut held = story.opening.0;
    let mut from = pos2(plan.stairs.left(), scale.y(held));
    // What was held at first, left of where the stairs begin.
    let opening = label(slate, &story.opening.1, theme.soft);
    let left = from - vec2(slate.pts(5.0), 0.0);
    let opening = slate.put(&opening, left, Align2::RIGHT_CENTER);
    axis(slate, story, plan, opening);
    let has_come = |card: &&StoryCard| card.stage != CellStage::ToCome;
    let mut dots = Vec::new();
    for (idx, card) in story.cards.iter().take_while(has_come).enumerate() {
        let x = plan.column(idx);
        let at = pos2(x, scale.y(card.new.0));
        let corner = pos2(x, from.y);
        if card.fate == StoryFate::Kept {
            tread(slate, [from, corner], line, held.is_finite());
            slate.line([corner, at], line);
            held = card.new.0;
            from = at;
        } else if (at.y - corner.y).abs() > slate.pts(DOT) {
            let fall = slate.stroke(1.25, theme.soft);
            slate.dashed([at, corner], fall, 3.0);
        }
        dots.push((at, card, card.stage == CellStage::Current));
    }
    let end = match dots.len() {
        n if n == story.cards.len() => plan.stairs.right(),
        0 => plan.stairs.left() + 0.5 * plan.columns[0],
        n => plan.column(n - 1) + 0.45 * plan.columns[1],
    };
    tread(slate, [from, pos2(end, from.y)], line, held.is_finite());
    dots
}

fn tread(slate: &mut Slate<'_>, ends: [Pos2; 2], stroke: Stroke, is_number: bool) {
    if is_number {
        slate.line(ends, stroke);
    } else {
        slate.dashed(ends, stroke, 3.5);
    }
}

fn dot(slate: &Slate<'_>, at: Pos2, card: &StoryCard, is_now: bool) {
    let theme = slate.theme();
    let radius = slate.pts(DOT);
    let ink = |ink| if is_now { theme.signal } else { ink };
    let (radius, fill, width, rim) = match card.fate {
        StoryFate::Kept => (radius + 1.0, ink(theme.accent), 1.5, theme.background),
        StoryFate::Lost | StoryFate::Tie => (radius, theme.background, 1.75, ink(theme.soft)),
    };
    let rim = slate.stroke(width, rim);
    slate.painter.circle(at, radius, fill, rim);
}

/// What it brings, beside its dot; of one that is as good as what is held, with a sign of equality.
fn number(
    slate: &mut Slate<'_>,
    plan: &Plan,
    (at, dots): (Pos2, &[Rect]),
    card: &StoryCard,
    is_now: bool,
) {
    let theme = slate.theme();
    let ink = match (card.fate, is_now) {
        (_, true) => theme.signal_text,
        (StoryFate::Kept, false) => theme.accent,
        (StoryFate::Lost | StoryFate::Tie, false) => theme.soft,
    };
    let words = match card.fate {
        StoryFate::Tie => &card.against,
        StoryFate::Kept | StoryFate::Lost => &card.new.1,
    };
    let words = label(slate, words, ink);
    let off = 0.5 * words.size() + Vec2::splat(slate.pts(DOT + 4.0));
    let [above, below] = [vec2(0.0, -off.y), vec2(0.0, off.y)];
    let [left, right] = [vec2(-off.x, 0.0), vec2(off.x, 0.0)];
    let low = vec2(0.0, 0.6 * off.y);
    let places = match card.fate {
        StoryFate::Kept => [left, left + low, below, right - low, right + low, above],
        StoryFate::Lost | StoryFate::Tie => [right, left, above, right - low, left - low, below],
    };
    let around = vec2(slate.pts(4.0), slate.pts(3.0));
    let room = plan.stairs.expand2(around).intersect(plan.room);
    let is_clear = |at: &Pos2| {
        let place = Rect::from_center_size(*at, words.size());
        !dots.iter().any(|dot| dot.intersects(place))
    };
    let places = places.into_iter().map(|off| at + off).filter(is_clear);
    slate.put_free(&words, room, places);
}

fn axis(slate: &mut Slate<'_>, story: &Story, plan: &Plan, opening: Rect) {
    let theme = slate.theme();
    let down = slate.value(&story.down, (Face::Plain, NUMBER_PTS, theme.soft));
    let gap = slate.pts(3.0);
    let is_under = opening.center().y < plan.stairs.center().y;
    let [top, bottom] = if is_under {
        [opening.bottom() + gap, plan.stairs.bottom()]
    } else {
        [plan.stairs.top(), opening.top() - gap]
    };
    if bottom - top < down.size().y {
        return;
    }
    let at = pos2(plan.stairs.left() - slate.pts(5.0), bottom);
    let put = slate.put(&down, at, Align2::RIGHT_BOTTOM);
    let foot = put.top() - gap;
    if foot - top > slate.pts(12.0) {
        let stroke = slate.stroke(1.0, theme.soft);
        let x = put.center().x;
        slate.arrow([pos2(x, top), pos2(x, foot)], stroke);
    }
}
