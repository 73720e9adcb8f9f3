//! Sutherland–Hodgman as a pipeline, shown.

use crate::{
    algo::polygon::{
        Pipeline, PipelineEvent as Event, PipelineState as State, RingOutcome, Rule,
        SutherlandHodgmanInput as Input,
    },
    figure::{Body, Caption, Mark, Role, Shape, Tick, View, Watch, WatchRow, WatchSection},
    geom::Point,
    labs::{
        CodeLine, Demo, Step, code_line,
        polygons::{PolygonDemo, Scene, UnfitScene},
        words::{name, vertex_symbol},
    },
    text::{Formula, Message, Value},
};

use super::{
    clip_edge::{ClipEdge, EdgeLook},
    clippers::{CLIPPERS, previous, row},
    in_and_out::{IN_AND_OUT, in_and_out},
    lists::{names, outline, output_symbol},
    result::result,
    rules::{is_crossed, rule_term, side_term, starts_inside},
    sutherland_hodgman::{SOURCE, done, input},
};

const SEND: usize = 0;
const ENTER: usize = 1;
const FIRST: usize = 2;
const CROSS: usize = 3;
const PASS_ON: usize = 4;
const OUTPUT: usize = 5;
const CLOSE: usize = 6;

/// Rows of the ring that the watch table shows.
const ROWS: usize = 8;

impl PolygonDemo for Pipeline {
    fn input(scene: &Scene) -> Result<Input, UnfitScene> {
        input(scene)
    }

    fn border(event: &Event<Point>) -> Option<usize> {
        match *event {
            Event::First { stage_idx, .. } | Event::Test { stage_idx, .. } => Some(stage_idx),
            Event::Enter { .. }
            | Event::Cross { .. }
            | Event::Output { .. }
            | Event::Close { .. }
            | Event::Done { .. } => None,
        }
    }

    fn tells(event: &Event<Point>, vertex: Point) -> Option<bool> {
        match *event {
            Event::First { at, inside, .. } => (at == vertex).then_some(inside),
            Event::Test { ends, rule, .. } => (ends[1] == vertex).then_some(rule.ends_inside()),
            Event::Enter { .. }
            | Event::Cross { .. }
            | Event::Output { .. }
            | Event::Close { .. }
            | Event::Done { .. } => None,
        }
    }

    fn crossing(event: &Event<Point>) -> Option<Point> {
        match *event {
            Event::Cross { at, .. } => Some(at),
            Event::Enter { .. }
            | Event::First { .. }
            | Event::Test { .. }
            | Event::Output { .. }
            | Event::Close { .. }
            | Event::Done { .. } => None,
        }
    }

    fn piece(event: &Event<Point>, after: &State<Point>) -> Option<Vec<Point>> {
        match event {
            Event::Done { .. } => Some(after.output.clone()),
            Event::Enter { .. }
            | Event::First { .. }
            | Event::Test { .. }
            | Event::Cross { .. }
            | Event::Output { .. }
            | Event::Close { .. } => None,
        }
    }
}

