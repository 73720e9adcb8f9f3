//! Liang–Barsky, shown.

use crate::labs::words::{along, border_equation, edge_name, name};
use crate::{
    algo::line::{
        End, LiangBarsky, LiangBarskyEvent as Event, LiangBarskyState as State, WindowInput,
    },
    figure::{Body, Caption, Mark, Role, Shape, Side, Tick, View, Watch, WatchRow, WatchSection},
    geom::{Axis, Edge, Point, Segment},
    labs::{
        CodeLine, Demo, Step, code_line,
        lines::{LineDemo, Scene, demo::Settles},
    },
    text::{Formula, Message, Value},
};

use super::{
    parametric::{moved_ends_rows, stays_caption},
    rows::{edge_in_hand, interval, ratio, reach, row_values, rows_table},
    shared::{accepted, opening, outside_marks, put_formulas},
};
use crate::labs::interval::{direction, quotient_formula};
use crate::labs::words::end_name;

/// The view of the rows p, q, r.
const ROWS_VIEW: &str = "pqr";
/// The view of what is left of u.
const AXIS_VIEW: &str = "axis";

const START: usize = 0;
const EACH: usize = 1;
const PARALLEL: usize = 2;
const ENTER: usize = 3;
const LEAVE: usize = 4;
const EMPTY: usize = 5;
const ACCEPT: usize = 6;

impl LineDemo for LiangBarsky {
    fn input(scene: &Scene, segment: Segment) -> WindowInput {
        WindowInput {
            window: scene.window,
            segment,
        }
    }

    fn settles(event: &Event, _: &WindowInput) -> Settles {
        match *event {
            Event::Parallel { .. } | Event::Interval { .. } => Settles::Asked,
            Event::Delta { .. }
            | Event::Row { .. }
            | Event::Enter { .. }
            | Event::Leave { .. }
            | Event::Put { .. }
            | Event::Accept { .. } => Settles::Nothing,
            Event::Reject { edge } => Settles::Rejected(edge as usize),
        }
    }

    fn between(state: &State) -> Option<[Value; 2]> {
        let [enters, leaves] = state.set_by;
        let [u_min, u_max] = state.interval;
        (u_min > u_max).then_some([edge_name(enters?), edge_name(leaves?)])
    }
}

impl Demo for LiangBarsky {
    const ID: &'static str = "liang-barsky";
    const NAME_KEY: &'static str = "alg-liang-barsky";
    const SOURCE: &'static str = "Liang & Barsky, 1984";
    const CODE: &'static [CodeLine] = &[
        code_line(0, "code-lb-start", "words-lb-start"),
        code_line(0, "code-lb-each", "words-lb-each"),
        code_line(1, "code-lb-parallel", "words-lb-parallel"),
        code_line(1, "code-lb-enter", "words-lb-enter"),
        code_line(1, "code-lb-leave", "words-lb-leave"),
        code_line(1, "code-lb-empty", "words-lb-empty"),
        code_line(0, "code-lb-accept", "words-lb-accept"),
    ];

    fn tick(event: &Event) -> Tick {
        match event {
            Event::Row { .. } => Tick::Phase,
            Event::Delta { .. } | Event::Parallel { .. } | Event::Interval { .. } => Tick::Test,
            Event::Enter { .. } | Event::Leave { .. } | Event::Put { .. } => Tick::Cut,
            Event::Accept { .. } => Tick::Accept,
            Event::Reject { .. } => Tick::Reject,
        }
    }

    fn code_line(event: &Event, _: &State) -> usize {
        match event {
            Event::Delta { .. } => START,
            Event::Row { .. } => EACH,
            Event::Parallel { .. } => PARALLEL,
            Event::Enter { .. } => ENTER,
            Event::Leave { .. } => LEAVE,
            Event::Interval { .. } | Event::Reject { .. } => EMPTY,
            Event::Put { .. } | Event::Accept { .. } => ACCEPT,
        }
    }

    fn opening(input: &WindowInput) -> Caption {
        opening(&input.segment)
    }

    fn caption(event: &Event, before: &State, input: &WindowInput) -> Caption {
        let segment = &input.segment;
        match *event {
            Event::Delta { dx, dy } => delta_caption(segment, dx, dy),
            Event::Row { edge, p, q } => row_caption(edge, p, q, input),
            Event::Parallel { edge, q, inside } => {
                let key = if inside {
                    "lb-parallel-inside"
                } else {
                    "lb-parallel-outside"
                };
                Caption::new(Message::new(key).with("edge", edge_name(edge))).so(Formula::default()
                    .sym("p = 0,  q = ")
                    .num(q)
                    .sym(if inside { " ≥ 0" } else { " < 0" }))
            }
            Event::Enter {
                edge,
                r,
                raises,
                u_min,
            } => {
                let key = if raises { "lb-enter" } else { "lb-enter-idle" };
                bound_caption(key, edge, r, before).so(formula(
                    before,
                    edge,
                    Side::Entering,
                    r,
                    u_min,
                ))
            }
            Event::Leave {
                edge,
                r,
                lowers,
                u_max,
            } => {
                let key = if lowers { "lb-leave" } else { "lb-leave-idle" };
                bound_caption(key, edge, r, before).so(formula(
                    before,
                    edge,
                    Side::Leaving,
                    r,
                    u_max,
                ))
            }
            Event::Interval { empty, .. } => interval(before, None).shown.caption(empty),
            Event::Put { end, u, edge, at } => put_caption(end, u, edge, at, before, input),
            Event::Accept { segment: visible } => accepted(&input.segment, visible),
            Event::Reject { edge } => {
                Caption::new(Message::new("lb-reject").with("edge", edge_name(edge)))
            }
        }
    }

    fn views(step: &Step<'_, Self>) -> Vec<View> {
        let interval = interval(step.state, step.event);
        vec![
            View::plane(marks(step)),
            View::new(ROWS_VIEW, Body::Table(rows_table(step))),
            View::new(
                AXIS_VIEW,
                Body::NumberLine(interval.shown.number_line(reach(step.input))),
            ),
        ]
    }

    fn watch(step: &Step<'_, Self>) -> Watch {
        let state = step.state;
        let mut rows = vec![
            WatchRow::new(name("Δx"), state.delta.map(|d| Value::Number(d[0]))),
            WatchRow::new(name("Δy"), state.delta.map(|d| Value::Number(d[1]))),
        ];
        rows.extend(moved_ends_rows(state.ends));
        let bounds = interval(state, step.event).shown.bound_rows().collect();
        vec![
            WatchSection::list(rows),
            WatchSection::table(vec!["p", "q", "r"], row_values(state)).seen_in(ROWS_VIEW),
            WatchSection::list(bounds).seen_in(AXIS_VIEW),
        ]
    }
}

