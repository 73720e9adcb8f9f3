//! Cohen–Sutherland, shown.

use crate::{
    algo::line::{
        BitOrder, CohenSutherland, CohenSutherlandEvent as Event, CohenSutherlandInput as Input,
        CohenSutherlandState as State, End, Outcode,
    },
    figure::{Body, Caption, Mark, Role, Shape, Tick, View, Watch, WatchRow, WatchSection},
    geom::{Axis, Edge, Point, Segment},
    labs::{
        CodeLine, Demo, Step, code_line,
        lines::{LineDemo, Scene, demo::Settles},
    },
    text::{Formula, Message, Value},
};

use super::codes::{codes, deciding_edge};
use super::shared::{
    accepted, crossing_mark, ends_rows, opening, outside_marks, region_key, segment_marks,
};
use crate::labs::crossing_formulas::upright;
use crate::labs::words::{border_equation, edge_name, name, position_formula, subscript};
use crate::labs::words::{end_link, end_name};

/// The view of the codes as bits.
const CODES_VIEW: &str = "codes";

const CODES: usize = 0;
const ACCEPT: usize = 2;
const REJECT: usize = 3;
const CHOOSE: usize = 4;
const CUT: usize = 6;
const RECODE: usize = 7;

impl LineDemo for CohenSutherland {
    const WRITES_CODES: bool = true;

    fn input(scene: &Scene, segment: Segment) -> Input {
        Input {
            window: scene.window,
            segment,
            bit_order: scene.bit_order,
        }
    }

    fn settles(event: &Event, input: &Input) -> Settles {
        match *event {
            Event::Or { .. } | Event::And { .. } => Settles::Asked,
            Event::Code { .. }
            | Event::Choose { .. }
            | Event::Cut { .. }
            | Event::Accept { .. } => Settles::Nothing,
            Event::Reject { and } => {
                let edge = and.edges(input.bit_order).next();
                edge.map_or(Settles::Nothing, |edge| Settles::Rejected(edge as usize))
            }
        }
    }
}

impl Demo for CohenSutherland {
    const ID: &'static str = "cohen-sutherland";
    const NAME_KEY: &'static str = "alg-cohen-sutherland";
    const SOURCE: &'static str = "D. Cohen, I. Sutherland, 1967; Newman & Sproull, 1973";
    const CODE: &'static [CodeLine] = &[
        code_line(0, "code-cs-codes", "words-cs-codes"),
        code_line(0, "code-cs-loop", "words-cs-loop"),
        code_line(1, "code-cs-accept", "words-cs-accept"),
        code_line(1, "code-cs-reject", "words-cs-reject"),
        code_line(1, "code-cs-choose", "words-cs-choose"),
        code_line(1, "code-cs-end", "words-cs-end"),
        code_line(1, "code-cs-cut", "words-cs-cut"),
        code_line(1, "code-cs-recode", "words-cs-recode"),
    ];

    fn tick(event: &Event) -> Tick {
        match event {
            Event::Code { .. } | Event::Or { .. } | Event::And { .. } => Tick::Test,
            Event::Choose { .. } => Tick::Phase,
            Event::Cut { .. } => Tick::Cut,
            Event::Accept { .. } => Tick::Accept,
            Event::Reject { .. } => Tick::Reject,
        }
    }

    fn code_line(event: &Event, before: &State) -> usize {
        match event {
            // A code that is taken after a cut is the loop's last line.
            Event::Code { .. } if before.cut.is_some() => RECODE,
            Event::Code { .. } => CODES,
            Event::Or { .. } | Event::Accept { .. } => ACCEPT,
            Event::And { .. } | Event::Reject { .. } => REJECT,
            Event::Choose { .. } => CHOOSE,
            Event::Cut { .. } => CUT,
        }
    }

    fn opening(input: &Input) -> Caption {
        opening(&input.segment)
    }

    fn caption(event: &Event, before: &State, input: &Input) -> Caption {
        let order = input.bit_order;
        match *event {
            Event::Code { end, at, code } => code_caption(end, at, code, input),
            Event::Or { or } => {
                let key = if or.is_inside() {
                    "cs-or-accept"
                } else {
                    "cs-or-open"
                };
                combined(Message::new(key), "OR", or, before)
            }
            Event::And { and } => match and.edges(order).next() {
                Some(edge) => combined(
                    Message::new("cs-and-reject").with("edge", edge_name(edge)),
                    "AND",
                    and,
                    before,
                ),
                None => combined(Message::new("cs-and-open"), "AND", and, before),
            },
            Event::Choose { end, edge } => Caption::new(
                Message::new("cs-choose")
                    .with("edge", edge_name(edge))
                    .with("end", end_name(end)),
            )
            .so(Formula::default()
                .sym("code₁ OR code₂ = ")
                .sym(before.or.unwrap_or_default().to_string())),
            Event::Cut { end, edge, to, .. } => cut_caption(end, edge, to, input),
            Event::Accept { segment: visible } => accepted(&input.segment, visible),
            Event::Reject { and } => Caption::new(
                Message::new("cs-reject")
                    .with("and", name(and.to_string()))
                    .with("region", Value::Term(key_of(and, order))),
            ),
        }
    }

    fn views(step: &Step<'_, Self>) -> Vec<View> {
        vec![
            View::plane(marks(step)),
            View::new(CODES_VIEW, Body::Bits(codes(step))),
        ]
    }

    fn watch(step: &Step<'_, Self>) -> Watch {
        let mut scalars = ends_rows(step.state.ends);
        let t = if let Some(Event::Cut { u, .. }) = step.event {
            Some(Value::Ratio {
                num: u.num,
                den: u.den,
            })
        } else {
            None
        };
        scalars.push(WatchRow::new(name("t"), t));
        vec![
            WatchSection::list(scalars),
            WatchSection::list(code_rows(step.state, step.input.bit_order)).seen_in(CODES_VIEW),
        ]
    }
}

