//! Ray casting, shown: the ray with its hits in space and on its own axis, every question, the picture so far.

mod names;
mod shadow;
mod views;

use crate::algo::surface::{
    Meeting::{BeforeNear, Behind, Beside, BeyondFar, Culled, Hit, Parallel},
    PlaneHit, RayCasting, RayCastingEvent as Event, RayCastingInput, RayCastingOutput,
};

use super::prelude::*;

pseudocode! {
    PIXEL: 0, "code-ray-pixel", "words-ray-pixel";
    TRIANGLE: 1, "code-ray-triangle", "words-ray-triangle";
    PARALLEL: 2, "code-ray-parallel", "words-ray-parallel";
    PLANE: 2, "code-ray-plane", "words-ray-plane";
    RANGE: 2, "code-ray-range", "words-ray-range";
    INSIDE: 2, "code-ray-inside", "words-ray-inside";
    NEAREST: 1, "code-ray-nearest", "words-ray-nearest";
}

/// More questions than these are not recorded: one ray is, through the pixel that is looked at.
const MOST_QUESTIONS: usize = 100_000;

impl AnswerAsItIs for RayCastingOutput {}

impl SpaceTelling for RayCasting {
    const SUBJECT: Subject = Subject::Surfaces;

    fn shown(step: &Step<'_, Self>, place: usize) -> Option<i32> {
        step.held.so_far.picture.ids().get(place).copied()
    }

    const MOST_FACES: usize = MOST_ASKED;

    fn input(scene: &Scene) -> RayCastingInput {
        let surfaces = surfaces_on_raster(scene);
        let size = surfaces.size();
        let is_long = surfaces.n_pixels() * surfaces.triangles().len() > MOST_QUESTIONS;
        let middle = is_long.then_some(size.map(|side| side / 2));
        let asked = scene.raster.pixel;
        let asked = asked.filter(|at| (0..2).all(|i| at[i] < size[i]));
        let pixel = asked.or(middle);
        RayCastingInput { surfaces, pixel }
    }
}

const QUOTIENT: &[&str] = &["{quotient}"];

const fn misses(line: usize, key: &'static str) -> Row {
    let row = Row::new(Test, line, key).so(QUOTIENT);
    row.answers("meets").drops("triangle")
}

const fn nearest(key: &'static str) -> Row {
    let row = Row::new(Cut, INSIDE, key).so(QUOTIENT);
    row.answers_as("meets", "ray-hit-first").keeps("triangle")
}

impl Telling for RayCasting {
    type Scenery = Scenery;

    const ID: &'static str = "ray-casting";
    const NAME_KEY: &'static str = "alg-ray-casting";
    const SOURCE: &'static str = "Appel, 1968";
    const CODE: &'static [CodeLine] = &LINES;
    const WATCH: &'static [Watched] = &[Watched::Names(&[
        "watch-pixel",
        "r",
        "watch-hits",
        "watch-nearest",
        "nearest t",
        "watch-asked",
    ])];
    const OPENING: Row = Row::new(Phase, PIXEL, "ray-opening");

    table! { |event, step|
        pixel: Event::Pixel { .. } => Row::new(Phase, PIXEL, "ray-pixel").so(&["r = {r}"]).about("at");
        culled: Event::Ask { found: PlaneHit { meeting: Culled, .. }, .. } =>
            misses(TRIANGLE, "ray-says-culled").so(&[]);
        parallel: Event::Ask { found: PlaneHit { meeting: Parallel, .. }, .. } =>
            misses(PARALLEL, "ray-says-parallel");
        behind: Event::Ask { found: PlaneHit { meeting: Behind, .. }, .. } =>
            misses(RANGE, "ray-says-behind");
        before_near: Event::Ask { found: PlaneHit { meeting: BeforeNear, .. }, .. } =>
            misses(RANGE, "ray-says-before-near");
        beyond_far: Event::Ask { found: PlaneHit { meeting: BeyondFar, .. }, .. } =>
            misses(RANGE, "ray-says-beyond-far");
        beside: Event::Ask { found: PlaneHit { meeting: Beside, .. }, .. } =>
            misses(INSIDE, "ray-says-beside");
        first: Event::Ask { found: PlaneHit { meeting: Hit, .. }, nearest: true, .. }
            if names::nearest_before(step.past).is_none() => nearest("ray-hit-first");
        nearer: Event::Ask { found: PlaneHit { meeting: Hit, .. }, nearest: true, .. } =>
            nearest("ray-hit-nearer");
        farther: Event::Ask { found: PlaneHit { meeting: Hit, .. }, nearest: false, .. } =>
            Row::new(Test, INSIDE, "ray-hit-farther").so(QUOTIENT)
                .answers_as("meets", "ray-answer-farther").drops("triangle");
        seen_before_others: Event::Seen { hit: Some(_), .. } if names::hits(step.past).count() > 1 =>
            Row::new(Accept, NEAREST, "ray-seen-before-others").so(&["{order}"])
                .picks("seen", "hits").keeps("at");
        seen: Event::Seen { hit: Some(_), .. } =>
            Row::new(Accept, NEAREST, "ray-seen").so(&["t = {t}"]).picks("seen", "hits").keeps("at");
        nothing: Event::Seen { hit: None, .. } =>
            Row::new(Reject, NEAREST, "ray-seen-nothing").picks("seen", "hits").drops("at");
        done: Event::Done => Row::new(Accept, NEAREST, "ray-done").so(&["{questions}"]);
    }

    fn named(at: &At<'_, Self>, name: &str) -> Option<Named> {
        names::named(at, name)
    }

    fn listed(at: &At<'_, Self>, list: &str) -> Vec<Named> {
        names::listed(at, list)
    }

    fn views(at: &At<'_, Self>) -> Vec<View> {
        views::views(at)
    }
}
