//! Ear clipping, shown.

mod captions;
mod marks;
mod ring;
#[cfg(test)]
mod tests;

use crate::{
    algo::polygon::{
        EarClipping, EarClippingEvent as Event, EarClippingState as State, Triangulation,
    },
    figure::{Body, Caption, Link, Tick, View, Watch, WatchRow, WatchSection},
    geom::{Point, SimplePolygon},
    labs::{
        Answer, CodeLine, Demo, Step, code_line,
        polygons::{PolygonDemo, Scene, ScenePart, UnfitScene},
        words::{name, vertex_name},
    },
    text::Value,
};

use super::triangles::{triangles_json, triangles_section};

use self::captions::{corner_name, vertices_name};

pub use self::marks::marks;

const CLASSIFY: usize = 0;
const ROUND: usize = 1;
const CONVEX: usize = 3;
const EMPTY: usize = 4;
const CUT: usize = 5;
const RECLASSIFY: usize = 6;
const LAST: usize = 7;

/// Rows of the table of vertices.
const MAX_ROWS: usize = 12;

impl PolygonDemo for EarClipping {
    const CLIPS: bool = false;

    fn input(scene: &Scene) -> Result<SimplePolygon, UnfitScene> {
        SimplePolygon::try_from(&scene.subject)
            .map_err(|error| UnfitScene::new(ScenePart::Subject, error))
    }

    fn piece(event: &Event, after: &State) -> Option<Vec<Point>> {
        match *event {
            Event::Cut { triangle, .. } | Event::Last { triangle } => {
                Some(after.cut_off.corners(triangle).to_vec())
            }
            Event::Classify { .. }
            | Event::Round { .. }
            | Event::Pass { .. }
            | Event::Candidate { .. }
            | Event::Blocked { .. }
            | Event::Ear { .. }
            | Event::Done { .. } => None,
        }
    }
}

impl Answer for Triangulation {
    fn json(&self) -> serde_json::Value {
        triangles_json(self)
    }
}

impl Demo for EarClipping {
    const ID: &'static str = "ear-clipping";
    const NAME_KEY: &'static str = "alg-ear-clipping";
    const SOURCE: &'static str = "G. H. Meisters, 1975; ElGindy, Everett & Toussaint, 1993";
    const CODE: &'static [CodeLine] = &[
        code_line(0, "code-ear-classify", "words-ear-classify"),
        code_line(0, "code-ear-round", "words-ear-round"),
        code_line(1, "code-ear-each", "words-ear-each"),
        code_line(2, "code-ear-convex", "words-ear-convex"),
        code_line(3, "code-ear-empty", "words-ear-empty"),
        code_line(4, "code-ear-cut", "words-ear-cut"),
        code_line(4, "code-ear-again", "words-ear-again"),
        code_line(0, "code-ear-last", "words-ear-last"),
    ];

    fn tick(event: &Event) -> Tick {
        match event {
            Event::Classify { .. }
            | Event::Pass { .. }
            | Event::Candidate { .. }
            | Event::Blocked { .. }
            | Event::Ear { .. } => Tick::Test,
            Event::Round { .. } => Tick::Phase,
            Event::Cut { .. } | Event::Last { .. } => Tick::Cut,
            Event::Done { .. } => Tick::Accept,
        }
    }

    fn code_line(event: &Event, before: &State) -> usize {
        match event {
            Event::Classify { vertex_idx, .. } if before.corners[*vertex_idx].is_some() => {
                RECLASSIFY
            }
            Event::Classify { .. } => CLASSIFY,
            Event::Round { .. } => ROUND,
            Event::Pass { .. } | Event::Candidate { .. } => CONVEX,
            Event::Blocked { .. } | Event::Ear { .. } => EMPTY,
            Event::Cut { .. } => CUT,
            Event::Last { .. } | Event::Done { .. } => LAST,
        }
    }

    fn opening(input: &SimplePolygon) -> Caption {
        captions::opening(input.vertices().len())
    }

    fn caption(event: &Event, before: &State, _: &SimplePolygon) -> Caption {
        captions::caption(event, before)
    }

    fn views(step: &Step<'_, Self>) -> Vec<View> {
        vec![
            View::plane(marks(step)),
            View::new(ring::VIEW, Body::Lists(ring::lists(step))),
        ]
    }

    fn watch(step: &Step<'_, Self>) -> Watch {
        let [left, scalars, vertices] = left_over(step.state);
        let triangles = triangles_section(&step.state.cut_off).into_iter();
        let mut watch = vec![
            left.seen_in(ring::VIEW),
            scalars,
            vertices.seen_in(ring::VIEW),
        ];
        watch.extend(triangles.map(|section| section.seen_in(ring::VIEW)));
        watch
    }
}

/// What is watched where no view shows the ring.
pub fn watch(state: &State) -> Watch {
    let mut watch = left_over(state).to_vec();
    watch.extend(triangles_section(&state.cut_off));
    watch
}

/// What is left: its name, how much it is, those of its vertices that are about the one that is asked.
fn left_over(state: &State) -> [WatchSection; 3] {
    let count = |key, n| WatchRow::new(Value::Term(key), Some(Value::Count(n)));
    let vertices = around_stand(state).into_iter().map(|i| {
        let at = Value::Point(state.cut_off.at(i).to_array());
        let row = WatchRow::new(vertex_name(i), Some(at)).linked(vertex_link(i));
        match state.corners[i] {
            Some(corner) => row.noted(corner_name(corner)),
            None => row,
        }
    });
    let counts = vec![
        count("ear-n-left", state.ring.len()),
        count("ear-n-triangles", state.cut_off.triangles().len()),
    ];
    let left = WatchRow::new(Value::Term("ear-left"), Some(ring_name(state)));
    [
        WatchSection::list(vec![left]),
        WatchSection::list(counts),
        WatchSection::list(vertices.collect()).part(0, state.ring.len()),
    ]
}

const fn vertex_link(vertex_idx: usize) -> Link {
    Link::nth("vertex", vertex_idx)
}

/// Up to [`MAX_ROWS`] vertices of what is left, those about the one that is asked.
fn around_stand(state: &State) -> Vec<usize> {
    let n = state.ring.len();
    if n <= MAX_ROWS {
        return state.ring.iter().collect();
    }
    let stand = state.stand.filter(|&i| state.ring.contains(i));
    let mut from = stand.unwrap_or(state.ring.first());
    if stand.is_some() {
        for _ in 0..MAX_ROWS / 2 {
            from = state.ring.prev(from);
        }
    }
    let after = |&i: &usize| Some(state.ring.next(i));
    std::iter::successors(Some(from), after)
        .take(MAX_ROWS)
        .collect()
}

/// `V₁V₂V₄V₅`, with dots where there are too many: it says the same until one of those that it names is cut off.
fn ring_name(state: &State) -> Value {
    let shown = vertices_name(state.ring.iter().take(MAX_ROWS));
    if state.ring.len() > MAX_ROWS {
        name(format!("{shown}…"))
    } else {
        name(shown)
    }
}
