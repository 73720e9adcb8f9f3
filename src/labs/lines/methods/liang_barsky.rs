//! Liang–Barsky, shown.

use crate::{
    algo::{
        line::faulty::ForgetsParallel,
        ring::Right,
        segment::{LineClip, LineRules},
    },
    labs::segments::{
        LineKeys, LineLook, LineStep, LineVariant, SeenRow,
        inequalities::{N_LINES, PARALLEL},
    },
};

use super::{
    prelude::*,
    shared::{SegmentInterval, bounded, ends, outside_marks, point, put_formulas, side, side_key},
};

const LINES: [CodeLine; N_LINES] = [
    code_line(0, "code-lb-start", "words-lb-start"),
    code_line(0, "code-lb-each", "words-lb-each"),
    code_line(1, "code-lb-parallel", "words-lb-parallel"),
    code_line(1, "code-lb-enter", "words-lb-enter"),
    code_line(1, "code-lb-leave", "words-lb-leave"),
    code_line(1, "code-lb-empty", "words-lb-empty"),
    code_line(0, "code-lb-accept", "words-lb-accept"),
];

impl<L: LineRules + LineVariant<2, Window>> LineTelling for LineClip<2, Window, L> {
    fn input(scene: &Scene, segment: Segment) -> WindowInput {
        scene.with(segment)
    }

    fn cuts(event: &Self::Event, _: &Segment) -> Option<(End, f64)> {
        bounded(event)
    }
}

impl LineVariant<2, Window> for Right {
    const ID: &'static str = "liang-barsky";
    const NAME_KEY: &'static str = "alg-liang-barsky";
    const CODE: &'static [CodeLine] = &LINES;
}

mistakes! { LineVariant<2, Window>:
    ForgetsParallel {
        "faulty-parallel", "alg-faulty-parallel", "faulty-parallel-differs";
        CODE = LINES but PARALLEL: "code-faulty-parallel" "words-faulty-parallel";
    }
}

impl LineLook<2> for Window {
    type Scenery = ();

