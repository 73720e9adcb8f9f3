//! The scene with the ray of the pixel in hand, the picture with its depths, and what has come to that pixel.

use crate::{
    algo::surface::{DepthBuffer, DepthBufferEvent as Event, DepthNumber, Fragment, pixel_story},
    figure::{CellStage, Story, StoryCard, StoryFate},
};

use super::super::{
    asks::asks,
    glass::{GLASS_VIEW, glass},
    prelude::*,
};

use super::{
    curve::{Landed, curves},
    names::{current, fragment_of, pixel_of},
    numbers::{against, t_of, value},
    raster::rasters,
    variant::Variant,
};

const CURVE_VIEW: &str = "curve";
const STORY_VIEW: &str = "story";

pub fn views<L: Variant>(at: &At<'_, DepthBuffer<L>>) -> Vec<View> {
    let mut views = on_raster::views(at, |scenery| {
        let scene = scenery.scene();
        let look = faces([(current(at), Role::Accent)], scene);
        let mut views = vec![scenery.observer_with(|_| Fate::ToCome, look, marks(at, scenery))];
        views.extend(rasters(at, scene));
        let (input, pixel) = (at.step.input, pixel_of(at));
        let format = &input.format;
        // Where steps of the format matter a curve tells what has come to a pixel.
        if format.number != DepthNumber::Double {
            let landed = pixel.map_or_else(Vec::new, |pixel| landed(at, pixel));
            let before = before(&input.surfaces, scene);
            let rays = Rays::of(&input.surfaces);
            let curves = curves(&rays, format, &landed, before.as_ref());
            views.push(View::new(CURVE_VIEW, Body::Multiples(curves)));
        } else if let Some(pixel) = pixel {
            let told = pixel_story::<L>(input, pixel);
            let stage = |id| stage(at, id);
            let glass = glass(scenery, &input.surfaces, (pixel, &told), stage);
            let story = || Body::Story(story(at, scenery, pixel));
            views.push(match glass.map(Body::Table) {
                Some(glass) => View::new(GLASS_VIEW, glass),
                None => View::new(STORY_VIEW, story()),
            });
        }
        views
    });
    let all = || silent::<DepthBuffer<L>>(at.step.input).tally.fragments as usize;
    let is_done = at.step.event() == Some(Event::Done);
    let said = ["{triangle}: {at}", "watch-fragments"];
    views.extend(asks(at, "asks-depth-buffer", said, is_done, all));
    views
}

/// The lines of sight with the near plane where it was.
fn before(surfaces: &Surfaces, scene: &Scene) -> Option<Rays> {
    let near = scene.raster.near_before?;
    let camera = scene.camera.with(|numbers| numbers.depths[0] = near).ok()?;
    let volume = *camera.camera().volume();
    Surfaces::new(surfaces.size(), volume, [], false).map(|none| Rays::of(&none))
}

fn marks<L: Variant>(at: &At<'_, DepthBuffer<L>>, scenery: &Scenery) -> Vec<Mark3> {
    let surfaces = &at.step.input.surfaces;
    let camera = scenery.scene().camera.camera();
    let rays = Rays::of(surfaces);
    let Some(fragment) = fragment_of(at) else {
        let far = |pixel| sight(surfaces, camera, pixel, rays.far());
        return pixel_of(at).map(far).unwrap_or_default();
    };
    let stored = at.step.input.format.turned(fragment.stored);
    let ray = rays.through(fragment.pixel);
    let t_of = |depth: f64| t_of::<L>(&rays, depth);
    let place = |depth: f64| camera.world_from_view(ray.at(t_of(depth)));
    let mut marks = sight(surfaces, camera, fragment.pixel, t_of(fragment.depth));
    if fragment.stored_id >= 0 && (0.0..=1.0).contains(&stored) {
        marks.push(Mark3::new(Role::Ink, Shape3::Ring(place(stored))));
    }
    let dot = place(fragment.depth);
    marks.push(Mark3::new(
        Role::Signal,
        if fragment.kept {
            Shape3::Dot(dot)
        } else {
            Shape3::Ring(dot)
        },
    ));
    marks
}

/// In which order the triangle comes, and how far the run is with it.
fn stage<L: Variant>(at: &At<'_, DepthBuffer<L>>, id: u32) -> CellStage {
    let order = &at.step.input.order;
    let order_of = |id: u32| order.iter().position(|&other| other == id);
    let is_done = at.step.event() == Some(Event::Done);
    if fragment_of(at).is_some_and(|now| now.id == id) {
        CellStage::Current
    } else if is_done || order_of(id) < current(at).and_then(order_of) {
        CellStage::Done
    } else {
        CellStage::ToCome
    }
}

fn landed<L: Variant>(at: &At<'_, DepthBuffer<L>>, pixel: [u32; 2]) -> Vec<Landed> {
    let told = pixel_story::<L>(at.step.input, pixel);
    let landed = told.iter().filter_map(|fragment| {
        let role = match stage(at, fragment.id) {
            CellStage::ToCome => return None,
            CellStage::Current => Role::Signal,
            CellStage::Done => Role::Ink,
        };
        let name = name_of(at.scenery, fragment.id);
        let depth = fragment.depth;
        Some(Landed { name, depth, role })
    });
    landed.collect()
}

/// What has come to the pixel in hand: every fragment in order of arrival, and what the buffer held in between.
fn story<L: Variant>(at: &At<'_, DepthBuffer<L>>, scenery: &Scenery, pixel: [u32; 2]) -> Story {
    let own = at.step.input;
    let format = &own.format;
    let told = pixel_story::<L>(own, pixel);
    let current = current(at);
    let is_done = at.step.event() == Some(Event::Done);
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
            tone: chip_tone(told.id, current),
            new: (told.new, value(format, told.new)),
            against: against(format, told),
            fate,
            word: Value::Term(word),
            stage: stage(at, told.id),
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

/// Tones are of depths: which triangle it is, its letter tells.
fn chip_tone(id: u32, current: Option<u32>) -> (Role, f64) {
    if Some(id) == current {
        (Role::Accent, 0.9)
    } else {
        (Role::Soft, 0.3)
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
