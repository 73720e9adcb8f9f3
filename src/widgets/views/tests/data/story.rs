//! What has come to a pixel, as in the prototype B4.

use crate::{
    figure::{CellStage, Role, Story, StoryCard, StoryFate},
    text::{Formula, Message, Value},
};

use super::name;

fn number(x: f64) -> Value {
    Value::Formula(if x.is_finite() {
        Formula::decimals().num(x)
    } else {
        Formula::decimals().sym("∞")
    })
}

/// These depths come, the smaller one wins; the one at `now` has come last.
pub fn story(depths: &[f64], now: usize) -> Story {
    let mut held = f64::INFINITY;
    let cards = depths.iter().enumerate().map(|(nth, &new)| {
        let stored = held;
        let (fate, sign) = match new.total_cmp(&stored) {
            std::cmp::Ordering::Less => (StoryFate::Kept, "< "),
            std::cmp::Ordering::Equal => (StoryFate::Tie, "= "),
            std::cmp::Ordering::Greater => (StoryFate::Lost, "> "),
        };
        held = held.min(new);
        let word = match fate {
            StoryFate::Kept => "story-kept",
            StoryFate::Lost => "story-lost",
            StoryFate::Tie => "story-tie",
        };
        let against = Formula::decimals().sym(sign);
        StoryCard {
            name: name(&format!("A{}", nth + 1)),
            tone: (Role::Soft, 0.2 * (nth % 5) as f64),
            new: (new, number(new)),
            against: Value::Formula(if stored.is_finite() {
                against.num(stored)
            } else {
                against.sym("∞")
            }),
            fate,
            word: Value::Term(word),
            stage: match nth.cmp(&now) {
                std::cmp::Ordering::Less => CellStage::Done,
                std::cmp::Ordering::Equal => CellStage::Current,
                std::cmp::Ordering::Greater => CellStage::ToCome,
            },
            link: None,
        }
    });
    let title = Message::new("story-title");
    Story {
        title: Value::Message(title.with("at", Formula::decimals().sym("[8, 6]"))),
        cards: cards.collect(),
        opening: (f64::INFINITY, number(f64::INFINITY)),
        held: Value::Term("story-held"),
        down: Value::Term("story-nearer"),
        is_reversed: false,
    }
}

/// Five, of which two lose.
pub fn five(now: usize) -> Story {
    story(&[0.742, 0.563, 0.624, 0.419, 0.674], now)
}

/// Many, of which every third is as near as what stands there.
pub fn many(n: usize, now: usize) -> Story {
    let depth = |i: usize| 0.9 - 0.6 * (i - i % 3) as f64 / n as f64;
    let depths: Vec<f64> = (0..n).map(depth).collect();
    story(&depths, now)
}
