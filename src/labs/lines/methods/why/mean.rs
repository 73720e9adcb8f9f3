//! Why a crossing is a weighted mean, shown: the triangle up to an edge's line, in the triangle of the whole segment.
//!
//! ```text
//!                      ╱P₂
//!                  ╱    │
//!        ┊     ╱        │ Δy
//!        ┊X╱            │
//!       ╱┊              │
//!   P₁───┴──────────────┘
//!     w₁ ┊      w₂
//! ```

use crate::{
    algo::why::{Mean, MeanFact as Fact, Shown, Why},
    labs::{
        segments::ENDS,
        why::{Picture, fact, mark, segment},
    },
};

use super::super::{
    prelude::*,
    shared::{border, segment_marks, side},
};

const NAMES: [(&str, Fact); 6] = [
    ("w₁", Fact::First),
    ("w₂", Fact::Second),
    ("t", Fact::Part),
    ("rise", Fact::Rise),
    ("mean", Fact::Mean),
    ("given", Fact::Given),
];

impl Telling for Why<Mean> {
    type Scenery = ();

    const ID: &'static str = "why-mean";
    const NAME_KEY: &'static str = "why-mean";
    const SOURCE: &'static str = "Euclid, VI.4";
    const IS_PROOF: bool = true;
    const CODE: &'static [CodeLine] = &[
        code_line(0, "why-code-weights", "why-words-weights"),
        code_line(0, "why-code-part", "why-words-part"),
        code_line(0, "why-code-rise", "why-words-rise"),
        code_line(0, "why-code-mean", "why-words-mean"),
    ];
    const WATCH: &'static [Watched] = &[
        Watched::Seen(&["w₁", "w₂", "t"], "why"),
        Watched::Names(&["crossing"]),
    ];
    const OPENING: Row = Row::new(Phase, 0, "why-mean-opening").so(ENDS);

    table! { |event, step|
        nothing: Shown { fact: Fact::Nothing, .. } => Row::new(Reject, 0, "why-mean-nothing").so(ENDS);
        first: Shown { fact: Fact::First, .. } => Row::new(Test, 0, "why-mean-first").so(&["w₁{=w₁}"]);
        second: Shown { fact: Fact::Second, .. } => Row::new(Test, 0, "why-mean-second").so(&["w₂{=w₂}"]);
        part: Shown { fact: Fact::Part, .. } => Row::new(Test, 1, "why-mean-part").so(&["t = {w₁ / both}{=t}"]);
        level: Shown { fact: Fact::Rise, number } if number == 0.0 =>
            Row::new(Test, 2, "why-mean-level").so(&["{t} · {(way)}{=rise}"]);
        rise: Shown { fact: Fact::Rise, .. } => Row::new(Test, 2, "why-mean-rise").so(&["{t} · {(way)}{=rise}"]);
        mean: Shown { fact: Fact::Mean, .. } =>
            Row::new(Accept, 3, "why-mean-mean").so(&["{from} + {(rise)}{=reached}", "{along} = {sum / whole}{=mean}"]);
        given: Shown { fact: Fact::Given, .. } =>
            Row::new(Accept, 3, "why-mean-given").so(&["{across} = {sum across / whole}{=given}"]);
    }

    fn named(at: &At<'_, Self>, of: &str) -> Option<Named> {
        let input = at.step.input;
        match of {
            "P₁" => return Some(input.segment.p1.to_array().into()),
            "P₂" => return Some(input.segment.p2.to_array().into()),
            _ => {}
        }
        let edge = Mean::edge(input)?;
        let seen = Seen::new(input, edge);
        let shown = |name| fact(&at.step, &NAMES, name);
        Some(match of {
            "edge" => side(edge),
            "border" => border_equation(&input.window, edge).into(),
            "across" => name(seen.symbols[0]).into(),
            "along" => name(seen.symbols[1]).into(),
            "from" => seen.ends[0][1].into(),
            "way" => seen.way().into(),
            "reached" => (seen.ends[0][1] + shown("rise")?).into(),
            "whole" => (shown("w₁")? + shown("w₂")?).into(),
            "both" => {
                let w1 = Formula::default().num(shown("w₁")?);
                w1.sym(" + ").num(shown("w₂")?).into()
            }
            "sum" => seen.sum(1, [shown("w₁")?, shown("w₂")?]).into(),
            "sum across" => seen.sum(0, [shown("w₁")?, shown("w₂")?]).into(),
            "crossing" => Named::from(seen.crossing(shown("mean")?)).labelled(name("X")),
            _ => shown(of)?.into(),
        })
    }

    fn views(at: &At<'_, Self>) -> Vec<View> {
        let input = at.step.input;
        let seen = Mean::edge(input).map(|edge| Seen::new(input, edge));
        let table = View::new("why", Body::Table(triangles(at, seen.as_ref())));
        vec![drawing(at, seen.as_ref()), table]
    }
}

