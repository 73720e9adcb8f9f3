//! Weiler–Atherton, shown.

mod captions;
mod lists;
mod marks;
mod names;
mod standing;
#[cfg(test)]
mod tests;

use serde_json::{Value as Json, json};

use crate::{
    algo::polygon::weiler_atherton::{
        IntersectionLabel, List, Relation, RingKind, WeilerAtherton, WeilerAthertonEvent as Event,
        WeilerAthertonInput as Input, WeilerAthertonOutput, WeilerAthertonState as State,
    },
    figure::{Body, Caption, Tick, View, Watch, WatchRow, WatchSection},
    geom::{GeomError, Point, Polygon, Region, SimplePolygon},
    labs::{
        Answer, CodeLine, Demo, Step, code_line,
        polygons::{PolygonDemo, Scene, ScenePart, UnfitScene},
        words::name,
    },
    text::{Formula, Value},
};

const FIND: usize = 0;
const INSERT: usize = 1;
const LABEL: usize = 2;
const START: usize = 3;
const FOLLOW: usize = 4;
const ENTER: usize = 5;
const LEAVE: usize = 6;
const CLOSE: usize = 7;
const WHOLE: usize = 8;
const HOLES: usize = 9;

/// Rows of the table of both lists.
const MAX_ROWS: usize = 12;

impl PolygonDemo for WeilerAtherton {
    const KNOWS_HOLES: bool = true;
    const SUBJECT: char = 'S';

    fn input(scene: &Scene) -> Result<Input, UnfitScene> {
        let simple = |polygon: &Polygon, part| {
            SimplePolygon::try_from(polygon).map_err(|error| UnfitScene::new(part, error))
        };
        let subject = simple(&scene.subject, ScenePart::Subject)?;
        let clip = simple(&scene.clip_outline(), ScenePart::Clip)?;
        let holes = scene.holes.iter().enumerate();
        let holes: Vec<_> = holes
            .map(|(i, hole)| simple(hole, ScenePart::Hole(i)))
            .collect::<Result<_, _>>()?;
        let subject = Region::new(subject, holes).map_err(|error| {
            let part = if let GeomError::MisplacedHole { hole_idx } = error {
                ScenePart::Hole(hole_idx)
            } else {
                ScenePart::Subject
            };
            UnfitScene::new(part, error)
        })?;
        Ok(Input { subject, clip })
    }

    fn tells(event: &Event, vertex: Point) -> Option<bool> {
        match *event {
            Event::Visit { at, .. } => (at == vertex).then_some(true),
            // The first ring is the one around all others.
            Event::Whole {
                list: List::Subject,
                ring_idx: 0,
                kind,
                ..
            } => Some(kind.is_some()),
            Event::Whole { .. }
            | Event::Vertex { .. }
            | Event::Found { .. }
            | Event::Inserted { .. }
            | Event::Labelled { .. }
            | Event::Start { .. }
            | Event::Switch { .. }
            | Event::Closed { .. }
            | Event::Hole { .. }
            | Event::Done { .. } => None,
        }
    }

    fn crossing(event: &Event) -> Option<Point> {
        match *event {
            Event::Found { at, .. } => Some(at),
            Event::Vertex { .. }
            | Event::Inserted { .. }
            | Event::Labelled { .. }
            | Event::Start { .. }
            | Event::Visit { .. }
            | Event::Switch { .. }
            | Event::Closed { .. }
            | Event::Whole { .. }
            | Event::Hole { .. }
            | Event::Done { .. } => None,
        }
    }

    fn piece(event: &Event, after: &State) -> Option<Vec<Point>> {
        match *event {
            Event::Closed {
                kind: RingKind::Outer,
                ..
            }
            | Event::Whole {
                kind: Some(RingKind::Outer),
                ..
            } => after.rings.last().map(|ring| ring.points.clone()),
            Event::Closed { .. }
            | Event::Whole { .. }
            | Event::Vertex { .. }
            | Event::Found { .. }
            | Event::Inserted { .. }
            | Event::Labelled { .. }
            | Event::Start { .. }
            | Event::Visit { .. }
            | Event::Switch { .. }
            | Event::Hole { .. }
            | Event::Done { .. } => None,
        }
    }
}

impl Answer for WeilerAthertonOutput {
    fn json(&self) -> Json {
        let pieces = self.pieces.iter();
        let rings: Vec<&Vec<Point>> = pieces
            .flat_map(|piece| std::iter::once(&piece.outer).chain(&piece.holes))
            .collect();
        json!({ "polygons": rings, "relation": self.relation })
    }
}

