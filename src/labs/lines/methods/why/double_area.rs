//! Why a₁·b₂ < b₁·a₂ says "to the left", shown: the four rectangles from P₁ to P₂ around a corner, and the triangle between the way over the corner and
//! the straight one.
//!
//! ```text
//!   P₁──────┬────────┐
//!   │╲ ╲    │ |b₁·a₂|│
//!   │  ╲  ╲ │        │
//!   ├───────C──╲─────┤
//!   │|a₁·b₂|│  ╲  ╲  │
//!   └───────┴────────P₂
//! ```

use crate::{
    algo::{
        line::{CornerLine, Turn},
        why::{DoubleArea, DoubleAreaFact as Fact, DoubleAreaInput, Shown, Why},
    },
    labs::{
        segments::ENDS,
        why::{Picture, fact, mark, segment},
    },
};

use super::super::{
    prelude::*,
    shared::{corner_formula, corner_name, segment_marks},
};

const NAMES: [(&str, Fact); 6] = [
    ("first", Fact::First),
    ("second", Fact::Second),
    ("ends", Fact::Ends),
    ("half", Fact::Half),
    ("triangle", Fact::Triangle),
    ("twice", Fact::Twice),
];

const FROM_CORNER: &[&str] = &[
    "{place}",
    "(a₁, b₁) = {from_corner₁}",
    "(a₂, b₂) = {from_corner₂}",
];
const TRIANGLE: &[&str] = &["{left} + {ends} − {half}{=triangle}"];
const TWICE: &[&str] = &[
    "{left} − {right} = 2 · {(triangle)}",
    "b₁·a₂ − a₁·b₂{=twice}",
];

fn turns(step: &Step<'_, Why<DoubleArea>>, to: Turn) -> bool {
    step.input.line().is_some_and(|line| line.turn == to)
}

impl Telling for Why<DoubleArea> {
    type Scenery = ();

    const ID: &'static str = "why-double-area";
    const NAME_KEY: &'static str = "why-double-area";
    const SOURCE: &'static str = "Euclid, I.43";
    const IS_PROOF: bool = true;
    const CODE: &'static [CodeLine] = &[
        code_line(0, "why-code-rectangles", "why-words-rectangles"),
        code_line(0, "why-code-over", "why-words-over"),
        code_line(0, "why-code-straight", "why-words-straight"),
        code_line(0, "why-code-between", "why-words-between"),
        code_line(0, "why-code-twice", "why-words-twice"),
    ];
    const WATCH: &'static [Watched] = &[
        Watched::Names(&["from_corner₁", "from_corner₂"]),
        Watched::ListSeen("areas", "why"),
    ];
    const OPENING: Row = Row::new(Phase, 0, "why-area-opening").so(FROM_CORNER);

    table! { |event, step|
        nothing: Shown { fact: Fact::Nothing, .. } => Row::new(Reject, 0, "why-area-nothing").so(ENDS);
        first: Shown { fact: Fact::First, .. } => Row::new(Test, 0, "why-area-first").so(&["|a₁·b₂|{=first}"]);
        second: Shown { fact: Fact::Second, .. } => Row::new(Test, 0, "why-area-second").so(&["|b₁·a₂|{=second}"]);
        ends: Shown { fact: Fact::Ends, .. } =>
            Row::new(Test, 1, "why-area-ends").so(&["{both / two}{=ends}"]);
        half: Shown { fact: Fact::Half, .. } => Row::new(Test, 2, "why-area-half").so(&["{all / two}{=half}"]);
        more: Shown { fact: Fact::Triangle, .. } if turns(step, Turn::Left) =>
            Row::new(Test, 3, "why-area-more").so(TRIANGLE);
        less: Shown { fact: Fact::Triangle, .. } if turns(step, Turn::Right) =>
            Row::new(Test, 3, "why-area-less").so(TRIANGLE);
        none: Shown { fact: Fact::Triangle, .. } => Row::new(Test, 3, "why-area-none").so(TRIANGLE);
        left: Shown { fact: Fact::Twice, .. } if turns(step, Turn::Left) =>
            Row::new(Accept, 4, "why-area-left").so(TWICE);
        right: Shown { fact: Fact::Twice, .. } if turns(step, Turn::Right) =>
            Row::new(Accept, 4, "why-area-right").so(TWICE);
        through: Shown { fact: Fact::Twice, .. } => Row::new(Accept, 4, "why-area-through").so(TWICE);
    }

    fn named(at: &At<'_, Self>, of: &str) -> Option<Named> {
        let input = at.step.input;
        let WindowInput { window, segment } = input.given();
        match of {
            "P₁" => return Some(segment.p1.to_array().into()),
            "P₂" => return Some(segment.p2.to_array().into()),
            _ => {}
        }
        let corner = input.line()?.corner;
        let [first, second] = input.measured()?;
        let shown = |name| fact(&at.step, &NAMES, name);
        let [left, right] = sides(input);
        Some(match of {
            "corner" => corner_name(window, corner).into(),
            "place" => corner_formula(window, corner).into(),
            "from_corner₁" => Named::from(first).labelled(name("(a₁, b₁)")),
            "from_corner₂" => Named::from(second).labelled(name("(a₂, b₂)")),
            "left" => at.step.held.get(left)?.into(),
            "right" => at.step.held.get(right)?.into(),
            "two" => Value::Count(2).into(),
            "both" => {
                let sizes = [first, second].map(|at| at.map(f64::abs));
                sum_of(Formula::default(), sizes.map(|[w, h]| (w, h)), times).into()
            }
            "all" => {
                let [width, height] = [0, 1].map(|i| (second[i] - first[i]).abs());
                times(Formula::default().num(width), height).into()
            }
            _ => shown(of)?.into(),
        })
    }

    fn listed(at: &At<'_, Self>, _: &str) -> Vec<Named> {
        let areas = [Fact::First, Fact::Second].into_iter().filter_map(|of| {
            let area = at.step.held.get(of)?;
            Some(Named::from(area).labelled(name(product(of))))
        });
        areas.collect()
    }

    fn views(at: &At<'_, Self>) -> Vec<View> {
        let table = View::new("why", Body::Table(balance(at)));
        vec![drawing(at), table]
    }
}