impl Demo for Pipeline {
    const ID: &'static str = "sutherland-hodgman-pipeline";
    const NAME_KEY: &'static str = "alg-sutherland-hodgman-pipeline";
    const SOURCE: &'static str = SOURCE;
    const CODE: &'static [CodeLine] = &[
        code_line(0, "code-pipe-send", "words-pipe-send"),
        code_line(0, "code-pipe-enter", "words-pipe-enter"),
        code_line(1, "code-pipe-first", "words-pipe-first"),
        code_line(1, "code-pipe-cross", "words-pipe-cross"),
        code_line(1, "code-pipe-pass-on", "words-pipe-pass-on"),
        code_line(0, "code-pipe-output", "words-pipe-output"),
        code_line(0, "code-pipe-close", "words-pipe-close"),
    ];

    fn tick(event: &Event<Point>) -> Tick {
        match event {
            Event::Enter {
                vertex_idx: Some(_),
                ..
            }
            | Event::Close { .. } => Tick::Phase,
            Event::Cross { .. } => Tick::Cut,
            Event::Done {
                outcome: RingOutcome::Empty | RingOutcome::Degenerate,
            } => Tick::Reject,
            Event::Done {
                outcome: RingOutcome::Whole | RingOutcome::Cut,
            } => Tick::Accept,
            Event::Enter {
                vertex_idx: None, ..
            }
            | Event::First { .. }
            | Event::Test { .. }
            | Event::Output { .. } => Tick::Test,
        }
    }

    fn code_line(event: &Event<Point>, before: &State<Point>) -> usize {
        let is_closing = before.stage_idx.is_some_and(|i| before.stages[i].is_closed);
        match event {
            Event::Enter {
                vertex_idx: Some(_),
                ..
            } => SEND,
            Event::Enter { .. } => ENTER,
            Event::First { .. } => FIRST,
            Event::Close { .. } | Event::Done { .. } => CLOSE,
            Event::Test { .. } | Event::Cross { .. } if is_closing => CLOSE,
            Event::Test { rule, .. } if rule.changes_side() => CROSS,
            Event::Test { .. } => PASS_ON,
            Event::Cross { .. } => CROSS,
            Event::Output { .. } => OUTPUT,
        }
    }

    fn opening(input: &Input) -> Caption {
        let message = Message::new("pipe-opening")
            .with("n", input.vertices.len())
            .with("edges", input.region.n_edges());
        Caption::new(message)
    }

    fn caption(event: &Event<Point>, before: &State<Point>, input: &Input) -> Caption {
        let edge = |stage_idx| ClipEdge::new(&input.region, stage_idx, EdgeLook::RIGHT);
        match *event {
            Event::Enter {
                stage_idx,
                vertex_idx,
                at,
            } => enter_caption(&edge(stage_idx), vertex_idx, at),
            Event::First {
                stage_idx,
                at,
                distance,
                inside,
            } => {
                let key = if inside {
                    "pipe-first-inside"
                } else {
                    "pipe-first-outside"
                };
                let edge = edge(stage_idx);
                let position = edge.position(&("F".to_owned(), at), distance, inside);
                Caption::new(Message::new(key).with("border", edge.border())).so(position)
            }
            Event::Test {
                stage_idx,
                ends,
                distances,
                rule,
            } => {
                let is_closing = before.stages[stage_idx].is_closed;
                test_caption(&edge(stage_idx), ends, distances, rule, is_closing)
            }
            Event::Cross { stage_idx, at, .. } => cross_caption(&edge(stage_idx), before, at),
            Event::Output { at } => Caption::new(
                Message::new("pipe-output")
                    .with("vertex", name(output_symbol(before.output.len())))
                    .with("at", at.to_array()),
            ),
            Event::Close { stage_idx } => {
                let edge = edge(stage_idx);
                let is_empty = before.stages[stage_idx].first.is_none();
                let key = if is_empty {
                    "pipe-close-empty"
                } else {
                    "pipe-close"
                };
                Caption::new(Message::new(key).with("border", edge.border()))
            }
            Event::Done { outcome } => done(outcome, before.output.len(), input.region.n_edges()),
        }
    }

    fn views(step: &Step<'_, Self>) -> Vec<View> {
        vec![
            View::plane(marks(step)),
            View::new(IN_AND_OUT, Body::Lists(in_and_out(step))),
            View::new(CLIPPERS, Body::Clippers(row(step))),
        ]
    }

    fn watch(step: &Step<'_, Self>) -> Watch {
        let state = step.state;
        let point = |p: Option<Point>| p.map(|p| Value::Point(p.to_array()));
        let stages = state.stages.iter().enumerate().map(|(i, stage)| {
            let edge = ClipEdge::new(&step.input.region, i, EdgeLook::RIGHT);
            let held = vec![point(stage.first), point(previous(state, i))];
            let row = WatchRow::table(edge.name(), held);
            let row = row.linked(edge.link());
            match (state.stage_idx == Some(i), stage.is_closed) {
                (true, _) => row.noted(name("←")),
                (false, true) => row.noted(Value::Term("pipe-closed")),
                (false, false) => row,
            }
        });
        let stages = WatchSection::table(vec!["F", "S"], stages.collect());
        let mut watch = vec![stages.seen_in(CLIPPERS)];
        if let Some((_, distances, rule)) = state.test {
            watch.push(WatchSection::list(vec![
                distance_row("d_S", distances[0], starts_inside(rule)),
                distance_row("d_P", distances[1], rule.ends_inside()),
            ]));
        }
        let start = state.output.len().saturating_sub(ROWS);
        let ring = state.output.iter().enumerate().skip(start);
        let ring = ring.map(|(i, &p)| WatchRow::new(name(output_symbol(i)), point(Some(p))));
        let ring = WatchSection::list(ring.collect()).part(start, state.output.len());
        watch.push(ring.seen_in(IN_AND_OUT));
        watch
    }
}

/// The drawing.
fn marks(step: &Step<'_, Pipeline>) -> Vec<Mark> {
    let (input, state) = (step.input, step.state);
    if let Some(outcome) = state.outcome {
        let ring = names(&state.output, output_symbol, Role::Accepted, &[], &[]);
        let left = result(
            &state.output,
            (outcome, Role::Accepted),
            &input.region,
            &input.vertices,
        );
        return left.into_iter().chain(ring).collect();
    }
    let mut marks = Vec::new();
    if let Some(stage_idx) = state.stage_idx {
        let edge = ClipEdge::new(&input.region, stage_idx, EdgeLook::RIGHT);
        marks.push(edge.mark(match step.event {
            Some(Event::First { .. } | Event::Test { .. } | Event::Cross { .. }) => Role::Signal,
            Some(
                Event::Enter { .. }
                | Event::Output { .. }
                | Event::Close { .. }
                | Event::Done { .. },
            )
            | None => Role::Soft,
        }));
    }
    marks.push(Mark::new(Role::Accent, Shape::Path(outline(&state.output))).linked("output"));
    marks.extend(names(&input.vertices, vertex_symbol, Role::Soft, &[], &[]));
    marks.extend(memory(state));
    marks.extend(moment(state));
    marks
}

