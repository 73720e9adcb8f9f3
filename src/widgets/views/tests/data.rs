//! What the prototypes C1 to C4 show.

pub mod frustum;
pub mod polygons;
pub mod surfaces;

use crate::{
    figure::{
        ArrowKind, BitRow, Bits, Cell, CellStage, ClipperBox, ClipperRow, Fate, Gauge, Gauges,
        Graph, GraphArrow, GraphNode, ItemMarker, LineTick, ListColumn, ListLink, ListRow, Lists,
        Mark, Measured, Multiples, NodeStage, NumberLine, Places, Product, Products, Ribbon,
        RibbonStage, Role, Shape, Side, SmallDrawing, Story, StoryCard, StoryFate, Table,
        TableNote, TableRow, Tiles, Traveller, Vector,
    },
    text::{Formula, Message, Value},
};

pub fn name(symbol: &str) -> Value {
    Value::Name(symbol.to_owned())
}

fn code(of: &str, bits: [u8; 4], role: Role) -> BitRow {
    BitRow {
        name: name(of),
        bits: bits.map(|bit| bit == 1).to_vec(),
        role,
        link: None,
    }
}

pub fn and_of_codes() -> Bits {
    let sides = ["side-top", "side-bottom", "side-right", "side-left"];
    let first = code("P₁", [1, 0, 0, 1], Role::Ink);
    Bits {
        columns: sides.map(Value::Term).to_vec(),
        links: Vec::new(),
        rows: vec![first, code("P₂", [1, 0, 0, 0], Role::Ink)],
        result: Some(code("AND", [1, 0, 0, 0], Role::Signal)),
        deciding: Some(0),
        note: Some(Message::new("cs-note-and")),
    }
}

/// The second code has just been found.
pub fn codes_found() -> Bits {
    let mut shown = and_of_codes();
    shown.rows[1].role = Role::Signal;
    Bits {
        result: None,
        deciding: None,
        note: None,
        ..shown
    }
}

fn sym(symbol: &'static str) -> Formula {
    Formula::default().sym(symbol)
}

fn number(role: Role, [num, den]: [f64; 2]) -> Cell {
    Cell::new(role, Some(Value::Ratio { num, den }))
}

fn row(edge: &'static str, [p, q]: [f64; 2], bounds: [[f64; 2]; 2], new: usize) -> TableRow {
    let does = if p < 0.0 { "enters" } else { "leaves" };
    let bound = |nth: usize| {
        let is_new = nth == new;
        let cell = number(if is_new { Role::Ink } else { Role::Soft }, bounds[nth]);
        if is_new { cell.strong() } else { cell }
    };
    TableRow {
        name: Value::Term(edge),
        cells: vec![
            number(Role::Ink, [p, 1.0]),
            number(Role::Ink, [q, 1.0]),
            number(Role::Ink, [q, p]),
            Cell::new(Role::Soft, Some(name(does))),
            bound(0),
            bound(1),
        ],
        is_current: false,
        link: None,
    }
}

pub fn empty_interval() -> Table {
    let mut top = row("side-top", [4.0, 1.0], [[3.0, 8.0], [1.0, 4.0]], 2);
    top.is_current = true;
    top.cells[2].role = Role::Signal;
    top.cells[5].role = Role::Signal;
    let mut cells = vec![Cell::new(Role::Soft, None::<Value>); 4];
    cells.extend([0.0, 1.0].map(|u| number(Role::Ink, [u, 1.0])));
    let start = TableRow {
        name: name("start"),
        cells,
        ..row("side-top", [4.0, 1.0], [[3.0, 8.0], [1.0, 4.0]], 2)
    };
    let note = |applies| TableNote {
        text: Message::new("cs-note-and"),
        applies,
    };
    let mut header = ["edge", "p", "q", "r", "", "u_min", "u_max"].map(sym);
    header[3] = sym("r = ").over(sym("q"), sym("p"));
    header[4] = Formula::default();
    Table {
        header: header.to_vec(),
        rows: vec![
            start,
            row("side-left", [-8.0, -3.0], [[3.0, 8.0], [1.0, 1.0]], 0),
            row("side-right", [8.0, 6.0], [[3.0, 8.0], [3.0, 4.0]], 1),
            row("side-bottom", [-4.0, 1.0], [[3.0, 8.0], [3.0, 4.0]], 2),
            top,
        ],
        notes: vec![note(false), note(true)],
    }
}