fn cut_caption(end: End, edge: Edge, to: Point, input: &Input) -> Caption {
    let Input {
        window, segment, ..
    } = input;
    let message = Message::new("cs-cut")
        .with("end", end_name(end))
        .with("border", border_equation(window, edge));
    upright(segment, edge.axis(), window.border(edge), to)
        .into_iter()
        .fold(Caption::new(message), Caption::so)
}

/// Both codes, and what OR and AND make of them.
fn code_rows(state: &State, order: BitOrder) -> Vec<WatchRow> {
    let of_ends = ["code₁", "code₂"].into_iter().zip(state.codes);
    let of_ends = of_ends.map(|(symbol, code)| {
        let row = WatchRow::new(name(symbol), code.map(|c| name(c.to_string())));
        match code {
            Some(code) => row.noted(Value::Term(key_of(code, order))),
            None => row,
        }
    });
    let both = [("OR", state.or), ("AND", state.and)].map(|(symbol, code)| {
        let row = WatchRow::new(name(symbol), code.map(|c| name(c.to_string())));
        match code {
            Some(c) if c.is_inside() => row.noted(name("= 0")),
            Some(_) => row.noted(name("≠ 0")),
            None => row,
        }
    });
    of_ends.chain(both).collect()
}

/// The drawing.
fn marks(step: &Step<'_, CohenSutherland>) -> Vec<Mark> {
    let Input {
        window,
        segment,
        bit_order,
    } = *step.input;
    let mut marks = regions(step, bit_order);
    if let Some(edge) = deciding_edge(step) {
        marks.extend(outside_marks(&window, edge));
    }
    // A bit in common rejects as soon as it is seen.
    let is_rejected = matches!(step.event, Some(Event::And { and }) if !and.is_inside());
    let verdict = if is_rejected {
        Some(None)
    } else {
        step.state.verdict
    };
    marks.extend(numbered_cuts(step.state));
    marks.extend(segment_marks(&segment, step.state.ends, verdict));
    match step.event {
        Some(Event::Code { end, at, .. }) => marks.push(signal_ring(end, at)),
        Some(Event::Cut { end, u, to, .. }) => {
            marks.push(crossing_mark(to, "t", u).linked(end_link(end)));
        }
        Some(
            Event::Or { .. }
            | Event::And { .. }
            | Event::Choose { .. }
            | Event::Accept { .. }
            | Event::Reject { .. },
        )
        | None => {}
    }
    marks
}