impl Demo for WeilerAtherton {
    const ID: &'static str = "weiler-atherton";
    const NAME_KEY: &'static str = "alg-weiler-atherton";
    const SOURCE: &'static str =
        "K. Weiler, P. Atherton, 1977; G. Greiner, K. Hormann, 1998; E. L. Foster et al., 2019";
    const CODE: &'static [CodeLine] = &[
        code_line(0, "code-wa-find", "words-wa-find"),
        code_line(0, "code-wa-insert", "words-wa-insert"),
        code_line(0, "code-wa-label", "words-wa-label"),
        code_line(0, "code-wa-start", "words-wa-start"),
        code_line(1, "code-wa-follow", "words-wa-follow"),
        code_line(1, "code-wa-enter", "words-wa-enter"),
        code_line(1, "code-wa-leave", "words-wa-leave"),
        code_line(1, "code-wa-close", "words-wa-close"),
        code_line(0, "code-wa-whole", "words-wa-whole"),
        code_line(0, "code-wa-holes", "words-wa-holes"),
    ];

    fn tick(event: &Event) -> Tick {
        match event {
            // Each stage begins with a phase, and so does each walk.
            Event::Vertex { vertex_idx: 0, .. }
            | Event::Labelled { node_idx: 0, .. }
            | Event::Start { .. } => Tick::Phase,
            Event::Vertex { .. }
            | Event::Labelled { .. }
            | Event::Visit { .. }
            | Event::Hole { .. } => Tick::Test,
            Event::Found { .. } | Event::Inserted { .. } | Event::Switch { .. } => Tick::Cut,
            Event::Closed { .. } | Event::Whole { kind: Some(_), .. } => Tick::Accept,
            Event::Whole { kind: None, .. } => Tick::Reject,
            Event::Done { relation } => match relation {
                Relation::Disjoint | Relation::Touching => Tick::Reject,
                Relation::SubjectInside
                | Relation::ClipInside
                | Relation::Equal
                | Relation::Crossing => Tick::Accept,
            },
        }
    }

    fn code_line(event: &Event, before: &State) -> usize {
        match event {
            Event::Vertex {
                list: List::Subject,
                ..
            }
            | Event::Found { .. } => FIND,
            Event::Vertex {
                list: List::Clip, ..
            }
            | Event::Inserted { .. } => INSERT,
            Event::Labelled { .. } => LABEL,
            Event::Start { .. } => START,
            Event::Visit { .. } => FOLLOW,
            Event::Switch { node_idx, to, .. } => {
                let label = before
                    .labels
                    .get(*node_idx as usize)
                    .map(|label| label.label);
                match (label, to) {
                    (Some(IntersectionLabel::Leaving), _) | (_, List::Clip) => LEAVE,
                    (_, List::Subject) => ENTER,
                }
            }
            Event::Closed { .. } => CLOSE,
            Event::Whole { .. } => WHOLE,
            Event::Hole { .. } | Event::Done { .. } => HOLES,
        }
    }

    fn opening(input: &Input) -> Caption {
        captions::opening(input)
    }

    fn caption(event: &Event, before: &State, input: &Input) -> Caption {
        captions::caption(event, before, input)
    }

    fn views(step: &Step<'_, Self>) -> Vec<View> {
        vec![
            View::plane(marks::marks(step)),
            View::new(lists::VIEW, Body::Lists(lists::lists(step))),
        ]
    }

    fn watch(step: &Step<'_, Self>) -> Watch {
        let state = step.state;
        let start = state.start.map(|node| name(names::node(node)));
        let count = |n: usize| Some(Value::Count(n));
        let rows = vec![
            WatchRow::new(Value::Term("wa-row-start"), start),
            WatchRow::new(Value::Term("wa-row-path"), count(state.path.len())),
            WatchRow::new(Value::Term("wa-row-rings"), count(state.rings.len())),
        ];
        vec![lists_section(step), WatchSection::list(rows)]
    }
}

/// Both lists side by side: of long ones the page that is being worked on.
fn lists_section(step: &Step<'_, WeilerAtherton>) -> WatchSection {
    let pages = [List::Subject, List::Clip].map(|list| page(step, list));
    let n_rows = pages.iter().map(Vec::len).max().unwrap_or(0);
    let rows = (0..n_rows).map(|row| {
        let cells = pages
            .iter()
            .map(|page| page.get(row).map(|(cell, _)| cell.clone()));
        let linked = pages.iter().find_map(|page| page.get(row)?.1);
        let shown = WatchRow::table(name(format!("{}", row + 1)), cells.collect());
        match linked {
            Some(node) => shown.linked(names::node_link(node)),
            None => shown,
        }
    });
    WatchSection::table(vec!["S", "C"], rows.collect()).seen_in(lists::VIEW)
}

/// The entries of the page on which a list is being built, labelled or walked: what each says, and the
/// intersection that it is.
fn page(step: &Step<'_, WeilerAtherton>, list: List) -> Vec<(Value, Option<u32>)> {
    let (state, input) = (step.state, step.input);
    let entries = &state.lists[list.idx()];
    let current = current_place(step, list);
    let first = current.unwrap_or(0) / MAX_ROWS * MAX_ROWS;
    let places = first..entries.len().min(first + MAX_ROWS);
    let cell = |place: usize| {
        let entry = entries.get(place)?;
        let arrow = if current == Some(place) { "→ " } else { "" };
        let text = Formula::default()
            .sym(arrow)
            .sym(names::entry(input, list, entry));
        let text = names::with_label(text, state, entry.node);
        Some((Value::Formula(text), entry.node))
    };
    places.filter_map(cell).collect()
}

/// Where in a list something happens at this step.
fn current_place(step: &Step<'_, WeilerAtherton>, list: List) -> Option<usize> {
    let state = step.state;
    let last = state.lists[list.idx()].len().checked_sub(1);
    let of_node = |node: u32| match list {
        List::Subject => state
            .nodes
            .get(node as usize)
            .map(|node| node.place as usize),
        List::Clip => {
            let mut inserted = state.inserted.iter();
            let found = inserted.find(|[inserted, _]| *inserted == node);
            found.map(|[_, place]| *place as usize)
        }
    };
    match (step.event?, list) {
        (Event::Vertex { list: built, .. }, _) => last.filter(|_| built == list),
        (Event::Found { .. }, List::Subject) | (Event::Inserted { .. }, List::Clip) => last,
        (Event::Found { .. }, List::Clip) => None,
        (
            Event::Inserted { node_idx, .. }
            | Event::Labelled { node_idx, .. }
            | Event::Start { node_idx }
            | Event::Switch { node_idx, .. },
            _,
        ) => of_node(node_idx),
        (
            Event::Visit { .. }
            | Event::Closed { .. }
            | Event::Whole { .. }
            | Event::Hole { .. }
            | Event::Done { .. },
            _,
        ) => {
            let (walked, place) = state.position?;
            (walked == list).then_some(place as usize)
        }
    }
}