pub fn many_edges(n: usize, current: usize) -> Table {
    let rows = (0..n).map(|i| {
        let bounds = [[3.0, 8.0], [1.0, 1.0]];
        let mut row = row("side-left", [-8.0, i as f64 - 3.0], bounds, 0);
        row.name = name(&format!("e{i}"));
        row.is_current = i == current;
        row
    });
    Table {
        rows: rows.collect(),
        ..empty_interval()
    }
}

fn vector(symbol: &str, to: [f64; 2], role: Role) -> Vector {
    Vector {
        name: name(symbol),
        to,
        role,
    }
}

fn product(of: Vector, decision: Message, arithmetic: &'static str, is_current: bool) -> Product {
    Product {
        onto: vector("n", [3.0, 2.0], Role::Signal),
        of,
        decision,
        arithmetic: sym(arithmetic),
        is_current,
    }
}

pub fn normal() -> Products {
    let d = vector("D", [11.0, -3.0], Role::Accent);
    let enters = Message::new("cb-sign-enters").with("product", name("n·D"));
    let outside = Message::new("cb-sign-outside").with("end", name("P₁"));
    let outside = outside.with("product", name("n·(P₁ − E)"));
    let e = vector("P₁ − E", [-3.0, 0.0], Role::Ink);
    let outside_span = ([-9.0, 0.0], name("9"), Role::Signal);
    let whole_span = ([-9.0, 18.0], name("n·D = 27"), Role::Accent);
    Products {
        products: vec![
            product(d, enters, "3·11 + 2·(−3) = 27", true),
            product(e, outside, "3·(−3) + 2·0 = −9", false),
        ],
        measured: Some(Measured {
            title: Message::new("cb-measured").with("normal", name("n")),
            zero: name("edge"),
            ends: [(name("P₁"), -9.0), (name("P₂"), 18.0)],
            spans: vec![outside_span, whole_span],
        }),
    }
}

pub fn parallel() -> Products {
    let mut shown = normal();
    shown.products[0].of = vector("D", [-20.0, 30.0], Role::Accent);
    shown.products[1].of = vector("P₁ − E", [0.1, 0.1], Role::Ink);
    if let Some(measured) = &mut shown.measured {
        measured.ends = [(name("P₁"), 0.5), (name("P₂"), 0.5)];
        measured.spans = vec![([0.0, 0.5], name("1/2"), Role::Signal)];
    }
    shown
}

/// The axis of C2 with these bounds, the crossing of this number being the step's.
pub fn axis(interval: [f64; 2], current: usize) -> NumberLine {
    let tick = |u, side, holds, nth: usize, side_name| LineTick {
        u,
        value: Formula::default().num(u),
        side,
        holds,
        current: nth == current,
        name: Value::Term(side_name),
        link: None,
    };
    let [low, high] = interval;
    let mut ticks = vec![
        tick(low, Side::Entering, true, 0, "side-left"),
        tick(high, Side::Leaving, true, 1, "side-top"),
        tick(0.75, Side::Leaving, false, 3, "side-right"),
        tick(-0.25, Side::Entering, false, 4, "side-bottom"),
    ];
    if interval == [0.0, 1.0] {
        ticks.clear();
    }
    NumberLine {
        symbol: "u",
        ends: [name("P₁"), name("P₂")],
        shown: NumberLine::showing(ticks.iter().map(|tick| tick.u)),
        interval,
        values: interval.map(|u| Formula::default().num(u)),
        empty: low > high,
        ticks,
        kept: None,
    }
}
