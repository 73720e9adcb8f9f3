//! What has come to the pixel in hand: every fragment in order of arrival, and what the buffer held in between.

use crate::{
    algo::surface::{DepthBuffer, DepthBufferEvent as Event, Fragment, pixel_story},
    figure::{CellStage, Story, StoryCard, StoryFate},
};

use super::super::prelude::*;

use super::{
    names::{current, fragment_of},
    numbers::{against, value},
    variant::Variant,
};

pub fn story<L: Variant>(at: &At<'_, DepthBuffer<L>>, scenery: &Scenery, pixel: [u32; 2]) -> Story {
    let own = at.step.input;
    let format = &own.format;
    let told = pixel_story::<L>(own, pixel);
    let order_of = |id: u32| own.order.iter().position(|&other| other == id);
    let current = current(at);
    let now = current.and_then(order_of);
    let (is_done, fragment) = (at.step.event() == Some(Event::Done), fragment_of(at));
    let stage = |id: u32| {
        if fragment.is_some_and(|now| now.id == id) {
            CellStage::Current
        } else if is_done || order_of(id) < now {
            CellStage::Done
        } else {
            CellStage::ToCome
        }
    };
    let stays = told.iter().rposition(|fragment| fragment.kept);
    let card = |(nth, told): (usize, &Fragment)| {
        let fate = fate(told);
        let word = match fate {
            StoryFate::Kept if is_done && stays == Some(nth) => "story-stays",
            StoryFate::Kept => "story-kept",
            StoryFate::Lost => "story-lost",
            StoryFate::Tie => "story-tie",
        };
        StoryCard {
            name: name_of(at.scenery, told.id),
            tone: tone(told.id, current),
            new: (told.new, value(format, told.new)),
            against: against(format, told),
            fate,
            word: Value::Term(word),
            stage: stage(told.id),
            link: surface_link(scenery.scene(), told.id),
        }
    };
    let opening = told.first().map_or(format.nothing(), |first| first.stored);
    let title = Message::new("story-title").with("at", pixel_formula(pixel));
    Story {
        title: Value::Message(title),
        cards: told.iter().enumerate().map(card).collect(),
        opening: (opening, value(format, opening)),
        held: Value::Term("story-held"),
        down: Value::Term("story-nearer"),
        is_reversed: format.is_reversed,
    }
}

fn fate(fragment: &Fragment) -> StoryFate {
    if fragment.kept {
        StoryFate::Kept
    } else if fragment.new == fragment.stored {
        StoryFate::Tie
    } else {
        StoryFate::Lost
    }
}
