//! Painter's algorithm, shown: the sorted list, who objects to whom, the order or the cycle, the picture growing.

mod captions;
mod graph;
mod overlap;
mod variant;
mod views;

use serde_json::{Value as Json, json};

use crate::{
    algo::{
        ring::Right,
        surface::{
            Painter, PainterAnswer, PainterEvent as Event, PainterOutput, PainterState as State,
            PairTest,
        },
    },
    figure::{Caption, Run, Tick, View, Watch, WatchRow, WatchSection},
    labs::{
        Answer, CodeLine, Demo, Step, record_beside,
        space::soup::surfaces_on_raster,
        space::{OnScene, OnSceneInput, Scene, Subject, demo::SpaceDemo},
    },
    text::Value,
};

use super::on_raster::opening;

use captions::Input;
use variant::Variant;

type Shown<L> = OnScene<Painter<L>>;

impl Answer for PainterOutput {
    fn json(&self) -> Json {
        match &self.answer {
            PainterAnswer::Order { order, picture } => json!({ "ids": picture, "order": order }),
            PainterAnswer::Cycle { cycle } => json!({ "cycle": cycle }),
        }
    }
}

impl<L: Variant> SpaceDemo for Shown<L> {
    const SUBJECT: Subject = Subject::Surfaces;

    fn input(scene: &Scene) -> Input {
        /// Pairs grow with the square: a longer run cannot be followed.
        const MOST_FACES: usize = 300;
        OnSceneInput::of(scene, surfaces_on_raster(scene).first(MOST_FACES))
    }

    fn record(scene: &Scene) -> Box<dyn Run> {
        record_beside::<Self, Shown<Right>>(Self::input(scene))
    }
}

impl<L: Variant> Demo for Shown<L> {
    const ID: &'static str = L::ID;
    const NAME_KEY: &'static str = L::NAME_KEY;
    const SOURCE: &'static str = "Newell, Newell & Sancha, 1972";
    const CODE: &'static [CodeLine] = L::CODE;
    const DIFFERS_KEY: Option<&'static str> = L::DIFFERS_KEY;

    fn tick(event: &Event) -> Tick {
        match event {
            Event::Key { .. } | Event::Sort { .. } => Tick::Phase,
            Event::Pair { .. } => Tick::Test,
            Event::Constraint { .. } | Event::Paint { .. } => Tick::Cut,
            Event::Cycle { .. } => Tick::Reject,
            Event::Place { .. } | Event::Done => Tick::Accept,
        }
    }

    fn code_line(event: &Event, before: &State) -> usize {
        match event {
            Event::Key { .. } => variant::KEY,
            Event::Sort { .. } => variant::SORT,
            Event::Pair {
                test: PairTest::Overlap,
                may: false,
                ..
            }
            | Event::Constraint { .. } => variant::OBJECT,
            Event::Pair { .. } => variant::ASK,
            Event::Cycle { .. } => variant::CYCLE,
            Event::Place { .. } => variant::PLACE,
            Event::Done if !before.cycle.is_empty() => variant::CYCLE,
            Event::Paint { .. } | Event::Done => variant::PAINT,
        }
    }

    fn caption(event: &Event, before: &State, input: &Input) -> Caption {
        captions::caption(event, before, input)
    }

    fn opening(input: &Input) -> Caption {
        opening("painter-opening", input.own.triangles().len(), input)
    }

    fn views(step: &Step<'_, Self>) -> Vec<View> {
        views::views(step)
    }

    fn watch(step: &Step<'_, Self>) -> Watch {
        let state = step.state;
        let tests = PairTest::ALL.into_iter().zip(state.tally.decided);
        let count = |n: u64| Some(Value::Count(n as usize));
        let mut rows = vec![WatchRow::new(
            Value::Term("watch-pairs"),
            count(state.tally.pairs),
        )];
        rows.extend(tests.map(|(test, n)| WatchRow::new(Value::Term(test_key(test)), count(n))));
        vec![WatchSection::list(rows)]
    }
}

const fn test_key(test: PairTest) -> &'static str {
    match test {
        PairTest::DepthExtents => "watch-depth-extents",
        PairTest::ScreenExtents => "watch-screen-extents",
        PairTest::BehindPlane => "watch-behind-plane",
        PairTest::BeforePlane => "watch-before-plane",
        PairTest::Overlap => "watch-overlap",
    }
}