/// The drawing.
fn marks(step: &Step<'_, LiangBarsky>) -> Vec<Mark> {
    let WindowInput { window, segment } = step.input;
    let mut marks = vec![Mark::new(
        Role::Faint,
        Shape::Line([segment.p1.to_array(), segment.p2.to_array()]),
    )];
    if let Some(edge) = edge_in_hand(step.state, step.event) {
        marks.extend(outside_marks(window, edge));
    }
    marks.extend(interval(step.state, step.event).marks(segment));
    marks
}

/// `u_min = max(0, 1/4) = 1/4`
fn formula(before: &State, edge: Edge, side: Side, r: f64, new: f64) -> Formula {
    interval(before, None)
        .shown
        .bound_formula(side, r, ratio(before, edge, r), new)
}

fn delta_caption(segment: &Segment, dx: f64, dy: f64) -> Caption {
    let difference = |symbol: &'static str, a2: f64, a1: f64, d: f64| {
        Formula::default()
            .sym(symbol)
            .sym(" = ")
            .num(a2)
            .sym(" − ")
            .operand(a1)
            .equals(d)
    };
    let (p1, p2) = (segment.p1, segment.p2);
    Caption::new(Message::new("lb-delta"))
        .so(difference("Δx", p2.x(), p1.x(), dx))
        .so(difference("Δy", p2.y(), p1.y(), dy))
}

fn row_caption(
    edge: Edge,
    p: f64,
    q: f64,
    WindowInput { window, segment }: &WindowInput,
) -> Caption {
    let (axis, c) = (edge.axis(), window.border(edge));
    let [a1, _] = along(segment.p1, axis);
    let [delta, x1] = match axis {
        Axis::X => ["Δx", "x₁"],
        Axis::Y => ["Δy", "y₁"],
    };
    let border = match edge {
        Edge::Left => "x_min",
        Edge::Right => "x_max",
        Edge::Bottom => "y_min",
        Edge::Top => "y_max",
    };
    let sign = if edge.is_max() { "" } else { "−" };
    let of_p = Formula::default()
        .sym(format!("p = {sign}{delta}"))
        .equals(p);
    let of_q = if edge.is_max() {
        Formula::default()
            .sym(format!("q = {border} − {x1} = "))
            .num(c)
            .sym(" − ")
            .operand(a1)
    } else {
        Formula::default()
            .sym(format!("q = {x1} − {border} = "))
            .num(a1)
            .sym(" − ")
            .operand(c)
    };
    Caption::new(
        Message::new("lb-row")
            .with("k", edge as usize + 1)
            .with("edge", edge_name(edge))
            .with("direction", Value::Term(direction(p))),
    )
    .so(of_p)
    .so(of_q.equals(q))
}

/// `r = q/p = −1/−4 = 1/4`.
fn bound_caption(key: &'static str, edge: Edge, r: f64, before: &State) -> Caption {
    Caption::new(Message::new(key).with("edge", edge_name(edge))).so(quotient_formula(
        "r",
        ["q", "p"].map(|symbol| Formula::default().sym(symbol)),
        ratio(before, edge, r),
    ))
}

fn put_caption(
    end: End,
    u: f64,
    edge: Option<Edge>,
    at: Point,
    before: &State,
    WindowInput { window, segment }: &WindowInput,
) -> Caption {
    let Some(edge) = edge else {
        return stays_caption(end, at);
    };
    let message = Message::new("lb-put")
        .with("end", end_name(end))
        .with("u", interval(before, None).shown.written(u))
        .with("border", border_equation(window, edge));
    let [u_min, u_max] = before.interval;
    let [enters, leaves] = before.set_by;
    let sides = enters.zip(leaves).filter(|_| u_min == u_max);
    put_formulas(segment, window, edge, at, sides.map(Into::into))
        .into_iter()
        .fold(Caption::new(message), Caption::so)
}