/// "P₁ is above left: code₁ = 1001", and the comparisons that say so.
fn code_caption(end: End, at: Point, code: Outcode, input: &Input) -> Caption {
    let message = Message::new("cs-code")
        .with("end", end_name(end))
        .with("region", Value::Term(key_of(code, input.bit_order)))
        .with("code", name(["code₁", "code₂"][end.idx()]))
        .with("bits", name(code.to_string()));
    [Axis::X, Axis::Y]
        .into_iter()
        .fold(Caption::new(message), |caption, axis| {
            caption.so(position_formula(axis, at, &input.window, |edge| {
                code.has(edge, input.bit_order)
            }))
        })
}

/// The decision on a combination of both codes, worked out: `0001 OR 1010 = 1011`.
fn combined(message: Message, operator: &'static str, result: Outcode, before: &State) -> Caption {
    let [code1, code2] = before.codes.map(Option::unwrap_or_default);
    Caption::new(message.with("bits", name(result.to_string())))
        .so(Formula::default().sym(format!("{code1} {operator} {code2} = {result}")))
}

/// The nine regions with their codes; those of the two ends stand out.
fn regions(step: &Step<'_, CohenSutherland>, order: BitOrder) -> Vec<Mark> {
    let [xmin, ymin, xmax, ymax] = step.input.window.to_array();
    let columns = [
        (f64::NEG_INFINITY, xmin, Some(Edge::Left)),
        (xmin, xmax, None),
        (xmax, f64::INFINITY, Some(Edge::Right)),
    ];
    let rows = [
        (f64::NEG_INFINITY, ymin, Some(Edge::Bottom)),
        (ymin, ymax, None),
        (ymax, f64::INFINITY, Some(Edge::Top)),
    ];
    let mut marks: Vec<Mark> = Edge::ALL
        .into_iter()
        .map(|edge| {
            let border = Shape::Border(edge.axis(), step.input.window.border(edge));
            Mark::new(Role::Faint, border)
        })
        .collect();
    let deciding = deciding_edge(step);
    let column = deciding.and_then(|edge| order.written().iter().position(|&e| e == edge));
    let beyond = |code: Outcode| deciding.is_some_and(|edge| code.has(edge, order));
    for (x0, x1, x_edge) in columns {
        for (y0, y1, y_edge) in rows {
            let edges: Vec<Edge> = x_edge.into_iter().chain(y_edge).collect();
            let code = Outcode::from_edges(&edges, order);
            let taken = step.state.codes.contains(&Some(code));
            let role = if taken { Role::Ink } else { Role::Soft };
            let region = Shape::Region([[x0, y0], [x1, y1]]);
            let mark = Mark::new(role, region).coded(name(code.to_string()));
            marks.push(match column.filter(|_| beyond(code)) {
                Some(column) => mark.lit(column),
                None => mark,
            });
        }
    }
    marks
}

/// Several cuts have numbers, in the order in which they were made; a cross is where an end was cut off again.
fn numbered_cuts(state: &State) -> Vec<Mark> {
    let cuts: Vec<Point> = state.cuts.into_iter().flatten().collect();
    if cuts.len() < 2 {
        return Vec::new();
    }
    let mark = |(nth, at): (usize, Point)| {
        let is_end = state.ends.contains(&at);
        let shape = if is_end { Shape::Vertex } else { Shape::Cross };
        let role = if is_end { Role::Soft } else { Role::Discarded };
        let label = name(format!("I{}", subscript(nth + 1)));
        Mark::new(role, shape(at.to_array())).labelled(label)
    };
    cuts.into_iter().enumerate().map(mark).collect()
}

fn signal_ring(end: End, at: Point) -> Mark {
    Mark::new(Role::Signal, Shape::Ring(at.to_array())).linked(end_link(end))
}

/// Catalogue key of the region that a code stands for.
fn key_of(code: Outcode, order: BitOrder) -> &'static str {
    region_key(|edge| code.has(edge, order))
}