/// The rectangles to the left and to the right of the way over the corner.
fn sides(input: &DoubleAreaInput) -> [Fact; 2] {
    if input.is_first_left() {
        [Fact::First, Fact::Second]
    } else {
        [Fact::Second, Fact::First]
    }
}

fn product(of: Fact) -> &'static str {
    if of == Fact::First {
        "|a₁·b₂|"
    } else {
        "|b₁·a₂|"
    }
}

fn drawing(at: &At<'_, Why<DoubleArea>>) -> View {
    let input = at.step.input;
    let WindowInput {
        window,
        segment: straight,
    } = input.given();
    let mut given = segment_marks(straight, [straight.p1, straight.p2], None);
    let Some(CornerLine { corner, .. }) = input.line() else {
        return View::plane(given);
    };
    let [from, over, to] = [straight.p1, corner, straight.p2].map(Point::to_array);
    let dot = mark(Role::Soft, Shape::Dot(over)).labelled(corner_name(window, corner));
    given.extend([
        mark(Role::Faint, Shape::Outline(rectangle([from, to]))),
        dot,
    ]);
    given.extend(cross(from, over, to));
    let mut picture = Picture::new(&at.step, given);
    for of in [Fact::First, Fact::Second] {
        picture.once(of, Role::Accent, |role, area| {
            let fill = Shape::Fill(vec![rectangle([over, outer(of, from, to)])]);
            [mark(role, fill).labelled(sym(product(of)).equals(area))]
        });
    }
    let [left, _] = sides(input);
    let halved = |[a, b]: [[f64; 2]; 2]| vec![a, outer(left, a, b), b];
    picture.once(Fact::Ends, Role::Ink, |role, _| {
        let way = mark(role, Shape::Path(vec![from, over, to]));
        let halves = [[from, over], [over, to]].map(halved).to_vec();
        let halves = mark(role, Shape::Fill(halves));
        [Some(way), (role == Role::Signal).then_some(halves)]
            .into_iter()
            .flatten()
    });
    picture.once(Fact::Half, Role::Ink, |role, _| {
        let half = mark(role, Shape::Fill(vec![halved([from, to])]));
        (role == Role::Signal).then_some(half)
    });
    let kept = if picture.is_now(Fact::Twice) {
        Role::Signal
    } else {
        Role::Ink
    };
    picture.once(Fact::Triangle, kept, |role, area| {
        let fill = mark(role, Shape::Fill(vec![vec![from, over, to]]));
        [fill.labelled(area.abs())]
    });
    picture.in_scene()
}

fn rectangle([a, b]: [[f64; 2]; 2]) -> Vec<[f64; 2]> {
    vec![a, [b[0], a[1]], b, [a[0], b[1]]]
}

/// The corner of the rectangle between two places that lies on the side of this product.
fn outer(of: Fact, [x1, y1]: [f64; 2], [x2, y2]: [f64; 2]) -> [f64; 2] {
    if of == Fact::First {
        [x1, y2]
    } else {
        [x2, y1]
    }
}

/// The lines of the corner's edges, as far as they divide the rectangle.
fn cross([x1, y1]: [f64; 2], [x, y]: [f64; 2], [x2, y2]: [f64; 2]) -> [Mark; 2] {
    [[[x1, y], [x2, y]], [[x, y1], [x, y2]]].map(|[a, b]| segment(Role::Faint, a, b))
}

/// What there is on both sides of the way over the corner, less half of all.
fn balance(at: &At<'_, Why<DoubleArea>>) -> Table {
    let input = at.step.input;
    let shown = |name| fact(&at.step, &NAMES, name);
    let now = at.step.event().map(|shown| shown.fact);
    let row = |key, facts: [Fact; 2], values: [Option<Value>; 2]| {
        let cell = |(fact, value)| {
            let role = if now == Some(fact) {
                Role::Signal
            } else {
                Role::Ink
            };
            Cell::new(role, value)
        };
        TableRow {
            name: Value::Term(key),
            cells: facts.into_iter().zip(values).map(cell).collect(),
            is_current: facts.iter().any(|&fact| now == Some(fact)),
            link: None,
        }
    };
    let of_sides = sides(input);
    let areas = of_sides.map(|of| at.step.held.get(of).map(Value::from));
    let ends = shown("ends").map(Value::from);
    let half = shown("half").map(Value::from);
    let triangle = shown("triangle");
    let more = [triangle, triangle.map(|it| -it)].map(|it| it.map(Value::from));
    let rows = vec![
        row("why-rectangle", of_sides, areas),
        row("why-ends", [Fact::Ends; 2], [ends.clone(), ends]),
        row("why-half", [Fact::Half; 2], [half.clone(), half]),
        row("why-more", [Fact::Triangle; 2], more),
    ];
    let header = ["why-area", "why-left", "why-right"];
    Table {
        header: header.map(|key| Formula::default().term(key)).to_vec(),
        rows,
        notes: Vec::new(),
    }
}
