//! The crossings that brute force computes, and what they were good for.

use crate::{
    algo::line::{BruteForce, BruteForceEvent as Event, Ratio},
    figure::{LineTick, NumberLine, Side},
    labs::{interval::value_of, words::end_symbol},
};

use super::{prelude::*, shared::side_key};

#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Fate {
    Parallel,
    /// It was not needed, or not in the end.
    InVain,
    Replaces(End),
}

#[derive(Default)]
pub struct Shown {
    pub crossings: [Option<(Point, Ratio)>; 4],
    /// What became of them, by side, once it is decided.
    pub fates: [Option<Fate>; 4],
    pub is_visible: Option<bool>,
}

impl Shown {
    pub fn of(step: &Step<'_, BruteForce>) -> Self {
        let mut shown = Self::default();
        for event in step.past {
            shown.see(*event);
        }
        shown
    }

    fn see(&mut self, event: Event) {
        match event {
            Event::Intersect { edge, u, at } => self.crossings[edge as usize] = Some((at, u)),
            Event::Parallel { edge } => self.fates[edge as usize] = Some(Fate::Parallel),
            Event::Keep { edge } => {
                self.fates[edge as usize].get_or_insert(Fate::InVain);
            }
            Event::Cut { end, edge, .. } => {
                // The crossing that this end stood on until now is of no use after all.
                for fate in self.fates.iter_mut().flatten() {
                    if *fate == Fate::Replaces(end) {
                        *fate = Fate::InVain;
                    }
                }
                self.fates[edge as usize] = Some(Fate::Replaces(end));
            }
            Event::Accept { .. } => self.is_visible = Some(true),
            Event::Reject { .. } => self.is_visible = Some(false),
        }
    }
}

pub fn crossing_values(shown: &Shown, edge: Edge) -> [Option<Value>; 2] {
    let crossing = shown.crossings[edge as usize];
    [
        crossing.map(|(_, u)| value_of(u)),
        crossing.map(|(at, _)| Value::Point(at.to_array())),
    ]
}

/// Before the first crossing: the four tests that make a window, on both ends. What fails stands out.
pub fn tests_table(WindowInput { window, segment }: &WindowInput) -> Table {
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
            sym(end_symbol(End::P1)),
            sym(end_symbol(End::P2)),
        ],
        rows: Edge::ALL.map(row).to_vec(),
        notes: vec![TableNote {
            text: Message::new("bf-note-tests"),
            applies: true,
        }],
    }
}

pub fn crossing_table(step: &Step<'_, BruteForce>) -> Table {
    let (shown, event) = (Shown::of(step), step.event());
    let current = current_edge(event);
    let of_edge = |edge: Edge| {
        let fate = shown.fates[edge as usize];
        let role = match fate {
            _ if current == Some(edge) => Role::Signal,
            Some(Fate::InVain | Fate::Parallel) => Role::Soft,
            Some(Fate::Replaces(_)) | None => Role::Ink,
        };
        let found_now = matches!(event, Some(Event::Intersect { .. }));
        let found = if found_now || role == Role::Soft {
            role
        } else {
            Role::Ink
        };
        let mut cells: Vec<Cell> = crossing_values(&shown, edge)
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
            sym("t"),
            sym("P(t)"),
            Formula::default(),
        ],
        rows: Edge::ALL.map(of_edge).to_vec(),
        notes: Vec::new(),
    }
}

/// Where the crossings lie along the segment, and what of it is left.
pub fn axis(step: &Step<'_, BruteForce>) -> NumberLine {
    let shown = Shown::of(step);
    let current = current_edge(step.event()).filter(|_| shown.is_visible.is_none());
    let [from, to] = End::BOTH.map(|end| end.of(&step.input.segment));
    let mut bounds = [0.0, 1.0].map(|num| Ratio { num, den: 1.0 });
    let mut ticks = Vec::new();
    for edge in Edge::ALL {
        let Some((_, u)) = shown.crossings[edge as usize] else {
            continue;
        };
        let fate = shown.fates[edge as usize];
        if let Some(Fate::Replaces(end)) = fate {
            bounds[end.idx()] = u;
        }
        let [[a, _], [b, _]] = [from, to].map(|at| along(at, edge.axis()));
        let inwards = if edge.is_max() { a - b } else { b - a };
        ticks.push(LineTick {
            u: u.num / u.den,
            value: Formula::default().ratio(u.num, u.den),
            side: Side::of(-inwards),
            holds: matches!(fate, Some(Fate::Replaces(_))),
            current: current == Some(edge),
            name: Value::Term(side_key(edge)),
            link: Some(edge_link(edge)),
        });
    }
    NumberLine {
        symbol: "t",
        ends: End::BOTH.map(end_name),
        shown: NumberLine::showing(ticks.iter().map(|tick| tick.u)),
        interval: bounds.map(|bound| bound.num / bound.den),
        values: bounds.map(|bound| Formula::default().ratio(bound.num, bound.den)),
        empty: shown.is_visible == Some(false),
        ticks,
        kept: kept(bounds).filter(|_| shown.is_visible == Some(true)),
    }
}

/// Into how few equal parts the segment is divided by what bounds the part that is left, and how much of it that part is.
fn kept([low, high]: [Ratio; 2]) -> Option<(usize, Value)> {
    const MOST: u8 = 16;
    let divides = |n: u8| move |at: &Ratio| at.num * f64::from(n) % at.den == 0.0;
    let n = (2..=MOST).find(|&n| [low, high].iter().all(divides(n)))?;
    let part = Value::Ratio {
        num: high.num * low.den - low.num * high.den,
        den: low.den * high.den,
    };
    let is_cut = low.num != 0.0 || high.num != high.den;
    is_cut.then(|| (n.into(), Message::new("bf-kept").with("part", part).into()))
}

pub fn fate_word(fate: Fate) -> Value {
    match fate {
        Fate::Parallel => Value::Term("verdict-parallel"),
        Fate::InVain => Value::Term("bf-in-vain"),
        Fate::Replaces(end) => name(format!("→ {}′", end_symbol(end))),
    }
}

pub const fn current_edge(event: Option<Event>) -> Option<Edge> {
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
