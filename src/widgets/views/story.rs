//! What has come to a pixel: cards in order of arrival, and under them what was held, as stairs that fall.
//!
//! ```text
//!   pixel [8, 6], in order of arrival
//!   ┌─────────┐ ┌─────────┐ ┌╌╌╌╌╌╌╌╌╌┐
//!   │(A) 0.78 │ │(B) 0.74 │ ╎(C) 0.95 ╎
//!   │     < ∞ │ │  < 0.78 │ ╎  > 0.74 ╎
//!   │ written │ │ written │ ╎ lost    ╎
//!   └─────────┘ └─────────┘ └╌╌╌╌╌╌╌╌╌┘
//!   ∞┄┄┄┄┐                       ○
//!        ●───────────┐           ╎
//!                    ●───────────────
//! ```

mod plan;
mod stairs;

use crate::figure::{Story, StoryCard};

use super::prelude::*;

use plan::{GAP, MOST_CARDS, Plan, STAIRS, TITLE, card_size, draw_card};

const FOLD_BELOW: f32 = 0.8;

impl OnSlate for Story {
    fn slate<'a>(&self, natural: Slate<'a>, room: Vec2) -> Slate<'a> {
        let wanted = |slate: &Slate<'_>, most: usize| {
            let n = self.cards.len().clamp(1, most) as f32;
            let card = card_size(slate, self);
            let wide = n * card.x + (n - 1.0) * slate.pts(GAP) + plan::margin(slate, self);
            let titles = 2.0 * slate.pts(TITLE);
            vec2(wide, titles + card.y + slate.pts(GAP + STAIRS[0]))
        };
        // Cards are folded before their text becomes too small.
        let least = FOLD_BELOW.max(LEAST_SCALE * natural.scale);
        let slate = natural.shrunk_to(least, room, |slate| wanted(slate, MOST_CARDS));
        slate.fitted_in(room, |slate| wanted(slate, 2))
    }

    fn draw(&self, slate: &mut Slate<'_>, rect: Rect, links: &mut Links) {
        slate.title(&self.title, rect);
        if self.cards.is_empty() {
            return;
        }
        let plan = Plan::new(slate, rect, self);
        for (nth, idx) in plan.fold.shown.clone().enumerate() {
            draw_card(slate, plan.card(nth), &self.cards[idx], links);
        }
        let ends = [
            (plan.fold.before, plan.before),
            (plan.fold.after, plan.after),
        ];
        for (count, place) in ends {
            if count > 0 {
                plan::folded(slate, place, count);
            }
        }
        let top = plan.stairs.top() - slate.pts(TITLE);
        slate.title(&self.held, rect.with_min_y(top));
        stairs::draw(slate, self, &plan, links);
    }

    fn spoken(&self, look: Look<'_>) -> String {
        let said = |value: &Value| look.catalog.value(value);
        let has_come = |card: &&StoryCard| card.stage != CellStage::ToCome;
        let card = |card: &StoryCard| {
            let arrow = now(card.stage == CellStage::Current);
            let [name, new, against, word] =
                [&card.name, &card.new.1, &card.against, &card.word].map(said);
            format!("{arrow}{name}: {new} {against}, {word}")
        };
        let n_to_come = self.cards.iter().filter(|card| !has_come(card)).count();
        let rest = (n_to_come > 0).then(|| look.catalog.message(&more(n_to_come)));
        let cards = self.cards.iter().filter(has_come).map(card);
        format!("{}: {}", said(&self.title), joined(cards.chain(rest), "; "))
    }
}
