//! Cyrus–Beck, shown.

use crate::{
    algo::line::{
        CyrusBeck, CyrusBeckEvent as Event, CyrusBeckInput as Input, CyrusBeckRow as Row,
        CyrusBeckState as State, End,
    },
    figure::{Body, Caption, Mark, Side, Tick, View, Watch, WatchSection},
    geom::{Point, Segment},
    labs::{
        CodeLine, Demo, Step, code_line,
        crossing_formulas::{fixed, oblique, taken, upright},
        lines::{LineDemo, Scene, demo::Settles},
    },
    text::{Formula, Message, Value},
};

use super::{
    convex_edges::{edge_name, edge_table, interval, ratio, reach, row_values},
    dot_products::{edge_marks, products},
    parametric::{moved_ends_rows, stays_caption},
    shared::{accepted, opening},
};
use crate::labs::interval::quotient_formula;
use crate::labs::words::end_name;

/// The view of the edge in hand, or of all edges.
const EDGES_VIEW: &str = "edges";
/// The view of what is left of t.
const AXIS_VIEW: &str = "axis";

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

    fn settles(event: &Event, _: &Input) -> Settles {
        match *event {
            Event::Parallel { .. } | Event::Interval { .. } => Settles::Asked,
            Event::Edge { .. }
            | Event::Enter { .. }
            | Event::Leave { .. }
            | Event::Put { .. }
            | Event::Accept { .. } => Settles::Nothing,
            Event::Reject { edge_idx } => Settles::Rejected(edge_idx),
        }
    }

    fn between(state: &State) -> Option<[Value; 2]> {
        let [enters, leaves] = state.set_by;
        let [t_min, t_max] = state.interval;
        (t_min > t_max).then_some([edge_name(enters?), edge_name(leaves?)])
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
                bound_caption(key, edge_idx, before, Side::Entering, [t, t_min])
            }
            Event::Leave {
                edge_idx,
                t,
                lowers,
                t_max,
            } => {
                let key = if lowers { "cb-leave" } else { "cb-leave-idle" };
                bound_caption(key, edge_idx, before, Side::Leaving, [t, t_max])
            }
            Event::Interval { empty, .. } => interval(before, None).shown.caption(empty),
            Event::Put {
                end,
                t,
                edge_idx,
                at,
            } => put_caption(end, t, edge_idx, at, before, input),
            Event::Accept { segment: visible } => accepted(&input.segment, visible),
            Event::Reject { edge_idx } => edge_caption("cb-reject", edge_idx),
        }
    }

    fn views(step: &Step<'_, Self>) -> Vec<View> {
        let edges = match products(step) {
            Some(products) => Body::Products(products),
            None => Body::Table(edge_table(step)),
        };
        let interval = interval(step.state, step.event);
        vec![
            View::plane(marks(step)),
            View::new(EDGES_VIEW, edges),
            View::new(
                AXIS_VIEW,
                Body::NumberLine(interval.shown.number_line(reach(step.input))),
            ),
        ]
    }

    fn watch(step: &Step<'_, Self>) -> Watch {
        let scalars = moved_ends_rows(step.state.ends).collect();
        let table = WatchSection::table(vec!["n·(P₁ − E)", "n·D", "t"], row_values(step));
        let bounds = interval(step.state, step.event)
            .shown
            .bound_rows()
            .collect();
        vec![
            WatchSection::list(scalars),
            table.seen_in(EDGES_VIEW),
            WatchSection::list(bounds).seen_in(AXIS_VIEW),
        ]
    }
}

/// The drawing.
fn marks(step: &Step<'_, CyrusBeck>) -> Vec<Mark> {
    let mut marks = edge_marks(step);
    marks.extend(interval(step.state, step.event).marks(&step.input.segment));
    marks
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
            .sym("n·D = n·(P₂ − E) − n·(P₁ − E) = ")
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
        .sym("n·D = 0,  n·(P₁ − E) = ")
        .num(d1)
        .sym(relation))
}

/// `n·(P₁ − E) = 2 · (−3 − 0) + (−1) · (1 − 2) = −5`.
fn distance_formula(normal: [f64; 2], p: Point, origin: Point, d: f64) -> Formula {
    let terms = [
        (normal[0], p.x(), origin.x()),
        (normal[1], p.y(), origin.y()),
    ];
    let mut formula = Formula::default().sym("n·(P₁ − E) = ");
    let terms = terms.into_iter().filter(|&(n, ..)| n != 0.0);
    for (i, (n, a, o)) in terms.enumerate() {
        formula = if i == 0 {
            formula.num(n)
        } else {
            formula.sym(" + ").operand(n)
        };
        formula = formula.sym(" · (").num(a).sym(" − ").operand(o).sym(")");
    }
    formula.equals(d)
}

/// `t = −n·(P₁ − E) / n·D = 9 / 27 = 1/3`, and what it does to its bound.
fn bound_caption(
    key: &'static str,
    edge_idx: usize,
    before: &State,
    side: Side,
    [t, bound]: [f64; 2],
) -> Caption {
    let caption = edge_caption(key, edge_idx);
    let Some(row) = before.rows.get(edge_idx) else {
        return caption;
    };
    let quotient = ratio(row, t);
    caption
        .so(quotient_formula(
            "t",
            ["−n·(P₁ − E)", "n·D"].map(|symbol| Formula::default().sym(symbol)),
            quotient,
        ))
        .so(interval(before, None)
            .shown
            .bound_formula(side, t, quotient, bound))
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
        return stays_caption(end, at);
    };
    let caption = Caption::new(
        Message::new("cb-put")
            .with("end", end_name(end))
            .with("t", interval(before, None).shown.written(t))
            .with("edge", edge_name(edge_idx)),
    );
    let Some(row) = before.rows.get(edge_idx) else {
        return caption;
    };
    put_formulas(at, row, before, input)
        .into_iter()
        .fold(caption, Caption::so)
}

/// How an end came to its place: a touched vertex is taken as it is; along an axis one coordinate is computed, else
/// both.
fn put_formulas(
    at: Point,
    row: &Row,
    before: &State,
    Input { clip, segment }: &Input,
) -> Vec<Formula> {
    let is_touch = before.interval[0] == before.interval[1] && clip.vertices().contains(&at);
    match fixed(row.normal, row.origin) {
        Some((axis, _)) if is_touch => taken(axis, at),
        Some((axis, c)) => upright(segment, axis, c, at),
        None if is_touch => vec![Formula::default().point(at.to_array())],
        None => vec![oblique("P", [segment.p1, segment.p2], [row.d1, row.d2], at)],
    }
}
