//! Why Bresenham's e, shown: the first columns, large, and in each the ruler from the midpoint to the line.

use crate::{
    algo::{
        pipeline::{BresenhamInput, LineToPixels},
        why::{ErrorTerm, ErrorTermFact as Fact, ErrorTermInput, Shown, Why},
    },
    figure::Weight,
    labs::{
        frustum::prelude::*,
        why::{Picture, fact, mark, segment},
    },
};

/// Columns that have room to be read.
const DRAWN: usize = 4;

impl SpaceTelling for Why<ErrorTerm> {
    const SUBJECT: Subject = Subject::Segment;

    fn input(scene: &Scene) -> ErrorTermInput {
        let pixels = silent::<LineToPixels>(&LineToPixels::input(scene));
        let ends = pixels.first().zip(pixels.last());
        ErrorTermInput {
            ends: ends.and_then(|(&from, &to)| BresenhamInput::new(from, to).ok()),
        }
    }
}

const NAMES: [(&str, Fact); 3] = [
    ("2a", Fact::Parts),
    ("2b", Fact::Line),
    ("midpoint", Fact::Midpoint),
];

impl Telling for Why<ErrorTerm> {
    type Scenery = Scenery;

    const ID: &'static str = "why-error-term";
    const NAME_KEY: &'static str = "why-error-term";
    const SOURCE: &'static str = "Bresenham, 1965";
    const IS_PROOF: bool = true;
    const CODE: &'static [CodeLine] = &[
        code_line(0, "why-code-parts", "why-words-parts"),
        code_line(0, "why-code-both-whole", "why-words-both-whole"),
        code_line(0, "why-code-columns", "why-words-columns"),
        code_line(1, "why-code-error", "why-words-error"),
    ];
    const WATCH: &'static [Watched] = &[
        Watched::Names(&["a", "b", "2a", "2b"]),
        Watched::List("errors"),
    ];
    const OPENING: Row = Row::new(Phase, 0, "why-error-opening").so(&["{b / a}", "{1 / 2}"]);

    table! { |event, step|
        parts: Shown { fact: Fact::Parts, number } if number > 0.0 =>
            Row::new(Test, 0, "why-error-parts").so(&["2a = 2 · {a}{=2a}"]);
        one_pixel: Shown { fact: Fact::Parts, .. } =>
            Row::new(Reject, 0, "why-error-one-pixel").so(&["a{=a}"]);
        line: Shown { fact: Fact::Line, .. } =>
            Row::new(Test, 1, "why-error-line").so(&["2a · {b / a}{=2b}"]);
        midpoint: Shown { fact: Fact::Midpoint, .. } =>
            Row::new(Test, 1, "why-error-midpoint").so(&["2a · {1 / 2}{=midpoint}"]);
        beyond: Shown { fact: Fact::Error { .. }, number } if number > 0.0 =>
            Row::new(Test, 3, "why-error-beyond").so(&["e = {moved} − {middle}{=error} > 0"]);
        short: Shown { fact: Fact::Error { .. }, .. } =>
            Row::new(Test, 3, "why-error-short").so(&["e = {moved} − {middle}{=error} ≤ 0"]);
    }

    fn named(at: &At<'_, Self>, name: &str) -> Option<Named> {
        let (input, event) = (at.step.input, at.step.event());
        let [a, b] = input.sides();
        let column = || match event?.fact {
            Fact::Error { column } => Some(column),
            Fact::Parts | Fact::Line | Fact::Midpoint => None,
        };
        Some(match name {
            "a" => a.into(),
            "b" => b.into(),
            "1" => 1.0.into(),
            "2" => 2.0.into(),
            "column" => column()?.into(),
            "moved" => (2.0 * b * column()? as f64).into(),
            "middle" => (2.0 * a * input.rows()[column()? - 1] + a).into(),
            "error" => event?.number.into(),
            _ => fact(&at.step, &NAMES, name)?.into(),
        })
    }

    fn listed(at: &At<'_, Self>, _: &str) -> Vec<Named> {
        let columns = 1..=ErrorTermInput::MOST_COLUMNS;
        let named = |column: usize| {
            let e = at.step.held.get(Fact::Error { column })?;
            Some(Named::from(e).labelled(name(format!("e{}", subscript(column)))))
        };
        columns.filter_map(named).collect()
    }

    fn views(at: &At<'_, Self>) -> Vec<View> {
        let mut views = Vec::new();
        if let Some(scenery) = at.scenery {
            let ends = scenery.scene().places().segment;
            let mut marks = vec![Mark3::new(Role::Accent, Shape3::Segment(ends)).linked("segment")];
            marks.extend(End::BOTH.map(|end| {
                let ring = Mark3::new(Role::Accent, Shape3::Ring(ends[end.idx()]));
                ring.labelled(end_name(end)).strong().linked(end_link(end))
            }));
            views.push(scenery.observer(|_| Fate::ToCome, marks));
        }
        views.push(columns(at));
        views
    }
}

