//! Nicholl–Lee–Nicholl, shown.

use crate::{
    algo::line::{
        CornerLine, End, NichollLeeNicholl, NichollLeeNichollEvent as Event,
        NichollLeeNichollState as State, Question, Turn, WindowInput, WindowRegion,
    },
    figure::{
        Body, Caption, Cell, Mark, Role, Shape, Table, TableNote, TableRow, Tick, View, Watch,
        WatchRow, WatchSection,
    },
    geom::{Axis, Edge, Point, Segment, Window},
    labs::{
        CodeLine, Demo, Step, code_line,
        lines::{LineDemo, Scene, demo::Settles},
    },
    text::{Formula, Message, Value},
};

use super::sectors;
use super::shared::{
    accepted, border_mark, crossing_mark, ends_rows, opening, put_formulas, region_key,
    segment_marks,
};
use crate::labs::words::{
    border_equation, edge_name, name, point_formula, position_formula, subscript,
};
use crate::labs::words::{end_link, end_name};

/// The view of the corners' lines that have been asked.
const CORNERS_VIEW: &str = "corners";

const REGIONS: usize = 0;
const SHARED: usize = 1;
const ENTERS: usize = 2;
const MEETS: usize = 3;
const LEAVES: usize = 4;
const CUT: usize = 5;

impl LineDemo for NichollLeeNicholl {
    fn input(scene: &Scene, segment: Segment) -> WindowInput {
        WindowInput {
            window: scene.window,
            segment,
        }
    }

    fn settles(event: &Event, _: &WindowInput) -> Settles {
        match *event {
            Event::Region { .. } | Event::Side { .. } | Event::Sector { .. } => Settles::Asked,
            Event::Cut { .. } | Event::Accept { .. } => Settles::Nothing,
            Event::Reject { edge, corner: None } => Settles::Rejects(edge as usize),
            Event::Reject {
                edge,
                corner: Some(_),
            } => Settles::Rejected(edge as usize),
        }
    }
}

impl Demo for NichollLeeNicholl {
    const ID: &'static str = "nicholl-lee-nicholl";
    const NAME_KEY: &'static str = "alg-nicholl-lee-nicholl";
    const SOURCE: &'static str = "Nicholl, Lee & Nicholl, 1987";
    const CODE: &'static [CodeLine] = &[
        code_line(0, "code-nln-regions", "words-nln-regions"),
        code_line(0, "code-nln-shared", "words-nln-shared"),
        code_line(0, "code-nln-enters", "words-nln-enters"),
        code_line(0, "code-nln-meets", "words-nln-meets"),
        code_line(0, "code-nln-leaves", "words-nln-leaves"),
        code_line(0, "code-nln-cut", "words-nln-cut"),
    ];

    fn tick(event: &Event) -> Tick {
        match event {
            Event::Region { .. } | Event::Side { .. } => Tick::Test,
            Event::Sector { .. } => Tick::Phase,
            Event::Cut { .. } => Tick::Cut,
            Event::Accept { .. } => Tick::Accept,
            Event::Reject { .. } => Tick::Reject,
        }
    }

    fn code_line(event: &Event, _: &State) -> usize {
        match event {
            Event::Region { .. } => REGIONS,
            Event::Reject { corner: None, .. } => SHARED,
            Event::Reject { .. } => MEETS,
            Event::Side { question, .. } => match question {
                Question::Enters => ENTERS,
                Question::Meets => MEETS,
                Question::Leaves => LEAVES,
            },
            Event::Sector { .. } => LEAVES,
            Event::Cut { .. } | Event::Accept { .. } => CUT,
        }
    }

    fn opening(input: &WindowInput) -> Caption {
        opening(&input.segment)
    }

    fn caption(event: &Event, before: &State, input: &WindowInput) -> Caption {
        let WindowInput { window, segment } = input;
        match *event {
            Event::Region { end, region } => region_caption(end, region, input),
            Event::Side { question, line } => side_caption(question, &line, window),
            Event::Sector { enters, leaves } => sector_caption(enters, leaves, segment),
            Event::Cut { end, edge, to, .. } => cut_caption(end, edge, to, before, input),
            Event::Accept { segment: visible } => accepted(&input.segment, visible),
            Event::Reject { edge, corner: None } => {
                Caption::new(Message::new("line-reject-edge").with("edge", edge_name(edge)))
            }
            Event::Reject {
                edge,
                corner: Some(corner),
            } => Caption::new(
                Message::new("nln-miss")
                    .with("edge", edge_name(edge))
                    .with("corner", corner_formula(window, corner)),
            ),
        }
    }

    fn views(step: &Step<'_, Self>) -> Vec<View> {
        vec![
            View::plane(marks(step)),
            View::new(CORNERS_VIEW, Body::Table(corner_table(step))),
        ]
    }

    fn watch(step: &Step<'_, Self>) -> Watch {
        let state = step.state;
        let mut rows = ends_rows(state.ends);
        for end in End::BOTH {
            let key = ["watch-region-1", "watch-region-2"][end.idx()];
            let region = state.regions[end.idx()].map(|region| Value::Term(key_of(region)));
            rows.push(WatchRow::new(Value::Term(key), region).linked(end_link(end)));
        }
        let side = |known: Option<Option<Edge>>| {
            known.map(|edge| edge.map_or_else(|| name("–"), edge_name))
        };
        let [enters, leaves] = [0, 1].map(|i| side(state.sector.map(|sector| sector[i])));
        rows.push(WatchRow::new(Value::Term("watch-enters"), enters));
        rows.push(WatchRow::new(Value::Term("watch-leaves"), leaves));
        rows.push(WatchRow::new(
            Value::Term("watch-crossings"),
            Some(Value::Count(state.n_cuts)),
        ));
        let asked = state.lines.iter().flatten().map(|(question, line)| {
            let cells = line.products.map(|p| Some(Value::Number(p))).to_vec();
            WatchRow::table(Value::Term(question_key(*question)), cells)
                .noted(Value::Term(turn_key(line.turn)))
        });
        let table = WatchSection::table(vec!["a₁·b₂", "b₁·a₂"], asked.collect());
        vec![WatchSection::list(rows), table.seen_in(CORNERS_VIEW)]
    }
}

