//! Cyrus–Beck, shown.

use glam::DVec2;

use crate::labs::words::{name, subscript};
use crate::{
    algo::line::{
        CyrusBeck, CyrusBeckEvent as Event, CyrusBeckInput as Input, CyrusBeckRow as Row,
        CyrusBeckState as State, End,
    },
    figure::{
        Body, Caption, Link, Mark, Role, Shape, Side, Tick, View, Watch, WatchRow, WatchSection,
    },
    geom::{Point, Segment, extent},
    labs::{
        CodeLine, Demo, Step, code_line,
        lines::{LineDemo, Scene},
    },
    text::{Formula, Message, Value},
};

use super::{
    parametric::{Crossing, Interval, bound_formula, interval_caption, moved_ends_rows},
    shared::{accepted, end_name, opening},
};

const EACH: usize = 1;
const PARALLEL: usize = 2;
const ENTER: usize = 3;
const LEAVE: usize = 4;
const EMPTY: usize = 5;
const ACCEPT: usize = 6;

impl LineDemo for CyrusBeck {
    const TAKES_POLYGON: bool = true;

    fn input(scene: &Scene, segment: Segment) -> Input {
        Input {
            clip: scene.clip_polygon(),
            segment,
        }
    }
}

impl Demo for CyrusBeck {
    const ID: &'static str = "cyrus-beck";
    const NAME_KEY: &'static str = "alg-cyrus-beck";
    const SOURCE: &'static str = "Cyrus & Beck, 1978";
    const CODE: &'static [CodeLine] = &[
        code_line(0, "code-cb-start", "words-cb-start"),
        code_line(0, "code-cb-each", "words-cb-each"),
        code_line(1, "code-cb-parallel", "words-cb-parallel"),
        code_line(1, "code-cb-enter", "words-cb-enter"),
        code_line(1, "code-cb-leave", "words-cb-leave"),
        code_line(1, "code-cb-empty", "words-cb-empty"),
        code_line(0, "code-cb-accept", "words-cb-accept"),
    ];

    fn tick(event: &Event) -> Tick {
        match event {
            Event::Edge { .. } => Tick::Phase,
            Event::Parallel { .. } | Event::Interval { .. } => Tick::Test,
            Event::Enter { .. } | Event::Leave { .. } | Event::Put { .. } => Tick::Cut,
            Event::Accept { .. } => Tick::Accept,
            Event::Reject { .. } => Tick::Reject,
        }
    }

    fn code_line(event: &Event, _: &State) -> usize {
        match event {
            Event::Edge { .. } => EACH,
            Event::Parallel { .. } => PARALLEL,
            Event::Enter { .. } => ENTER,
            Event::Leave { .. } => LEAVE,
            Event::Interval { .. } | Event::Reject { .. } => EMPTY,
            Event::Put { .. } | Event::Accept { .. } => ACCEPT,
        }
    }

    fn opening(input: &Input) -> Caption {
        opening(&input.segment)
    }

    fn caption(event: &Event, before: &State, input: &Input) -> Caption {
        match *event {
            Event::Edge {
                edge_idx,
                normal,
                origin,
                d1,
                d2,
                slope,
            } => row_caption(edge_idx, normal, origin, [d1, d2, slope], input),
            Event::Parallel {
                edge_idx,
                d1,
                inside,
            } => parallel_caption(edge_idx, d1, inside),
            Event::Enter {
                edge_idx,
                t,
                raises,
                t_min,
            } => {
                let key = if raises { "cb-enter" } else { "cb-enter-idle" };
                bound_caption(key, edge_idx, before, t).so(bound_formula(
                    "t_min = max(",
                    [before.interval[0], t],
                    t_min,
                ))
            }
            Event::Leave {
                edge_idx,
                t,
                lowers,
                t_max,
            } => {
                let key = if lowers { "cb-leave" } else { "cb-leave-idle" };
                bound_caption(key, edge_idx, before, t).so(bound_formula(
                    "t_max = min(",
                    [before.interval[1], t],
                    t_max,
                ))
            }
            Event::Interval {
                t_min,
                t_max,
                empty,
            } => interval_caption(["t_min", "t_max"], [t_min, t_max], empty),
            Event::Put {
                end,
                t,
                edge_idx,
                at,
            } => put_caption(end, t, edge_idx, at, before, input),
            Event::Accept { segment } => accepted(&segment),
            Event::Reject { edge_idx } => edge_caption("cb-reject", edge_idx),
        }
    }

    fn views(step: &Step<'_, Self>) -> Vec<View> {
        vec![
            View::plane(marks(step)),
            View::new("axis", Body::NumberLine(interval(step).number_line())),
        ]
    }

    fn watch(step: &Step<'_, Self>) -> Watch {
        let state = step.state;
        let table = (0..step.input.clip.vertices().len())
            .map(|i| {
                let row = state.rows.get(i);
                let cell = |value: fn(&Row) -> f64| row.map(|row| Value::Number(value(row)));
                let cells = vec![
                    cell(|row| row.d1),
                    cell(|row| row.slope),
                    row.and_then(|row| row.t).map(Value::Number),
                ];
                WatchRow::table(edge_name(i), cells).linked(edge_link(i))
            })
            .collect();
        let mut rows: Vec<WatchRow> = interval(step).bound_rows().collect();
        rows.extend(moved_ends_rows(state.ends));
        vec![
            WatchSection::table(vec!["d₁", "n·D", "t"], table),
            WatchSection::list(rows),
        ]
    }
}

