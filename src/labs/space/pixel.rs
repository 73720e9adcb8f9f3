//! Why a pixel of the camera's picture shows what it shows: all that covers it, the nearest of it, and how far beside it
//! something else is seen.

use std::{ops::ControlFlow, sync::Arc};

use crate::{
    algo::{
        ring::Right,
        surface::{DepthBufferInput, Fragment, pixel_story},
    },
    figure::{Caption, Shown},
    labs::{Own, prelude::*, words::pixel_formula},
};

use super::{
    RasterPlan, Scene, SpaceChange,
    soup::{place_of, surfaces_of},
};

const ROWS: u32 = RasterPlan::PICTURE_ROWS;
/// Columns are told apart in links by this many.
const STRIDE: usize = 1 << 12;
/// So far something else is looked for, in pixels.
const REACH: u32 = 120;
/// Sentences of a pixel's story.
const MOST_TOLD: usize = 3;
/// In a scene of more faces nothing else is looked for: it would take too long.
const MOST_FACES: usize = 2000;

/// One pixel further, and the catalogue key of where that is.
type Direction = ([i32; 2], &'static str);

const DIRECTIONS: [Direction; 4] = [
    ([1, 0], "pixel-right"),
    ([-1, 0], "pixel-left"),
    ([0, 1], "pixel-down"),
    ([0, -1], "pixel-up"),
];

/// What is about a place of the picture: x and y from −1 to 1, y up.
pub fn pixel_link(scene: &Scene, [x, y]: [f64; 2]) -> Link {
    let size = picture_size(scene);
    let place = |along: f64, side: u32| {
        let at = 0.5 * (along + 1.0) * f64::from(side);
        (at.max(0.0) as usize).min(side as usize - 1)
    };
    let [column, row] = [place(x, size[0]), place(-y, size[1])];
    Link::nth("pixel", row * STRIDE + column)
}

fn pixel_of(scene: &Scene, about: Link) -> Option<[u32; 2]> {
    let [width, height] = picture_size(scene);
    let nth = about.number_of("pixel")?;
    let pixel = [(nth % STRIDE) as u32, (nth / STRIDE) as u32];
    (pixel[0] < width && pixel[1] < height).then_some(pixel)
}

fn picture_size(scene: &Scene) -> [u32; 2] {
    super::screen::screen(scene.camera.aspect(), ROWS).size()
}

/// How a place is spoken of.
struct Said {
    seen: &'static str,
    empty: &'static str,
    other: &'static str,
    other_nothing: &'static str,
}

/// The pixels of a raster are seen, and counted.
const OF_PIXELS: Said = Said {
    seen: "pixel-seen",
    empty: "pixel-empty",
    other: "pixel-other",
    other_nothing: "pixel-other-nothing",
};
/// Nobody sees those of the camera's picture: it has parts of its width and its height.
const OF_PICTURE: Said = Said {
    seen: "picture-seen",
    empty: "picture-empty",
    other: "picture-other",
    other_nothing: "picture-other-nothing",
};

pub fn pixel_verdict(scene: &Scene, about: Link) -> Option<Verdict> {
    let pixel = pixel_of(scene, about)?;
    let input = DepthBufferInput::new(surfaces_of(scene, picture_size(scene)));
    Some(verdict_at(
        scene,
        &input,
        pixel,
        (&OF_PICTURE, &|_, _| true),
    ))
}

/// Of a pixel of the raster: what it shows at this step, by which step; where that is not what is nearest there, what is.
pub fn raster_verdict(scene: &Scene, about: Link, (run, step): AtStep<'_>) -> Option<Verdict> {
    let size = scene.raster.size(scene.camera.aspect());
    let place = about.number_of(Raster::LINK)?;
    let at = u32::try_from(place).ok()?;
    let pixel = [at % size[0], at / size[0]];
    if pixel[1] >= size[1] {
        return None;
    }
    let input = DepthBufferInput::new(surfaces_of(scene, size));
    let shown = (scene.method.info().shown_at)(scene, (step, place))?;
    let shown = u32::try_from(shown).ok();
    let nearest = seen_at(&input, pixel);
    let decided = run.why_until(about, step);
    let offer = Some(looking_at(scene, pixel));
    if shown == nearest {
        // Of pixels beside this one only what this picture shows there, too.
        let shows = |[column, row]: [u32; 2], id: Option<u32>| {
            let place = (row * size[0] + column) as usize;
            let there = (scene.method.info().shown_at)(scene, (step, place));
            there.is_some_and(|there| u32::try_from(there).ok() == id)
        };
        let step = decided;
        return Some(Verdict {
            step,
            offer,
            ..verdict_at(scene, &input, pixel, (&OF_PIXELS, &shows))
        });
    }
    let message = match shown {
        Some(id) => told_of(scene, id, Message::new("pixel-shows")),
        None => Message::new("pixel-shows-nothing"),
    };
    let why = message.with("at", pixel_formula(pixel));
    let said = match decided {
        Some(_) => story(run, (pixel, about), step, |shown| shown.caption()),
        None if step == run.n_steps() => story_alone(scene, pixel, about),
        None => Vec::new(),
    };
    let truth = match nearest {
        Some(id) => told_of(scene, id, Message::new("pixel-truth")),
        None => Message::new("pixel-truth-nothing"),
    };
    Some(Verdict {
        why: Caption::new(why),
        notes: said.into_iter().chain([truth]).collect(),
        step: decided,
        offer,
    })
}

/// What decided last about a pixel, up to a step, and what came there since and changed nothing.
fn story(
    run: &dyn Run,
    (pixel, about): ([u32; 2], Link),
    until: usize,
    caption: impl Fn(&dyn Shown) -> Caption,
) -> Vec<Message> {
    let at = Some(Value::from(pixel_formula(pixel)));
    let mut story = Vec::new();
    run.visit([1, until], &mut |_, shown| {
        if shown
            .decision()
            .is_some_and(|(_, decided)| decided == about)
        {
            story = vec![caption(shown).decision];
        } else if shown.question().is_some() && shown.named("at") == at {
            story.push(caption(shown).decision);
            // What is told of it has room for so much.
            story.truncate(MOST_TOLD);
        }
        ControlFlow::Continue(())
    });
    story
}

/// The same of a run of the pixel alone, where that of the whole picture goes by larger steps: its steps have other numbers.
fn story_alone(scene: &Scene, pixel: [u32; 2], about: Link) -> Vec<Message> {
    let mut alone = scene.clone();
    alone.raster.pixel = Some(pixel);
    let run = (alone.method.info().record)(&alone);
    let n_steps = run.n_steps();
    story(&*run, (pixel, about), n_steps, |shown| shown.unnumbered())
}

/// The raster with this pixel alone looked at, or with all again where it is already.
fn looking_at(scene: &Scene, pixel: [u32; 2]) -> (&'static str, Own) {
    let is_alone = scene.raster.pixel == Some(pixel);
    let mut plan = scene.raster;
    plan.pixel = (!is_alone).then_some(pixel);
    let keys = ["pixel-alone", "pixel-all"];
    let change: Own = Arc::new(SpaceChange::Raster(plan));
    (keys[usize::from(is_alone)], change)
}

/// With what is seen beside the pixel, where the picture that is asked about `shows` that.
fn verdict_at(
    scene: &Scene,
    input: &DepthBufferInput,
    pixel: [u32; 2],
    (words, shows): (&Said, Shows<'_>),
) -> Verdict {
    let story = pixel_story::<Right>(input, pixel);
    let seen = story.iter().rfind(|fragment| fragment.kept);
    let message = Message::new(match seen {
        Some(_) => words.seen,
        None => words.empty,
    });
    let message = message
        .with("at", pixel_formula(pixel))
        .with("count", story.len());
    let why = match seen {
        Some(fragment) => {
            let caption = Caption::new(told_of(scene, fragment.id, message));
            caption.so(depths(&story, fragment))
        }
        None => Caption::new(message),
    };
    let seen = seen.map(|fragment| fragment.id);
    let notes = other_beside(scene, input, (pixel, seen), (words, shows));
    Verdict {
        why,
        notes: notes.into_iter().collect(),
        step: None,
        offer: None,
    }
}

/// `0.834 < 0.861`: of what is seen, and of the next behind it.
fn depths(story: &[Fragment], seen: &Fragment) -> Formula {
    let others = story.iter().filter(|fragment| fragment.id != seen.id);
    let next = others.map(|fragment| fragment.depth).reduce(f64::min);
    let formula = Formula::decimals().sym("z = ").num(seen.depth);
    match next {
        Some(next) if next == seen.depth => formula.sym(" = ").num(next),
        Some(next) => formula.sym(" < ").num(next),
        None => formula,
    }
}

fn told_of(scene: &Scene, id: u32, message: Message) -> Message {
    let [object_idx, face_idx] = place_of(scene, id).unwrap_or_default();
    let message = message.with("object", scene.object_name(object_idx));
    message.with("face", Value::Count(face_idx + 1))
}

/// The fewest pixels to a side at which something else is seen.
fn other_beside(
    scene: &Scene,
    input: &DepthBufferInput,
    (pixel, seen): ([u32; 2], Option<u32>),
    (words, shows): (&Said, Shows<'_>),
) -> Option<Message> {
    if input.order.len() > MOST_FACES {
        return None;
    }
    let shift = shift(input, pixel, seen).filter(|shift| shows(shift.at, shift.seen))?;
    let message = match shift.seen {
        Some(id) => told_of(scene, id, Message::new(words.other)),
        None => Message::new(words.other_nothing),
    };
    let ([across, _], direction) = shift.direction;
    let side = input.surfaces.size()[usize::from(across == 0)];
    let percent = (100 * shift.by).div_ceil(side);
    let message = message.with("count", shift.by as usize);
    let message = message.with("percent", percent as usize);
    Some(message.with("direction", Value::Term(direction)))
}

/// Does a picture show this triangle, or nothing, at this pixel?
type Shows<'a> = &'a dyn Fn([u32; 2], Option<u32>) -> bool;

struct Shift {
    by: u32,
    direction: Direction,
    at: [u32; 2],
    seen: Option<u32>,
}

fn seen_at(input: &DepthBufferInput, pixel: [u32; 2]) -> Option<u32> {
    let story = pixel_story::<Right>(input, pixel);
    story.iter().rfind(|fragment| fragment.kept).map(|it| it.id)
}

/// The nearest pixel straight beside one where something else is seen than at it.
fn shift(input: &DepthBufferInput, pixel: [u32; 2], seen: Option<u32>) -> Option<Shift> {
    let size = input.surfaces.size();
    for by in 1..=REACH {
        for direction in DIRECTIONS {
            let moved = moved(pixel, direction, by);
            let inside = |i: usize| moved[i].filter(|&at| at < size[i]);
            let (Some(column), Some(row)) = (inside(0), inside(1)) else {
                continue;
            };
            let there = seen_at(input, [column, row]);
            if there != seen {
                return Some(Shift {
                    by,
                    direction,
                    at: [column, row],
                    seen: there,
                });
            }
        }
    }
    None
}

/// A pixel moved by so many; none where it would be left of or above all.
fn moved(pixel: [u32; 2], (steps, _): Direction, by: u32) -> [Option<u32>; 2] {
    std::array::from_fn(|i| pixel[i].checked_add_signed(steps[i] * by as i32))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::labs::frustum::first_scene;

    #[test]
    fn as_many_pixels_beside_something_else_is_seen_and_one_pixel_less_it_is_the_same() {
        let scene = first_scene();
        let size = picture_size(&scene);
        let input = DepthBufferInput::new(surfaces_of(&scene, size));
        let mut n_shifted = 0;
        for pixel in (0..12).map(|i| [size[0] * (2 * i + 1) / 24, size[1] / 2]) {
            let seen = seen_at(&input, pixel);
            let Some(shift) = shift(&input, pixel, seen) else {
                continue;
            };
            let after = |by: u32| {
                let at = moved(pixel, shift.direction, by);
                seen_at(&input, at.map(|x| x.expect("inside")))
            };
            assert_eq!(after(shift.by), shift.seen);
            assert_ne!(after(shift.by), seen);
            assert_eq!(after(shift.by - 1), seen);
            n_shifted += 1;
        }
        assert!(n_shifted > 6);
    }

    #[test]
    fn a_place_of_the_picture_is_its_pixel() {
        let scene = first_scene();
        let [width, height] = picture_size(&scene);
        let corner = |at| pixel_of(&scene, pixel_link(&scene, at));
        assert_eq!(corner([-1.0, 1.0]), Some([0, 0]));
        assert_eq!(corner([1.0, -1.0]), Some([width - 1, height - 1]));
        assert!(pixel_verdict(&scene, pixel_link(&scene, [0.0, 0.0])).is_some());
        assert!(pixel_verdict(&scene, Link::nth("face", 3)).is_none());
    }
}