/// What each corner's line was asked, and the two products that answer.
fn corner_table(step: &Step<'_, NichollLeeNicholl>) -> Table {
    let n_asked = step.state.lines.iter().flatten().count();
    let is_asking = matches!(step.event, Some(Event::Side { .. }));
    let rows = step.state.lines.iter().flatten().enumerate();
    let rows = rows.map(|(i, (question, line))| {
        let is_current = is_asking && i + 1 == n_asked;
        let role = if is_current { Role::Signal } else { Role::Ink };
        let [p, q] = line.products.map(Value::Number);
        let cells = [
            Value::Term(question_key(*question)),
            p,
            name(relation(line.turn)),
            q,
            Value::Term(turn_key(line.turn)),
        ];
        TableRow {
            name: corner_name(&step.input.window, line.corner),
            cells: cells.map(|value| Cell::new(role, Some(value))).to_vec(),
            is_current,
            link: None,
        }
    });
    let symbol = |symbol: &'static str| Formula::default().sym(symbol);
    Table {
        header: vec![
            Formula::default().term("table-corner"),
            Formula::default(),
            symbol("a₁·b₂"),
            Formula::default(),
            symbol("b₁·a₂"),
            symbol("P₂"),
        ],
        rows: rows.collect(),
        notes: vec![TableNote {
            text: Message::new("nln-note-products"),
            applies: is_asking,
        }],
    }
}

/// Between `a₁·b₂` and `b₁·a₂`.
const fn relation(turn: Turn) -> &'static str {
    match turn {
        Turn::Left => "<",
        Turn::Through => "=",
        Turn::Right => ">",
    }
}

/// The drawing.
fn marks(step: &Step<'_, NichollLeeNicholl>) -> Vec<Mark> {
    let WindowInput { window, segment } = step.input;
    let state = step.state;
    let p1 = segment.p1;
    let mut marks: Vec<Mark> = Vec::new();
    if state.regions[0].is_some() {
        marks.extend(sectors::marks(p1, window));
    }
    let current = match step.event {
        Some(Event::Side { line, .. }) => Some(line.corner),
        Some(Event::Reject { corner, .. }) => corner,
        Some(
            Event::Region { .. } | Event::Sector { .. } | Event::Cut { .. } | Event::Accept { .. },
        )
        | None => None,
    };
    let asked = state.lines.iter().flatten().map(|(_, line)| line.corner);
    let asked: Vec<Point> = asked.filter(|&corner| corner != p1).collect();
    for corner in window.corners() {
        let role = if current == Some(corner) {
            Role::Signal
        } else {
            Role::Soft
        };
        if asked.contains(&corner) {
            marks.push(ray(role, p1, corner));
        }
        let label = corner_name(window, corner);
        marks.push(Mark::new(role, Shape::Dot(corner.to_array())).labelled(label));
    }
    if let Some(Event::Cut { edge, .. }) = step.event {
        marks.push(border_mark(window, edge));
    }
    marks.extend(segment_marks(segment, state.ends, state.verdict));
    match step.event {
        Some(Event::Region { end, .. }) => {
            let at = end.of(segment).to_array();
            marks.push(Mark::new(Role::Signal, Shape::Ring(at)).linked(end_link(end)));
        }
        Some(Event::Cut { end, u, to, .. }) => {
            marks.push(crossing_mark(to, "t", u).linked(end_link(end)));
        }
        Some(
            Event::Side { .. } | Event::Sector { .. } | Event::Accept { .. } | Event::Reject { .. },
        )
        | None => {}
    }
    marks
}

