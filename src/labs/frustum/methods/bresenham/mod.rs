//! A line to its pixels, shown: the segment in the view volume, and the screen in large pixels.

mod captions;
mod line_ends;
mod picture;

use serde_json::{Value as Json, json};

use crate::{
    algo::pipeline::{
        DrawnSegment, LineToPixels, LineToPixelsEvent as Event, LineToPixelsInput,
        LineToPixelsState as State,
    },
    figure::{Body, Caption, Tick, View, Watch, WatchRow, WatchSection},
    labs::{Answer, CodeLine, Demo, Step, code_line, words::name},
    text::{Formula, Value},
};

use super::super::{
    OnScene, OnSceneInput, Scene, Subject, demo::SpaceDemo, screen::screen, stage::Fate,
};

use line_ends::{ends, lengths};

type Input = OnSceneInput<LineToPixelsInput>;
type Shown = OnScene<LineToPixels>;

const RASTER_VIEW: &str = "raster";

/// Rows of large pixels, and so many columns at most.
const ROWS: f64 = 15.0;
const MOST_COLUMNS: f64 = 40.0;

impl Answer for Vec<[i64; 2]> {
    fn json(&self) -> Json {
        json!({ "pixels": self })
    }
}

impl SpaceDemo for Shown {
    const SUBJECT: Subject = Subject::Segment;

    fn input(scene: &Scene) -> Input {
        let aspect = scene.camera.aspect();
        let rows = ROWS.min(MOST_COLUMNS / aspect).max(1.0) as u32;
        let drawn = DrawnSegment {
            ends: scene.places.segment(),
            camera: *scene.camera.camera(),
            viewport: screen(aspect, rows),
        };
        OnSceneInput::of(scene, LineToPixelsInput::Segment(drawn))
    }
}

impl Demo for Shown {
    const ID: &'static str = "bresenham";
    const NAME_KEY: &'static str = "alg-bresenham";
    const SOURCE: &'static str = "Bresenham, 1965";
    const CODE: &'static [CodeLine] = &[
        code_line(0, "code-drawn-project", "words-drawn-project"),
        code_line(0, "code-drawn-clip", "words-drawn-clip"),
        code_line(0, "code-drawn-divide", "words-drawn-divide"),
        code_line(0, "code-drawn-begin", "words-drawn-begin"),
        code_line(0, "code-drawn-put", "words-drawn-put"),
        code_line(1, "code-drawn-diagonal", "words-drawn-diagonal"),
        code_line(1, "code-drawn-straight", "words-drawn-straight"),
    ];

    fn tick(event: &Event) -> Tick {
        match event {
            Event::Project { .. } | Event::Divide { .. } | Event::Round { .. } => Tick::Phase,
            Event::Clip { .. } => Tick::Cut,
            Event::Reject => Tick::Reject,
            Event::Pixel { .. } => Tick::Test,
        }
    }

    fn code_line(event: &Event, before: &State) -> usize {
        match event {
            Event::Project { .. } => 0,
            Event::Clip { .. } | Event::Reject => 1,
            Event::Divide { .. } => 2,
            Event::Round { .. } => 3,
            Event::Pixel { .. } if before.pixels.is_empty() => 4,
            Event::Pixel { diagonal: true, .. } => 5,
            Event::Pixel {
                diagonal: false, ..
            } => 6,
        }
    }

    fn caption(event: &Event, before: &State, input: &Input) -> Caption {
        captions::caption(event, before, &input.own)
    }

    fn opening(input: &Input) -> Caption {
        captions::opening(&input.own)
    }

    fn views(step: &Step<'_, Self>) -> Vec<View> {
        let (Some(scenery), LineToPixelsInput::Segment(drawn)) =
            (step.input.scenery.as_deref(), &step.input.own)
        else {
            return Vec::new();
        };
        let marks = picture::marks(drawn, step.state, step.event);
        let raster = picture::raster(drawn, step.state, step.event);
        vec![
            scenery.observer(|_| Fate::ToCome, marks),
            View::new(RASTER_VIEW, Body::Raster(raster)),
        ]
    }

    fn watch(step: &Step<'_, Self>) -> Watch {
        let state = step.state;
        let mut rows = Vec::new();
        let mut row = |symbol: &str, formula: Formula| {
            rows.push(WatchRow::new(name(symbol), Some(Value::Formula(formula))));
        };
        for (symbol, at) in ["P₁", "P₂"].into_iter().zip(state.projected) {
            if let Some(at) = at {
                row(symbol, captions::list(&at));
            }
        }
        for (symbol, at) in ["P₁′", "P₂′"]
            .into_iter()
            .zip(state.clipped.into_iter().flatten())
        {
            row(symbol, captions::list(&at));
        }
        for (symbol, at) in ["S₁", "S₂"]
            .into_iter()
            .zip(state.screen.into_iter().flatten())
        {
            row(symbol, captions::list(&at));
        }
        if let Some(ends) = ends(&step.input.own, state) {
            let [a, b] = lengths(&ends);
            row("a", Formula::default().num(a as f64));
            row("b", Formula::default().num(b as f64));
        }
        if let Some(at) = state.pixels.last() {
            row("x, y", captions::list(&at.map(|x| x as f64)));
        }
        if let Some(error) = state.error {
            row("e", Formula::default().num(error as f64));
        }
        vec![WatchSection::list(rows)]
    }
}