/// Column by column to the right, aside downwards; the middle of the first pixel is 0.
fn columns(at: &At<'_, Why<ErrorTerm>>) -> View {
    let input = at.step.input;
    let ([a, b], rows) = (input.sides(), input.rows());
    let n_drawn = DRAWN.min(rows.len());
    let taken = rows[..n_drawn].iter();
    let lowest = taken.fold(1.0, |low: f64, row| low.max(*row));
    let slope = if a == 0.0 { 0.0 } else { b / a };
    let mut picture = Picture::new(&at.step, grid(n_drawn, lowest, slope));
    picture.once(Fact::Line, Role::Ink, |role, line| {
        let bar = segment(role, [1.0, 0.0], [1.0, -slope]).weighing(Weight::of(4.0));
        let end = mark(role, Shape::Vertex([1.0, -slope]))
            .labelled(line)
            .strong();
        [bar, end.toward([-1.0, -0.5])]
    });
    picture.once(Fact::Midpoint, Role::Ink, |role, midpoint| {
        let cap = segment(role, [0.8, -0.5], [1.2, -0.5]).weighing(Weight::of(3.0));
        let end = mark(Role::Soft, Shape::Label([1.2, -0.5])).labelled(midpoint);
        [cap, end.toward([1.0, 0.5])]
    });
    for column in 1..n_drawn {
        let rows = [rows[column - 1], rows[column]];
        picture.once(Fact::Error { column }, Role::Soft, |role, error| {
            let bar = error_bar(role, column, [a, b], rows[0]);
            let foot = mark(role, Shape::Label([column as f64, -lowest - 0.5]));
            let foot = foot.labelled(sym("e").equals(error)).strong();
            let taken = pixel(column, rows[1], Role::Accent);
            bar.into_iter()
                .chain([foot.toward([0.0, -1.0])])
                .chain(taken)
                .collect::<Vec<_>>()
        });
    }
    picture.view(
        "why-view-columns",
        [[-0.6, -lowest - 0.85], [n_drawn as f64 - 0.4, 0.6]],
    )
}

/// The pixels, the line over them, and the first pixel that is taken.
fn grid(n_drawn: usize, lowest: f64, slope: f64) -> Vec<Mark> {
    let end = n_drawn as f64 - 0.5;
    let upright = (0..=n_drawn).map(|column| {
        let x = column as f64 - 0.5;
        segment(Role::Faint, [x, 0.5], [x, -lowest - 0.5])
    });
    let level = (0..=lowest as usize + 1).map(|row| {
        let y = 0.5 - row as f64;
        segment(Role::Faint, [-0.5, y], [end, y])
    });
    let line = segment(Role::Ink, [-0.5, 0.5 * slope], [end, -end * slope]);
    let first = pixel(0, 0.0, Role::Accent);
    upright.chain(level).chain([line]).chain(first).collect()
}

/// From the midpoint under the last pixel taken to the line.
fn error_bar(role: Role, column: usize, [a, b]: [f64; 2], row: f64) -> [Mark; 4] {
    let (x, midpoint) = (column as f64, -row - 0.5);
    let line = if a == 0.0 { 0.0 } else { -b / a * x };
    let cap = segment(role, [x - 0.2, midpoint], [x + 0.2, midpoint]).weighing(Weight::of(3.0));
    let bar = segment(role, [x, midpoint], [x, line]).weighing(Weight::of(5.0));
    let [of_line, of_midpoint] = [2.0 * b * x, 2.0 * a * row + a];
    let end = mark(Role::Ink, Shape::Vertex([x, line]))
        .labelled(of_line)
        .strong();
    let beside = mark(Role::Soft, Shape::Label([x + 0.2, midpoint])).labelled(of_midpoint);
    [
        cap,
        bar,
        end.toward([-1.0, -0.5]),
        beside.toward([1.0, 0.5]),
    ]
}

/// One that is taken.
fn pixel(column: usize, row: f64, role: Role) -> [Mark; 2] {
    let (x, y) = (column as f64, -row);
    let corners = [[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]];
    let corners = corners.map(|[dx, dy]| [x + dx, y + dy]).to_vec();
    [
        mark(role, Shape::Fill(vec![corners])),
        mark(role, Shape::Dot([x, y])),
    ]
}