/// The drawing.
fn marks(step: &Step<'_, CyrusBeck>) -> Vec<Mark> {
    let segment = &step.input.segment;
    let current = current_edge(step.event);
    let mut marks = normals(step, current);
    marks.extend(interval(step).marks(segment));
    marks
}

fn interval(step: &Step<'_, CyrusBeck>) -> Interval {
    let state = step.state;
    let current = current_edge(step.event);
    let crossings = state.rows.iter().enumerate().filter_map(|(i, row)| {
        Some(Crossing {
            at: row.t?,
            side: if row.slope > 0.0 {
                Side::Entering
            } else {
                Side::Leaving
            },
            holds: state.set_by.contains(&Some(i)),
            current: current == Some(i),
            name: edge_name(i),
            link: edge_link(i),
        })
    });
    Interval {
        symbol: "t",
        crossing_symbol: "t",
        bounds: state.interval,
        crossings: crossings.collect(),
        verdict: state.verdict,
    }
}

/// The edge that the step is about.
const fn current_edge(event: Option<Event>) -> Option<usize> {
    match event {
        Some(
            Event::Edge { edge_idx, .. }
            | Event::Parallel { edge_idx, .. }
            | Event::Enter { edge_idx, .. }
            | Event::Leave { edge_idx, .. }
            | Event::Reject { edge_idx },
        ) => Some(edge_idx),
        _ => None,
    }
}

/// `e₁`, `e₂`, …: edges are numbered from 1 on screen.
fn edge_name(edge_idx: usize) -> Value {
    name(format!("e{}", subscript(edge_idx + 1)))
}

fn edge_link(edge_idx: usize) -> Link {
    Link::nth("edge", edge_idx)
}

fn edge_caption(key: &'static str, edge_idx: usize) -> Caption {
    Caption::new(Message::new(key).with("edge", edge_name(edge_idx)))
}

/// Which way the line crosses an edge, and the dot products that say so.
fn row_caption(
    edge_idx: usize,
    normal: [f64; 2],
    origin: Point,
    [d1, d2, slope]: [f64; 3],
    input: &Input,
) -> Caption {
    let key = if slope > 0.0 {
        "cb-edge-entering"
    } else if slope < 0.0 {
        "cb-edge-leaving"
    } else {
        "cb-edge-parallel"
    };
    edge_caption(key, edge_idx)
        .so(distance_formula(normal, input.segment.p1, origin, d1))
        .so(Formula::default()
            .sym("n·D = d₂ − d₁ = ")
            .num(d2)
            .sym(" − ")
            .operand(d1)
            .equals(slope))
}

