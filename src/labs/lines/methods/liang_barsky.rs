//! Liang–Barsky, shown.

use crate::labs::words::{along, border_equation, edge_link, edge_name, free_formula, name};
use crate::{
    algo::line::{
        End, LiangBarsky, LiangBarskyEvent as Event, LiangBarskyState as State, Row, WindowInput,
    },
    figure::{Body, Caption, Mark, Role, Shape, Side, Tick, View, Watch, WatchRow, WatchSection},
    geom::{Axis, Edge, Point, Segment, Window},
    labs::{
        CodeLine, Demo, Step, code_line,
        lines::{LineDemo, Scene},
    },
    text::{Formula, Message, Value},
};

use super::{
    parametric::{Crossing, Interval, bound_formula, interval_caption, moved_ends_rows},
    shared::{accepted, end_name, opening, outside_marks},
};

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
        let WindowInput { window, segment } = input;
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
                bound_caption(key, edge, before, r).so(bound_formula(
                    "u_min = max(",
                    [before.interval[0], r],
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
                bound_caption(key, edge, before, r).so(bound_formula(
                    "u_max = min(",
                    [before.interval[1], r],
                    u_max,
                ))
            }
            Event::Interval {
                u_min,
                u_max,
                empty,
            } => interval_caption(["u_min", "u_max"], [u_min, u_max], empty),
            Event::Put { end, u, edge, at } => put_caption(end, u, edge, at, segment, window),
            Event::Accept { segment } => accepted(&segment),
            Event::Reject { edge } => {
                Caption::new(Message::new("lb-reject").with("edge", edge_name(edge)))
            }
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
        let table = Edge::ALL
            .into_iter()
            .map(|edge| {
                let row = state.rows[edge as usize];
                let cells = vec![
                    row.map(|row| Value::Number(row.p)),
                    row.map(|row| Value::Number(row.q)),
                    row.and_then(|row| row.r).map(Value::Number),
                ];
                let shown = WatchRow::table(edge_name(edge), cells).linked(edge_link(edge));
                match row {
                    Some(row) => shown.noted(Value::Term(direction(row.p))),
                    None => shown,
                }
            })
            .collect();
        let mut rows = vec![
            WatchRow::new(name("Δx"), state.delta.map(|d| Value::Number(d[0]))),
            WatchRow::new(name("Δy"), state.delta.map(|d| Value::Number(d[1]))),
        ];
        rows.extend(interval(step).bound_rows());
        rows.extend(moved_ends_rows(state.ends));
        vec![
            WatchSection::table(vec!["p", "q", "r"], table),
            WatchSection::list(rows),
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
    if let Some(edge) = current_edge(step.event) {
        marks.extend(outside_marks(window, edge));
    }
    marks.extend(interval(step).marks(segment));
    marks
}

fn interval(step: &Step<'_, LiangBarsky>) -> Interval {
    let State {
        rows,
        interval: bounds,
        set_by,
        verdict,
        ..
    } = *step.state;
    let current = current_edge(step.event);
    let crossings = rows.into_iter().flatten().filter_map(|row| {
        Some(Crossing {
            at: row.r?,
            side: if row.p < 0.0 {
                Side::Entering
            } else {
                Side::Leaving
            },
            holds: set_by.contains(&Some(row.edge)),
            current: current == Some(row.edge),
            name: edge_name(row.edge),
            link: edge_link(row.edge),
        })
    });
    Interval {
        symbol: "u",
        crossing_symbol: "r",
        bounds,
        crossings: crossings.collect(),
        verdict,
    }
}

/// The side that the step is about.
const fn current_edge(event: Option<Event>) -> Option<Edge> {
    match event {
        Some(
            Event::Row { edge, .. }
            | Event::Parallel { edge, .. }
            | Event::Enter { edge, .. }
            | Event::Leave { edge, .. }
            | Event::Reject { edge },
        ) => Some(edge),
        _ => None,
    }
}

/// Catalogue key: which way the line crosses a side.
fn direction(p: f64) -> &'static str {
    if p < 0.0 {
        "verdict-entering"
    } else if p > 0.0 {
        "verdict-leaving"
    } else {
        "verdict-parallel"
    }
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
        Edge::Left => "xmin",
        Edge::Right => "xmax",
        Edge::Bottom => "ymin",
        Edge::Top => "ymax",
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
fn bound_caption(key: &'static str, edge: Edge, before: &State, r: f64) -> Caption {
    let caption = Caption::new(Message::new(key).with("edge", edge_name(edge)));
    match before.rows[edge as usize] {
        Some(Row { p, q, .. }) => caption.so(Formula::default()
            .sym("r = q / p = ")
            .dividend(q)
            .sym(" / ")
            .divisor(p)
            .equals(r)),
        None => caption,
    }
}

fn put_caption(
    end: End,
    u: f64,
    edge: Option<Edge>,
    at: Point,
    segment: &Segment,
    window: &Window,
) -> Caption {
    match edge {
        None => Caption::new(
            Message::new("lb-put-end")
                .with("end", end_name(end))
                .with("at", at.to_array()),
        ),
        Some(edge) => Caption::new(
            Message::new("lb-put")
                .with("end", end_name(end))
                .with("u", u)
                .with("border", border_equation(window, edge)),
        )
        .so(free_formula(
            segment,
            window,
            edge,
            along(at, edge.axis())[1],
        )),
    }
}