    const SOURCE: &'static str = "Liang & Barsky, 1984";
    const KEYS: LineKeys = LineKeys {
        opening: "line-opening",
        delta: "lb-delta",
        row: ["lb-row"; 3],
        parallel: ["lb-parallel-inside", "lb-parallel-outside"],
        enter: ["lb-enter", "lb-enter-idle"],
        leave: ["lb-leave", "lb-leave-idle"],
        put: "lb-put",
        one_point: ["line-touch", "line-point"],
        reject: "lb-reject",
    };
    const WATCHED: &'static [&'static str] = &["Δx", "Δy", "P₁′", "P₂′"];
    const SYMBOLS: [&'static str; 2] = ["u", "r"];
    const HEADER: [&'static str; 2] = ["p", "q"];
    const QUOTIENT: [&'static [&'static str]; 2] = [&["q"], &["p"]];
    const SIGN: f64 = 1.0;
    const PARALLEL: &'static str = "p = 0,  q = ";
    const ROWS_VIEW: &'static str = "pqr";
    const PLANES: &'static str = "table-edge";
    const NOTES: [&'static str; 2] = ["lb-note-enter", "lb-note-leave"];
    const WATCHES: [bool; 2] = [true; 2];
    const STARTS_WHOLE: bool = true;

    fn plane(edge: Edge, _: Option<&()>) -> Named {
        side(edge)
    }

    fn plane_in_table(edge: Edge, _: Option<&()>) -> Option<Value> {
        Some(Value::Term(side_key(edge)))
    }

    fn numbers(&self, _: &[[f64; 2]; 2], row: &SeenRow<2, Self>) -> [f64; 2] {
        [row.numbers.p, row.numbers.q]
    }

    /// u · p ≤ q says that P(u) is inside the side.
    fn meaning(edge: Edge) -> Option<[String; 2]> {
        let [p, [a, b]] = meaning(edge);
        Some([p.concat(), format!("{a} − {b}")])
    }

    fn row_formulas(&self, ends: &[[f64; 2]; 2], row: &SeenRow<2, Self>) -> Vec<Formula> {
        let edge = row.plane;
        let [p, [a, b]] = meaning(edge);
        let (from, border) = (along(point(ends[0]), edge.axis())[0], self.border(edge));
        let [first, second] = if edge.is_max() {
            [border, from]
        } else {
            [from, border]
        };
        let of_p = sym(format!("p = {}", p.concat()));
        let of_q = sym(format!("q = {a} − {b} = "));
        let of_q = of_q.num(first).sym(" − ").operand(second);
        vec![of_p.equals(row.numbers.p), of_q.equals(row.numbers.q)]
    }

    fn put_formulas(
        shown: &LineStep<'_, 2, Self>,
        _: End,
        edge: Edge,
        at: [f64; 2],
    ) -> Vec<Formula> {
        let WindowInput { window, segment } = shown.input;
        let [enters, leaves] = shown.set_by;
        let is_one = shown.bounds[0] == shown.bounds[1];
        let sides = enters.zip(leaves).filter(|_| is_one);
        put_formulas(segment, window, edge, point(at), sides.map(Into::into))
    }

    fn border(&self, edge: Edge, _: Option<&()>) -> Value {
        border_equation(self, edge).into()
    }

    /// Where the segment is parallel to two sides, what is done then.
    fn other_notes(shown: &LineStep<'_, 2, Self>) -> Vec<TableNote> {
        let Segment { p1, p2 } = shown.input.segment;
        let p = shown.in_hand().and_then(|edge| shown.row_of(edge));
        let note = TableNote {
            text: Message::new("lb-note-parallel"),
            applies: p.is_some_and(|row| row.p() == 0.0),
        };
        let is_upright = p1.x() == p2.x() || p1.y() == p2.y();
        is_upright.then_some(note).into_iter().collect()
    }

    fn quotient_header() -> Formula {
        sym("r = ").over(sym("q"), sym("p"))
    }

    fn drawing(shown: &LineStep<'_, 2, Self>, _: Option<&()>) -> Vec<View> {
        let WindowInput { window, segment } = shown.input;
        let mut marks = vec![Mark::new(Role::Faint, Shape::Line(ends(*segment)))];
        if let Some(edge) = shown.in_hand() {
            marks.extend(outside_marks(window, edge));
        }
        let interval = SegmentInterval {
            shown: shown.interval(None),
            crossing_symbol: Self::SYMBOLS[1],
            verdict: shown.verdict,
            goes_on: true,
            vector: None,
        };
        marks.extend(interval.marks(segment));
        let changed = shown.delta.filter(|_| shown.rows.is_empty());
        marks.extend(changed.into_iter().flat_map(|by| changes(segment, by)));
        vec![View::plane(marks)]
    }
}

/// By how much x and y change along the segment.
fn changes(segment: &Segment, [dx, dy]: [f64; 2]) -> impl Iterator<Item = Mark> {
    let [x1, y1, x2, y2] = segment.to_array();
    let corner = [x2, y1];
    let legs = [
        ("Δx", dx, [[x1, y1], corner]),
        ("Δy", dy, [corner, [x2, y2]]),
    ];
    legs.into_iter()
        .filter(|(_, by, _)| *by != 0.0)
        .map(|(of, by, ends)| {
            let leg = Mark::new(Role::Signal, Shape::Segment(ends));
            leg.labelled(sym(of).equals(by)).strong()
        })
}

const fn meaning(edge: Edge) -> [[&'static str; 2]; 2] {
    match edge {
        Edge::Left => [["−", "Δx"], ["x₁", "x_min"]],
        Edge::Right => [["", "Δx"], ["x_max", "x₁"]],
        Edge::Bottom => [["−", "Δy"], ["y₁", "y_min"]],
        Edge::Top => [["", "Δy"], ["y_max", "y₁"]],
    }
}