fn parallel_caption(edge_idx: usize, d1: f64, inside: bool) -> Caption {
    let (key, relation) = if inside {
        ("cb-parallel-inside", " ≥ 0")
    } else {
        ("cb-parallel-outside", " < 0")
    };
    edge_caption(key, edge_idx).so(Formula::default()
        .sym("n·D = 0,  d₁ = ")
        .num(d1)
        .sym(relation))
}

/// `d₁ = n·(P₁ − E) = 2 · (−3 − 0) + (−1) · (1 − 2) = −5`.
fn distance_formula(normal: [f64; 2], p: Point, origin: Point, d: f64) -> Formula {
    let formula = Formula::default()
        .sym("n = ")
        .point(normal)
        .sym(",  d₁ = n·(P₁ − E) = ");
    let terms = [
        (normal[0], p.x(), origin.x()),
        (normal[1], p.y(), origin.y()),
    ];
    let mut first = true;
    terms
        .into_iter()
        .filter(|&(n, ..)| n != 0.0)
        .fold(formula, |formula, (n, a, o)| {
            let formula = if std::mem::take(&mut first) {
                formula.num(n)
            } else {
                formula.sym(" + ").operand(n)
            };
            formula.sym(" · (").num(a).sym(" − ").operand(o).sym(")")
        })
        .equals(d)
}

/// `t = −d₁ / n·D = 1 / 4 = 1/4`.
fn bound_caption(key: &'static str, edge_idx: usize, before: &State, t: f64) -> Caption {
    let caption = edge_caption(key, edge_idx);
    match before.rows.get(edge_idx) {
        Some(row) => caption.so(Formula::default()
            .sym("t = −d₁ / n·D = ")
            .dividend(-row.d1)
            .sym(" / ")
            .divisor(row.slope)
            .equals(t)),
        None => caption,
    }
}

fn put_caption(
    end: End,
    t: f64,
    edge_idx: Option<usize>,
    at: Point,
    before: &State,
    input: &Input,
) -> Caption {
    let Some(edge_idx) = edge_idx else {
        return Caption::new(
            Message::new("lb-put-end")
                .with("end", end_name(end))
                .with("at", at.to_array()),
        );
    };
    let caption = Caption::new(
        Message::new("cb-put")
            .with("end", end_name(end))
            .with("t", t)
            .with("edge", edge_name(edge_idx)),
    );
    match before.rows.get(edge_idx) {
        Some(&Row { d1, d2, slope, .. }) => caption.so(Formula::default()
            .sym("(")
            .point(input.segment.p1.to_array())
            .sym(" · ")
            .operand(d2)
            .sym(" − ")
            .point(input.segment.p2.to_array())
            .sym(" · ")
            .operand(d1)
            .sym(") / ")
            .divisor(slope)
            .sym(" = ")
            .point(at.to_array())),
        None => caption,
    }
}

/// Every edge's normal, drawn from its middle; the current edge and its normal stand out.
fn normals(step: &Step<'_, CyrusBeck>, current: Option<usize>) -> Vec<Mark> {
    let vertices = step.input.clip.vertices();
    let [min, max] = extent(vertices.iter().copied());
    // Long enough to be seen, whatever the size of the polygon.
    let length = 0.14 * (max[0] - min[0]).max(max[1] - min[1]);
    let mut marks = Vec::new();
    for (i, plane) in step.input.clip.half_planes().enumerate() {
        let [a, b] = [i, (i + 1) % vertices.len()].map(|i| vertices[i].to_array());
        let middle = DVec2::from(a).midpoint(DVec2::from(b));
        let tip = middle + DVec2::from(plane.normal()).normalize_or_zero() * length;
        let role = if current == Some(i) {
            marks.push(Mark::new(Role::Signal, Shape::Line([a, b])).linked(edge_link(i)));
            Role::Signal
        } else {
            Role::Soft
        };
        marks.push(
            Mark::new(role, Shape::Arrow([middle.to_array(), tip.to_array()]))
                .labelled(edge_name(i))
                .linked(edge_link(i)),
        );
    }
    marks
}
