//! Brute force, shown.

use crate::{
    algo::line::{
        BruteForce, BruteForceEvent as Event, BruteForceState as State, CrossingFate, End, Ratio,
        WindowInput,
    },
    figure::{
        Body, Caption, Cell, Mark, Role, Shape, Table, TableNote, TableRow, Tick, View, Watch,
        WatchRow, WatchSection,
    },
    geom::{Edge, Segment},
    labs::{
        CodeLine, Demo, Step, code_line,
        lines::{LineDemo, Scene, demo::Settles},
    },
    text::{Formula, Message, Value},
};

use super::shared::{
    accepted, border_mark, crossing_mark, ends_rows, inside_mark, opening, outside_marks,
    parallel_formula, segment_marks, side_key,
};
use crate::labs::crossing_formulas::upright;
use crate::labs::words::{along, axis_symbol, border_equation, edge_link, edge_name, name};
use crate::labs::words::{end_name, end_symbol};

/// The view of the crossings, computed one by one.
const CROSSINGS_VIEW: &str = "crossings";

const EACH: usize = 0;
const INTERSECT: usize = 1;
const REJECT: usize = 2;
const CUT: usize = 3;
const ACCEPT: usize = 4;

impl LineDemo for BruteForce {
    fn input(scene: &Scene, segment: Segment) -> WindowInput {
        WindowInput {
            window: scene.window,
            segment,
        }
    }

    fn settles(event: &Event, _: &WindowInput) -> Settles {
        match *event {
            Event::Intersect { .. } | Event::Parallel { .. } => Settles::Nothing,
            Event::Keep { .. } | Event::Cut { .. } | Event::Accept { .. } => Settles::Asked,
            Event::Reject { edge } => Settles::Rejects(edge as usize),
        }
    }
}

impl Demo for BruteForce {
    const ID: &'static str = "brute-force";
    const NAME_KEY: &'static str = "alg-brute-force";
    const SOURCE: &'static str = "Rogers, 1998, §3-1";
    const CODE: &'static [CodeLine] = &[
        code_line(0, "code-bf-each", "words-bf-each"),
        code_line(1, "code-bf-intersect", "words-bf-intersect"),
        code_line(1, "code-bf-reject", "words-bf-reject"),
        code_line(1, "code-bf-cut", "words-bf-cut"),
        code_line(0, "code-bf-accept", "words-bf-accept"),
    ];

    fn tick(event: &Event) -> Tick {
        match event {
            Event::Intersect { .. } => Tick::Phase,
            Event::Parallel { .. } | Event::Keep { .. } => Tick::Test,
            Event::Cut { .. } => Tick::Cut,
            Event::Accept { .. } => Tick::Accept,
            Event::Reject { .. } => Tick::Reject,
        }
    }

    fn code_line(event: &Event, _: &State) -> usize {
        match event {
            Event::Parallel { .. } => EACH,
            Event::Intersect { .. } => INTERSECT,
            Event::Reject { .. } => REJECT,
            Event::Keep { .. } | Event::Cut { .. } => CUT,
            Event::Accept { .. } => ACCEPT,
        }
    }

    fn opening(input: &WindowInput) -> Caption {
        opening(&input.segment)
    }

    fn caption(event: &Event, before: &State, input: &WindowInput) -> Caption {
        let WindowInput { window, segment } = input;
        match *event {
            Event::Intersect { edge, at, .. } => {
                let message = Message::new("bf-intersect").with("edge", edge_name(edge));
                upright(segment, edge.axis(), window.border(edge), at)
                    .into_iter()
                    .fold(Caption::new(message), Caption::so)
            }
            Event::Parallel { edge } => {
                Caption::new(Message::new("line-parallel").with("edge", edge_name(edge)))
                    .so(parallel_formula(segment, edge))
            }
            Event::Keep { edge } => {
                let is_parallel = before.crossings[edge as usize].is_none();
                let key = if is_parallel {
                    "bf-keep-parallel"
                } else {
                    "bf-keep"
                };
                Caption::new(Message::new(key).with("edge", edge_name(edge)))
                    .so(both_sides(before, input, edge))
            }
            Event::Cut { end, edge, to, .. } => Caption::new(
                Message::new("bf-cut")
                    .with("end", end_name(end))
                    .with("border", border_equation(window, edge))
                    .with("to", to.to_array()),
            )
            .so(both_sides(before, input, edge)),
            Event::Accept { segment: visible } => accepted(&input.segment, visible),
            Event::Reject { edge } => {
                Caption::new(Message::new("line-reject-edge").with("edge", edge_name(edge)))
                    .so(both_sides(before, input, edge))
            }
        }
    }

    fn views(step: &Step<'_, Self>) -> Vec<View> {
        vec![
            View::plane(marks(step)),
            View::new(
                CROSSINGS_VIEW,
                Body::Table(match step.event {
                    None => tests_table(step.input),
                    Some(_) => crossing_table(step),
                }),
            ),
        ]
    }

    fn watch(step: &Step<'_, Self>) -> Watch {
        let state = step.state;
        let mut rows = ends_rows(state.ends);
        let n_crossings = state.crossings.iter().flatten().count();
        let is_used = |fate: &&CrossingFate| matches!(fate, CrossingFate::Replaces(_));
        let n_used = state.fates.iter().flatten().filter(is_used).count();
        for (key, n) in [
            ("watch-crossings", n_crossings),
            ("watch-crossings-used", n_used),
        ] {
            rows.push(WatchRow::new(Value::Term(key), Some(Value::Count(n))));
        }
        let of_edge = |edge| {
            let cells = crossing_values(state, edge).to_vec();
            WatchRow::table(edge_name(edge), cells).linked(edge_link(edge))
        };
        let table = WatchSection::table(vec!["t", "P(t)"], Edge::ALL.map(of_edge).to_vec());
        vec![WatchSection::list(rows), table.seen_in(CROSSINGS_VIEW)]
    }
}

