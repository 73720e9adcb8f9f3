//! The depth buffer, shown: the ray in space, the picture with its depths, and the story of the pixel in hand.

mod captions;
mod curve;
mod numbers;
mod shades;
mod story;
mod variant;
mod views;

use serde_json::{Value as Json, json};

use crate::{
    algo::{
        ring::Right,
        surface::{
            DepthBuffer, DepthBufferEvent as Event, DepthBufferInput, DepthBufferOutput,
            DepthBufferState as State, DepthSteps,
        },
    },
    figure::{Caption, Run, Tick, View, Watch, WatchRow, WatchSection},
    labs::{
        Answer, CodeLine, Demo, MethodCard, Step, record_beside,
        space::soup::{order, surfaces_on_raster},
        space::{OnScene, OnSceneInput, Scene, Subject, demo::SpaceDemo},
        words::{name, pixel_formula},
    },
    text::Value,
    trace::silent,
};

use super::on_raster::{depth_list, name_of};

use captions::Input;
use variant::Variant;

/// More steps than these are not recorded: a step is then a row, or a whole triangle.
const MOST_STEPS: u64 = 100_000;

type Shown<L> = OnScene<DepthBuffer<L>>;

impl Answer for DepthBufferOutput {
    fn json(&self) -> Json {
        json!({ "ids": self.picture, "depth": depth_list(&self.depth) })
    }
}

impl<L: Variant> SpaceDemo for Shown<L> {
    const SUBJECT: Subject = Subject::Surfaces;

    fn input(scene: &Scene) -> Input {
        let surfaces = surfaces_on_raster(scene);
        let plan = &scene.raster;
        let mut own = DepthBufferInput {
            order: order(surfaces.triangles().len(), plan.shuffle),
            format: plan.format,
            steps: DepthSteps::Triangles,
            pixel: plan.pixel,
            surfaces,
        };
        let fragments = silent::<DepthBuffer<L>>(&own).tally.fragments;
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
        OnSceneInput::of(scene, own)
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

    fn record(scene: &Scene) -> Box<dyn Run> {
        record_beside::<Self, Shown<Right>>(Self::input(scene))
    }
}

impl<L: Variant> Demo for Shown<L> {
    const ID: &'static str = L::ID;
    const NAME_KEY: &'static str = L::NAME_KEY;
    const SOURCE: &'static str = "Catmull, 1974";
    const CODE: &'static [CodeLine] = L::CODE;
    const DIFFERS_KEY: Option<&'static str> = L::DIFFERS_KEY;

    fn tick(event: &Event) -> Tick {
        match event {
            Event::Triangle { drawn: false, .. } => Tick::Reject,
            Event::Clear { .. } | Event::Triangle { .. } => Tick::Phase,
            Event::Fragment { fragment, .. } if fragment.kept => Tick::Cut,
            Event::Span { .. } | Event::Fragment { .. } => Tick::Test,
            Event::Done => Tick::Accept,
        }
    }

    fn code_line(event: &Event, _: &State) -> usize {
        match event {
            Event::Clear { .. } => variant::CLEAR,
            Event::Triangle { .. } => variant::TRIANGLE,
            Event::Span { .. } => variant::FRAGMENT,
            Event::Fragment { fragment, .. } if fragment.kept => variant::WRITE,
            Event::Fragment { .. } | Event::Done => variant::COMPARE,
        }
    }

    fn caption(event: &Event, before: &State, input: &Input) -> Caption {
        captions::caption::<L>(event, before, input)
    }

    fn opening(input: &Input) -> Caption {
        captions::opening(input)
    }

    fn views(step: &Step<'_, Self>) -> Vec<View> {
        views::views(step)
    }

    fn watch(step: &Step<'_, Self>) -> Watch {
        let state = step.state;
        let tally = state.so_far.tally;
        let format = &step.input.own.format;
        let triangle = state.triangle.map(|(id, _)| name_of(step.input, id));
        let pixel = views::pixel_of(step).map(|at| Value::Formula(pixel_formula(at)));
        let count = |n: u64| Some(Value::Count(n as usize));
        let term = |key| Value::Term(key);
        let fragment = state.fragment;
        let rows = vec![
            WatchRow::new(term("watch-triangle"), triangle),
            WatchRow::new(term("watch-pixel"), pixel),
            WatchRow::new(
                name("z"),
                fragment.map(|fragment| numbers::value(format, fragment.new)),
            ),
            WatchRow::new(
                term("story-stored"),
                fragment.map(|fragment| numbers::value(format, fragment.stored)),
            ),
            WatchRow::new(term("watch-fragments"), count(tally.fragments)),
            WatchRow::new(term("watch-writes"), count(tally.writes)),
            WatchRow::new(term("watch-pixels"), count(tally.pixels)),
        ];
        vec![WatchSection::list(rows)]
    }
}
