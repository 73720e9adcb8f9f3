//! The depth buffer, shown: the ray in space, the picture with its depths, and the story of the pixel in hand.

mod curve;
mod names;
mod numbers;
mod raster;
mod variant;
mod views;

use crate::{
    algo::surface::{
        DepthBuffer, DepthBufferEvent as Event, DepthBufferInput, DepthBufferOutput, DepthSteps,
        Fragment,
    },
    figure::{Decides, Glimpse},
    labs::space::soup::order,
};

use super::prelude::*;

use variant::{CLEAR, COMPARE, FRAGMENT, TRIANGLE, Variant, WRITE};

/// More steps than these are not recorded: a step is then a row, or a whole triangle.
const MOST_STEPS: u64 = 100_000;

impl AnswerAsItIs for DepthBufferOutput {}

impl<L: Variant> SpaceTelling for DepthBuffer<L> {
    const SUBJECT: Subject = Subject::Surfaces;

    fn shown(step: &Step<'_, Self>, place: usize) -> Option<i32> {
        let whole = raster::whole_picture(&At {
            step: *step,
            scenery: None,
        });
        let so_far = whole.as_ref().unwrap_or(&step.held.so_far);
        so_far.picture.ids().get(place).copied()
    }

    fn input(scene: &Scene) -> DepthBufferInput {
        let surfaces = surfaces_on_raster(scene);
        let plan = &scene.raster;
        let mut own = DepthBufferInput {
            order: order(surfaces.triangles().len(), plan.shuffle),
            format: plan.format,
            steps: DepthSteps::Triangles,
            pixel: plan.pixel,
            surfaces,
        };
        let fragments = silent::<Self>(&own).tally.fragments;
        let [_, rows] = own.surfaces.size();
        own.steps = match plan.steps {
            DepthSteps::Fragments if fragments <= MOST_STEPS => DepthSteps::Fragments,
            DepthSteps::Fragments | DepthSteps::Spans
                if own.order.len() as u64 * u64::from(rows) <= MOST_STEPS =>
            {
                DepthSteps::Spans
            }
            DepthSteps::Fragments | DepthSteps::Spans | DepthSteps::Triangles => {
                DepthSteps::Triangles
            }
        };
        own
    }

    fn card(scene: &Scene) -> Option<&'static MethodCard> {
        let reversed = const {
            &MethodCard {
                code: L::REVERSED,
                ..MethodCard::of::<Self>()
            }
        };
        scene.raster.format.is_reversed.then_some(reversed)
    }
}

const COMPARED: &[&str] = &["{z}{sign}{stored}", "{blend}"];
const EMPTY: i32 = Picture::BACKGROUND;

const fn drawn(key: &'static str) -> Row {
    let row = Row::new(Phase, TRIANGLE, key).about("triangle");
    row.answers_as("drawn", "depth-answer-drawn")
}

const fn stays(key: &'static str) -> Row {
    Row::new(Test, COMPARE, key).so(COMPARED).about("at")
}

/// The row of a step at which a program writes what is behind.
fn of_mistake<L: Variant>(at: &At<'_, DepthBuffer<L>>) -> Option<&'static Row> {
    const KEPT_BEHIND: Row = Row::new(Cut, WRITE, "depth-fragment-kept-behind")
        .so(COMPARED)
        .keeps("at");
    let is_over = |it: &Fragment| it.kept && it.stored_id != EMPTY;
    let fragment = names::fragment_of(at).filter(is_over)?;
    let format = &at.step.input.format;
    let is_nearer = format.is_nearer::<f64>(fragment.new, fragment.stored);
    (!is_nearer).then_some(&KEPT_BEHIND)
}

impl<L: Variant> Telling for DepthBuffer<L> {
    type Scenery = Scenery;

    const ID: &'static str = L::ID;
    const NAME_KEY: &'static str = L::NAME_KEY;
    const SOURCE: &'static str = "Catmull, 1974";
    const CODE: &'static [CodeLine] = L::CODE;
    const DIFFERS_KEY: Option<&'static str> = L::DIFFERS_KEY;
    const WATCH: &'static [Watched] = &[Watched::Names(&[
        "watch-triangle",
        "watch-pixel",
        "z",
        "stored",
        "C",
        "watch-fragments",
        "watch-writes",
        "watch-pixels",
    ])];
    const OPENING: Row = Row::new(Phase, CLEAR, "depth-opening");

    table! { |event, step|
        clear: Event::Clear { .. } => Row::new(Phase, CLEAR, "depth-clear").so(&["~ z = {cleared}"]);
        unseen: Event::Triangle { drawn: false, .. } =>
            Row::new(Reject, TRIANGLE, "depth-triangle-unseen").answers("drawn").drops("triangle");
        whole: Event::Triangle { .. } if step.input.steps == DepthSteps::Triangles =>
            drawn("depth-triangle-whole");
        triangle: Event::Triangle { .. } => drawn("depth-triangle");
        span: Event::Span { .. } => Row::new(Test, FRAGMENT, "depth-span").about("triangle");
        first: Event::Fragment { fragment: Fragment { kept: true, stored_id: EMPTY, .. }, .. } =>
            Row::new(Cut, WRITE, "depth-fragment-first").so(COMPARED).answers("written").keeps("at");
        kept: Event::Fragment { fragment: Fragment { kept: true, .. }, .. } =>
            Row::new(Cut, WRITE, "depth-fragment-kept").so(COMPARED).answers("nearer").keeps("at");
        left_empty: Event::Fragment { fragment: Fragment { stored_id: EMPTY, .. }, .. } =>
            stays("depth-fragment-lost-to-nothing").answers("written");
        tie: Event::Fragment { fragment, .. } if fragment.new == fragment.stored =>
            stays("depth-fragment-tie").answers("nearer");
        lost: Event::Fragment { .. } => stays("depth-fragment-lost").answers("nearer");
        nothing: Event::Done if step.held.so_far.tally.pixels == 0 =>
            Row::new(Accept, COMPARE, "depth-done-nothing");
        done: Event::Done => Row::new(Accept, COMPARE, "depth-done").so(&["{average}"]);
    }

    fn opening(at: &At<'_, Self>) -> &'static Row {
        let surfaces = &at.step.input.surfaces;
        on_raster::opening(const { &Self::OPENING }, surfaces, at.scenery)
    }

    fn row_at(at: &At<'_, Self>) -> &'static Row {
        let other = || names::of_glass(at).or_else(|| of_mistake(at));
        let own = || other().unwrap_or_else(|| Self::row(&at.step));
        names::in_shades(at).map_or_else(own, |shades| shades.row)
    }

    fn named(at: &At<'_, Self>, name: &str) -> Option<Named> {
        names::named(at, name)
    }

    fn glimpse(at: &At<'_, Self>, row: &Row, _: Option<Link>) -> Glimpse {
        let pixels = raster::after(at, row.decides == Decides::Keeps);
        pixels.map_or(Glimpse::Nothing, Glimpse::Pixels)
    }

    fn views(at: &At<'_, Self>) -> Vec<View> {
        views::views(at)
    }
}