fn distance_row(symbol: &'static str, distance: f64, is_inside: bool) -> WatchRow {
    WatchRow::new(name(symbol), Some(Value::Number(distance)))
        .noted(Value::Term(side_term(is_inside)))
}

fn enter_caption(edge: &ClipEdge<'_>, vertex_idx: Option<usize>, at: Point) -> Caption {
    let (key, symbol) = match vertex_idx {
        Some(i) => ("pipe-send", vertex_symbol(i)),
        None => ("pipe-enter", "P".to_owned()),
    };
    let message = Message::new(key)
        .with("vertex", name(symbol))
        .with("at", at.to_array());
    Caption::new(message.with("border", edge.border()))
}

fn cross_caption(edge: &ClipEdge<'_>, before: &State<Point>, at: Point) -> Caption {
    let caption = Caption::new(Message::new("pipe-cross").with("border", edge.border()));
    let Some((ends, distances, _)) = before.test else {
        return caption;
    };
    let formulas = edge.crossing(ends, distances, at);
    formulas.into_iter().fold(caption, Caption::so)
}

fn test_caption(
    edge: &ClipEdge<'_>,
    ends: [Point; 2],
    distances: [f64; 2],
    rule: Rule,
    is_closing: bool,
) -> Caption {
    let key = match (is_closing, is_crossed(rule, distances), rule.ends_inside()) {
        (true, true, _) => "pipe-closing-cross",
        (true, false, _) => "pipe-closing",
        (false, true, false) => "pipe-crossing",
        (false, true, true) => "pipe-both",
        (false, false, true) => "pipe-vertex",
        (false, false, false) => "pipe-nothing",
    };
    let message = Message::new(key).with("rule", Value::Term(rule_term(rule)));
    let symbols = ["S", if is_closing { "F" } else { "P" }];
    let is_inside = [starts_inside(rule), rule.ends_inside()];
    let positions = (0..2).map(|i| {
        let named = (symbols[i].to_owned(), ends[i]);
        edge.position(&named, distances[i], is_inside[i])
    });
    positions.fold(Caption::new(message), Caption::so)
}

/// What the clipper at work holds.
fn memory(state: &State<Point>) -> Vec<Mark> {
    let Some(stage) = state.stage_idx.map(|i| state.stages[i]) else {
        return Vec::new();
    };
    let mark = |p: Point, symbol: &'static str| {
        Mark::new(Role::Ink, Shape::Ring(p.to_array())).labelled(name(symbol))
    };
    let first = stage.first.map(|p| mark(p, "F"));
    let previous = match state.test {
        Some(_) => None,
        None => stage.previous.map(|p| mark(p, "S")),
    };
    first.into_iter().chain(previous).collect()
}

fn moment(state: &State<Point>) -> Vec<Mark> {
    let mut marks = Vec::new();
    let signal =
        |shape: Shape, label: Value| Mark::new(Role::Signal, shape).labelled(label).strong();
    let vertex = |p: Point, is_inside: bool, symbol: &'static str| {
        let at = p.to_array();
        let shape = if is_inside {
            Shape::Dot(at)
        } else {
            Shape::Ring(at)
        };
        signal(shape, name(symbol))
    };
    match (state.test, state.moving) {
        (Some((ends, _, rule)), moving) => {
            let arrow = Shape::Arrow(ends.map(Point::to_array));
            marks.push(Mark::new(Role::Signal, arrow));
            marks.push(vertex(ends[0], starts_inside(rule), "S"));
            // Nothing comes in while the ring is closed: then the edge ends at F.
            let end = if moving.is_some() { "P" } else { "F" };
            marks.push(vertex(ends[1], rule.ends_inside(), end));
        }
        (None, Some(at)) if state.stage_idx.is_some() => marks.push(vertex(at, true, "P")),
        (None, Some(at)) => {
            let symbol = output_symbol(state.output.len().saturating_sub(1));
            marks.push(signal(Shape::Dot(at.to_array()), name(symbol)));
        }
        (None, None) => {}
    }
    if let Some((at, t)) = state.crossing {
        let label = Formula::default().sym("I: t = ").ratio(t.num, t.den);
        marks.push(signal(Shape::Dot(at.to_array()), label.into()));
    }
    marks
}