/// t and P(t), once computed.
fn crossing_values(state: &State, edge: Edge) -> [Option<Value>; 2] {
    let crossing = state.crossings[edge as usize];
    [
        crossing.map(|(_, Ratio { num, den })| Value::Ratio { num, den }),
        crossing.map(|(at, _)| Value::Point(at.to_array())),
    ]
}

/// Before the first crossing: the four tests that make a window, on both ends. What fails stands out.
fn tests_table(WindowInput { window, segment }: &WindowInput) -> Table {
    let test = |end: End, edge: Edge| {
        let ([x, _], c) = (along(end.of(segment), edge.axis()), window.border(edge));
        let (fails, relation) = match edge.is_max() {
            true if x > c => (true, " > "),
            true => (false, " ≤ "),
            false if x < c => (true, " < "),
            false => (false, " ≥ "),
        };
        let said = Formula::default().num(x).sym(relation).num(c);
        let role = if fails { Role::Signal } else { Role::Ink };
        Cell::new(role, Some(said))
    };
    let row = |edge: Edge| TableRow {
        name: Value::Term(side_key(edge)),
        cells: End::BOTH.map(|end| test(end, edge)).to_vec(),
        is_current: false,
        link: Some(edge_link(edge)),
    };
    Table {
        header: vec![
            Formula::default().term("table-edge"),
            Formula::default().sym(end_symbol(End::P1)),
            Formula::default().sym(end_symbol(End::P2)),
        ],
        rows: Edge::ALL.map(row).to_vec(),
        notes: vec![TableNote {
            text: Message::new("bf-note-tests"),
            applies: true,
        }],
    }
}

/// Every crossing, and what it was good for.
fn crossing_table(step: &Step<'_, BruteForce>) -> Table {
    let current = current_edge(step.event);
    let of_edge = |edge: Edge| {
        let fate = step.state.fates[edge as usize];
        let role = match fate {
            _ if current == Some(edge) => Role::Signal,
            Some(CrossingFate::InVain | CrossingFate::Parallel) => Role::Soft,
            Some(CrossingFate::Replaces(_)) | None => Role::Ink,
        };
        let found_now = matches!(step.event, Some(Event::Intersect { .. }));
        let found = if found_now || role == Role::Soft {
            role
        } else {
            Role::Ink
        };
        let mut cells: Vec<Cell> = crossing_values(step.state, edge)
            .into_iter()
            .map(|value| Cell::new(found, value))
            .collect();
        cells.push(Cell::new(role, fate.map(fate_word)));
        TableRow {
            name: Value::Term(side_key(edge)),
            cells,
            is_current: current == Some(edge),
            link: Some(edge_link(edge)),
        }
    };
    Table {
        header: vec![
            Formula::default().term("table-edge"),
            Formula::default().sym("t"),
            Formula::default().sym("P(t)"),
            Formula::default(),
        ],
        rows: Edge::ALL.map(of_edge).to_vec(),
        notes: Vec::new(),
    }
}

