//! An algorithm as small as can be: which corners of a box lie on the inner side of a plane.

use serde::Serialize;
use serde_json::json;

use crate::{
    figure::{
        Body, Cell, Edge3, Edging, Facet, Link, Mark3, Role, Seer, Shape3, Space, Table, TableRow,
        Tick, View,
    },
    geom::Orbit,
    labs::{
        Answer, CodeLine,
        telling::{At, Named, Row, Telling, Watched, table},
    },
    text::{Formula, Value},
    trace::{Method, Real, Tell, Told},
};

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
    Done,
}

#[derive(Clone, Copy, PartialEq, Debug)]
pub struct NInside(pub usize);

impl Answer for NInside {
    fn told(&self) -> impl Serialize {
        json!({ "n_inside": self.0 })
    }
}

pub struct Corners;

pub fn corner(half: f64, idx: usize) -> [f64; 3] {
    [0, 1, 2].map(|axis| if idx >> axis & 1 == 1 { half } else { -half })
}

impl Method for Corners {
    type Input = Input;
    type Held = NInside;
    type Output = NInside;
    type Event = Event;

    fn begin(_: &Input) -> NInside {
        NInside(0)
    }

    fn run<R: Real, T: Tell<Self>>(
        input: &Input,
        held: &mut NInside,
        tell: &mut T,
    ) -> Told<T::Stop> {
        for corner_idx in 0..8 {
            let [x, ..] = corner(input.half, corner_idx);
            let distance = R::new(x) - R::new(input.c);
            let inside = distance >= R::new(0.0);
            held.0 += usize::from(inside);
            let distance = distance.get();
            let event = Event::Corner {
                corner_idx,
                distance,
                inside,
            };
            tell.tell(held, event)?;
        }
        tell.tell(held, Event::Done)
    }

    fn output(held: NInside) -> NInside {
        held
    }

    fn max_events(_: &Input) -> usize {
        9
    }
}

impl Telling for Corners {
    type Scenery = ();

    const ID: &'static str = "box-corners";
    const NAME_KEY: &'static str = "watch-crossings";
    const SOURCE: &'static str = "kept under tests";
    const CODE: &'static [CodeLine] = &[CodeLine {
        depth: 0,
        code: "code-cs-codes",
        words: "words-cs-codes",
    }];
    const WATCH: &'static [Watched] = &[Watched::Names(&["n"])];
    const OPENING: Row = Row::new(Tick::Phase, 0, "sh-inside").so(&["c{=c}"]);

    table! { |event, step|
        corner: Event::Corner { .. } => Row::new(Tick::Test, 0, "sh-inside").so(&["d{=d}"]);
        done: Event::Done => Row::new(Tick::Accept, 0, "sh-inside").so(&["n = {n}"]);
    }

    fn named(at: &At<'_, Self>, name: &str) -> Option<Named> {
        Some(match name {
            "c" => at.step.input.c.into(),
            "d" => distances(at).last()?.into(),
            "n" => at.step.held.0.into(),
            _ => return None,
        })
    }

    fn views(at: &At<'_, Self>) -> Vec<View> {
        let half = at.step.input.half;
        let current = match at.step.event() {
            Some(Event::Corner { corner_idx, .. }) => Some(corner_idx),
            Some(Event::Done) | None => None,
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
        let distances: Vec<f64> = distances(at).collect();
        vec![
            View::new("space", Body::Space(space)),
            View::new("distances", Body::Table(table(&distances, current))),
        ]
    }
}

fn distances(at: &At<'_, Corners>) -> impl Iterator<Item = f64> {
    at.step.past.iter().filter_map(|event| match *event {
        Event::Corner { distance, .. } => Some(distance),
        Event::Done => None,
    })
}

fn table(distances: &[f64], current: Option<usize>) -> Table {
    let distance = |idx: usize| distances.get(idx).copied().map(Value::Number);
    let row = |idx: usize| TableRow {
        name: Value::Name(format!("V{idx}")),
        cells: vec![Cell::new(Role::Ink, distance(idx))],
        is_current: current == Some(idx),
        link: None,
    };
    Table {
        header: vec![Formula::default().sym("V"), Formula::default().sym("d")],
        rows: (0..8).map(row).collect(),
        notes: Vec::new(),
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
        edging: Edging::Lines,
        opacity: 1.0,
    };
    FACES.map(facet).to_vec()
}
