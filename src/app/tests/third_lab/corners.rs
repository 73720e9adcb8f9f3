//! An algorithm as small as can be: which corners of a box lie on the inner side of a plane.

use serde::Serialize;
use serde_json::{Value as Json, json};

use crate::{
    figure::{
        Body, Caption, Cell, Edge3, Facet, Link, Mark3, Pixel, Raster, Role, Seer, Shape3, Space,
        Table, TableRow, Tick, View, Watch, WatchRow, WatchSection,
    },
    geom::Orbit,
    labs::{Answer, CodeLine, Demo, Step},
    text::{Formula, Message, Value},
    trace::{Algorithm, Real},
};

/// A box around the origin, and the plane x = c.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Input {
    pub half: f64,
    pub c: f64,
}

#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum Event {
    Corner {
        corner_idx: usize,
        distance: f64,
        inside: bool,
    },
    Done {
        n_inside: usize,
    },
}

#[derive(Clone, PartialEq, Debug, Default)]
pub struct State {
    pub distances: Vec<f64>,
    pub n_inside: Option<usize>,
}

#[derive(Clone, Copy, PartialEq, Debug)]
pub struct NInside(pub usize);

impl Answer for NInside {
    fn json(&self) -> Json {
        json!({ "n_inside": self.0 })
    }
}

pub struct Corners;

pub fn corner(half: f64, idx: usize) -> [f64; 3] {
    [0, 1, 2].map(|axis| if idx >> axis & 1 == 1 { half } else { -half })
}

impl Algorithm for Corners {
    type Input = Input;
    type Output = NInside;
    type Event = Event;
    type State = State;

    fn run<R: Real>(input: &Input, mut emit: impl FnMut(Event)) -> NInside {
        let mut n_inside = 0;
        for corner_idx in 0..8 {
            let [x, ..] = corner(input.half, corner_idx);
            let distance = R::new(x) - R::new(input.c);
            let inside = distance >= R::new(0.0);
            n_inside += usize::from(inside);
            emit(Event::Corner {
                corner_idx,
                distance: distance.get(),
                inside,
            });
        }
        emit(Event::Done { n_inside });
        NInside(n_inside)
    }

    fn start(_: &Input) -> State {
        State::default()
    }

    fn apply(state: &mut State, event: Event) {
        match event {
            Event::Corner { distance, .. } => state.distances.push(distance),
            Event::Done { n_inside } => state.n_inside = Some(n_inside),
        }
    }

    fn finish(state: &State) -> NInside {
        NInside(state.n_inside.unwrap_or_default())
    }

    fn max_events(_: &Input) -> usize {
        9
    }
}

impl Demo for Corners {
    const ID: &'static str = "box-corners";
    const NAME_KEY: &'static str = "watch-crossings";
    const SOURCE: &'static str = "kept under tests";
    const CODE: &'static [CodeLine] = &[CodeLine {
        depth: 0,
        code: "code-cs-codes",
        words: "words-cs-codes",
    }];

    fn tick(event: &Event) -> Tick {
        match event {
            Event::Corner { .. } => Tick::Test,
            Event::Done { .. } => Tick::Accept,
        }
    }

    fn code_line(_: &Event, _: &State) -> usize {
        0
    }

    fn caption(event: &Event, _: &State, _: &Input) -> Caption {
        match *event {
            Event::Corner { distance, .. } => Caption::new(Message::new("sh-inside"))
                .so(Formula::default().sym("d").equals(distance)),
            Event::Done { n_inside } => Caption::new(Message::new("sh-inside"))
                .so(Formula::default().sym("n").equals(n_inside as f64)),
        }
    }

    fn opening(input: &Input) -> Caption {
        Caption::new(Message::new("sh-inside")).so(Formula::default().sym("c").equals(input.c))
    }

    fn views(step: &Step<'_, Self>) -> Vec<View> {
        let half = step.input.half;
        let current = match step.event {
            Some(Event::Corner { corner_idx, .. }) => Some(corner_idx),
            Some(Event::Done { .. }) | None => None,
        };
        let dot = current.map(|idx| {
            let mark = Mark3::new(Role::Signal, Shape3::Dot(corner(half, idx)));
            mark.labelled(Value::Name(format!("V{idx}")))
        });
        let facets = facets(half);
        let space = Space {
            title: None,
            seer: Seer::Eye(Orbit::new([0.0; 3], [30.0, 20.0], 12.0, 24.0)),
            edges: Edge3::of(&facets).into(),
            facets: facets.into(),
            marks: dot.into_iter().collect(),
        };
        vec![
            View::new("space", Body::Space(space)),
            View::new("distances", Body::Table(table(step.state, current))),
            View::new("raster", Body::Raster(raster(step.state, current))),
        ]
    }

    fn watch(step: &Step<'_, Self>) -> Watch {
        let n = step.state.n_inside.map(Value::Count);
        vec![WatchSection::list(vec![WatchRow::new(
            Value::Name("n".to_owned()),
            n,
        )])]
    }
}

fn table(state: &State, current: Option<usize>) -> Table {
    let row = |idx: usize| TableRow {
        name: Value::Name(format!("V{idx}")),
        cells: vec![Cell::new(
            Role::Ink,
            state.distances.get(idx).copied().map(Value::Number),
        )],
        is_current: current == Some(idx),
        link: None,
    };
    Table {
        header: vec![Formula::default().sym("V"), Formula::default().sym("d")],
        rows: (0..8).map(row).collect(),
        notes: Vec::new(),
    }
}

/// The corners as pixels, four by two, with their distances in them.
fn raster(state: &State, current: Option<usize>) -> Raster {
    let pixel = |idx: usize| match state.distances.get(idx) {
        Some(&distance) => Pixel {
            role: Some(Role::Accent),
            shade: distance.abs(),
            value: Some(Value::Number(distance)),
        },
        None => Pixel::EMPTY,
    };
    Raster {
        title: Value::Name("d".to_owned()),
        size: [4, 2],
        pixels: (0..8).map(pixel).collect(),
        scale: None,
        current: current.map(|idx| [idx % 4, idx / 4]),
        over: Vec::new(),
    }
}

/// The six faces, counter-clockwise from outside.
fn facets(half: f64) -> Vec<Facet> {
    const FACES: [[usize; 4]; 6] = [
        [0, 4, 6, 2],
        [1, 3, 7, 5],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 2, 3, 1],
        [4, 5, 7, 6],
    ];
    let facet = |face: [usize; 4]| Facet {
        corners: face.map(|idx| corner(half, idx)).to_vec(),
        role: Role::Accent,
        link: Some(Link::to("face")),
        skin: None,
    };
    FACES.map(facet).to_vec()
}