/// "in vain", or the end that the crossing replaces.
fn fate_word(fate: CrossingFate) -> Value {
    match fate {
        CrossingFate::Parallel => Value::Term("verdict-parallel"),
        CrossingFate::InVain => Value::Term("bf-in-vain"),
        CrossingFate::Replaces(end) => name(format!("→ {}′", end_symbol(end))),
    }
}

/// The side that the step is about.
const fn current_edge(event: Option<Event>) -> Option<Edge> {
    match event {
        Some(
            Event::Intersect { edge, .. }
            | Event::Parallel { edge }
            | Event::Keep { edge }
            | Event::Cut { edge, .. }
            | Event::Reject { edge },
        ) => Some(edge),
        Some(Event::Accept { .. }) | None => None,
    }
}

/// The drawing.
fn marks(step: &Step<'_, BruteForce>) -> Vec<Mark> {
    let WindowInput { window, segment } = step.input;
    let current = current_edge(step.event);
    let mut marks: Vec<Mark> = Edge::ALL
        .into_iter()
        .filter(|&edge| Some(edge) != current)
        .map(|edge| {
            // Before the first crossing, the four tests that make a window.
            if step.event.is_none() {
                return inside_mark(window, edge);
            }
            let border = Shape::Border(edge.axis(), window.border(edge));
            Mark::new(Role::Faint, border).linked(edge_link(edge))
        })
        .collect();
    marks.push(Mark::new(
        Role::Faint,
        Shape::Line([segment.p1.to_array(), segment.p2.to_array()]),
    ));
    match step.event {
        Some(Event::Intersect { edge, .. } | Event::Parallel { edge }) => {
            marks.push(border_mark(window, edge));
        }
        Some(Event::Keep { edge } | Event::Cut { edge, .. } | Event::Reject { edge }) => {
            marks.extend(outside_marks(window, edge));
        }
        Some(Event::Accept { .. }) | None => {}
    }
    marks.extend(segment_marks(segment, step.state.ends, step.state.verdict));
    for edge in Edge::ALL {
        let Some((at, u)) = step.state.crossings[edge as usize] else {
            continue;
        };
        let used = step.state.ends.contains(&at);
        if used && step.state.verdict.is_some() {
            continue;
        }
        marks.push(if Some(edge) == current && step.state.verdict.is_none() {
            crossing_mark(at, "t", u).linked(edge_link(edge))
        } else if used {
            Mark::new(Role::Accent, Shape::Dot(at.to_array())).linked(edge_link(edge))
        } else {
            let label = Formula::default().sym("t = ").ratio(u.num, u.den);
            Mark::new(Role::Discarded, Shape::Cross(at.to_array()))
                .labelled(label)
                .linked(edge_link(edge))
        });
    }
    marks
}

/// `x₁′ = −1 < 1,  x₂ = 2 > 1`: both ends of what is left beside the border that they are compared with.
fn both_sides(before: &State, input: &WindowInput, edge: Edge) -> Formula {
    let (axis, c) = (edge.axis(), input.window.border(edge));
    End::BOTH
        .into_iter()
        .fold(Formula::default(), |formula, end| {
            let at = before.ends[end.idx()];
            let [a, _] = along(at, axis);
            let relation = if a < c {
                " < "
            } else if a > c {
                " > "
            } else {
                " = "
            };
            let symbol = axis_symbol(axis);
            let subscript = ["₁", "₂"][end.idx()];
            let prime = if at == end.of(&input.segment) {
                ""
            } else {
                "′"
            };
            let gap = if end == End::P2 { ",  " } else { "" };
            formula
                .sym(format!("{gap}{symbol}{subscript}{prime} = "))
                .num(a)
                .sym(relation)
                .num(c)
        })
}