/// `C₁`, `C₂`, …: the window's corners are numbered counter-clockwise from the lower left.
fn corner_symbol(window: &Window, corner: Point) -> String {
    let found = window.corners().iter().position(|&c| c == corner);
    found.map_or_else(|| "C".to_owned(), |i| format!("C{}", subscript(i + 1)))
}

fn corner_name(window: &Window, corner: Point) -> Value {
    name(corner_symbol(window, corner))
}

/// `C₄ = (−1, 1)`, in a sentence.
fn corner_formula(window: &Window, corner: Point) -> Formula {
    let formula = Formula::default().sym(corner_symbol(window, corner));
    formula.sym(" = ").point(corner.to_array())
}

fn ray(role: Role, from: Point, through: Point) -> Mark {
    Mark::new(role, Shape::Ray([from.to_array(), through.to_array()]))
}

/// Catalogue key of a region's name.
fn key_of(region: WindowRegion) -> &'static str {
    region_key(|edge| region.edges().any(|e| e == edge))
}

const fn question_key(question: Question) -> &'static str {
    match question {
        Question::Enters => "nln-question-enters",
        Question::Meets => "nln-question-meets",
        Question::Leaves => "nln-question-leaves",
    }
}

const fn turn_key(turn: Turn) -> &'static str {
    match turn {
        Turn::Left => "turn-left",
        Turn::Through => "turn-through",
        Turn::Right => "turn-right",
    }
}

/// "P₁ is below left", and what says so: `x = −2 < −1`.
fn region_caption(end: End, region: WindowRegion, input: &WindowInput) -> Caption {
    let at = end.of(&input.segment);
    let message = Message::new("nln-region")
        .with("end", end_name(end))
        .with("region", Value::Term(key_of(region)));
    let beyond = |edge| region.edges().any(|e| e == edge);
    [Axis::X, Axis::Y]
        .into_iter()
        .fold(Caption::new(message), |caption, axis| {
            caption.so(position_formula(axis, at, &input.window, beyond))
        })
}

fn side_caption(question: Question, line: &CornerLine, window: &Window) -> Caption {
    let key = match (question, line.turn) {
        (_, Turn::Through) => "nln-side-through",
        (Question::Enters, _) => "nln-side-enters",
        (Question::Meets, _) => "nln-side-meets",
        (Question::Leaves, _) => "nln-side-leaves",
    };
    let [p, q] = line.products;
    let first = line.first.unwrap_or(line.edges[0]);
    Caption::new(
        Message::new(key)
            .with("corner", corner_formula(window, line.corner))
            .with("turn", Value::Term(turn_key(line.turn)))
            .with("first", edge_name(first)),
    )
    .so(Formula::default()
        .sym("a₁·b₂ = ")
        .num(p)
        .sym(format!(" {} b₁·a₂ = ", relation(line.turn)))
        .num(q))
}

fn cut_caption(
    end: End,
    edge: Edge,
    to: Point,
    before: &State,
    WindowInput { window, segment }: &WindowInput,
) -> Caption {
    let message = Message::new("cs-cut")
        .with("end", end_name(end))
        .with("border", border_equation(window, edge));
    let sides = before
        .sector
        .and_then(|[enters, leaves]| Some([enters?, leaves?]));
    put_formulas(segment, window, edge, to, sides)
        .into_iter()
        .fold(Caption::new(message), Caption::so)
}

fn sector_caption(enters: Option<Edge>, leaves: Option<Edge>, segment: &Segment) -> Caption {
    let message = match (enters, leaves) {
        (None, None) => {
            return Caption::new(Message::new("nln-sector-inside"))
                .so(point_formula("P₁", segment.p1))
                .so(point_formula("P₂", segment.p2));
        }
        (Some(edge), None) => Message::new("nln-sector-enters").with("enters", edge_name(edge)),
        (None, Some(edge)) => Message::new("nln-sector-leaves").with("leaves", edge_name(edge)),
        (Some(enters), Some(leaves)) => Message::new("nln-sector-both")
            .with("enters", edge_name(enters))
            .with("leaves", edge_name(leaves)),
    };
    Caption::new(message)
}