/// The segment as it is seen from an edge: coordinates are across the edge and along it.
struct Seen {
    edge: Edge,
    border: f64,
    ends: [[f64; 2]; 2],
    symbols: [&'static str; 2],
}

impl Seen {
    fn new(WindowInput { window, segment }: &WindowInput, edge: Edge) -> Self {
        Self {
            edge,
            border: window.border(edge),
            ends: [segment.p1, segment.p2].map(|at| along(at, edge.axis())),
            symbols: match edge.axis() {
                Axis::X => ["x", "y"],
                Axis::Y => ["y", "x"],
            },
        }
    }

    fn way(&self) -> f64 {
        self.ends[1][1] - self.ends[0][1]
    }

    fn place(&self, across: f64, along: f64) -> [f64; 2] {
        match self.edge.axis() {
            Axis::X => [across, along],
            Axis::Y => [along, across],
        }
    }

    fn crossing(&self, along: f64) -> [f64; 2] {
        self.place(self.border, along)
    }

    /// The ends' coordinates, each times the other end's distance.
    fn sum(&self, i: usize, [w1, w2]: [f64; 2]) -> Formula {
        let terms = [(self.ends[0][i], w2), (self.ends[1][i], w1)];
        sum_of(Formula::default(), terms, times)
    }
}

fn drawing(at: &At<'_, Why<Mean>>, seen: Option<&Seen>) -> View {
    let WindowInput {
        window,
        segment: of,
    } = at.step.input;
    let ends = [of.p1, of.p2];
    let mut given = segment_marks(of, ends, None);
    let Some(seen) = seen else {
        return View::plane(given);
    };
    let equation = border_equation(window, seen.edge);
    given.push(mark(Role::Soft, border(window, seen.edge)).labelled(equation));
    let [from, to] = ends.map(Point::to_array);
    let foot = seen.crossing(seen.ends[0][1]);
    let corner = seen.place(seen.ends[1][0], seen.ends[0][1]);
    given.push(segment(Role::Faint, from, corner));
    given.push(segment(Role::Faint, corner, to).labelled(change(seen.symbols[1], seen.way())));
    let mut picture = Picture::new(&at.step, given);
    picture.once(Fact::First, Role::Ink, |role, w| {
        [segment(role, from, foot).labelled(sym("w₁").equals(w))]
    });
    picture.once(Fact::Second, Role::Ink, |role, w| {
        [segment(role, foot, corner).labelled(sym("w₂").equals(w))]
    });
    picture.once(Fact::Rise, Role::Accent, |role, rise| {
        let cross = seen.crossing(seen.ends[0][1] + rise);
        let leg = segment(role, foot, cross)
            .labelled(sym("t · ").sym(delta(seen.symbols[1])).equals(rise));
        [mark(role, Shape::Fill(vec![vec![from, foot, cross]])), leg]
    });
    picture.once(Fact::Mean, Role::Accent, |role, along| {
        let cross = mark(role, Shape::Dot(seen.crossing(along)));
        [cross.labelled(name("X")).strong()]
    });
    picture.in_scene()
}

fn delta(symbol: &str) -> String {
    format!("Δ{symbol}")
}

fn change(symbol: &str, by: f64) -> Formula {
    sym(delta(symbol)).equals(by)
}

/// The legs of both triangles, and what part the small one is of the large one.
fn triangles(at: &At<'_, Why<Mean>>, seen: Option<&Seen>) -> Table {
    let shown = |name| fact(&at.step, &NAMES, name);
    let now = at.step.event().map(|shown| shown.fact);
    let cell = |of: Fact, value: Option<f64>| {
        let role = if now == Some(of) {
            Role::Signal
        } else {
            Role::Ink
        };
        Cell::new(role, value)
    };
    let row = |of: &str, cells: [Cell; 2], is_current| TableRow {
        name: name(of),
        cells: cells.to_vec(),
        is_current,
        link: None,
    };
    let whole = shown("w₁").zip(shown("w₂")).map(|(a, b)| a + b);
    let way = seen.and_then(|seen| shown("rise").map(|_| seen.way()));
    let part = shown("rise").and(shown("t"));
    let rows = vec![
        row(
            "P₁X",
            [
                cell(Fact::First, shown("w₁")),
                cell(Fact::Rise, shown("rise")),
            ],
            false,
        ),
        row(
            "P₁P₂",
            [cell(Fact::Second, whole), cell(Fact::Rise, way)],
            false,
        ),
        row(
            "t",
            [
                cell(Fact::Part, shown("t")).strong(),
                cell(Fact::Rise, part).strong(),
            ],
            now == Some(Fact::Part),
        ),
    ];
    let header = ["why-triangle", "why-across", "why-along"];
    Table {
        header: header.map(|key| Formula::default().term(key)).to_vec(),
        rows,
        notes: Vec::new(),
    }
}
