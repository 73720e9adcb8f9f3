//! Why p < 0 is "in", shown: x and y over u, each with the strip of the window, over one axis of u.
//!
//! ```text
//!   right ────────────○──    x = −2 + 4u
//!                  ╱  ┊ out
//!   left ──────○──────┊──
//!           in ┊      ┊
//!   top  ──────┊──────┊─○    y = −1 + 5/2 u
//!   bottom ○───┊──────┊──
//!   u      0   1/4    3/4
//! ```

use crate::{
    algo::why::{Shown, Strips, StripsFact as Fact, Why},
    figure::Weight,
    labs::why::{Picture, mark, segment},
};

use super::super::{
    prelude::*,
    shared::{segment_marks, side, side_key},
};

/// How wide u from 0 to 1 is drawn, and how high each strip's plot.
const WIDTH: f64 = 2.4;
const HEIGHT: f64 = 0.9;
/// Where the plots of x and y begin, over the axis of u.
const BASES: [f64; 2] = [1.3, 0.2];
/// What is farther beyond the ends than this is not drawn.
const BEYOND: f64 = 0.15;

impl Telling for Why<Strips> {
    type Scenery = ();

    const ID: &'static str = "why-strips";
    const NAME_KEY: &'static str = "why-strips";
    const SOURCE: &'static str = "Liang & Barsky, 1984";
    const IS_PROOF: bool = true;
    const CODE: &'static [CodeLine] = &[
        code_line(0, "why-code-strip", "why-words-strip"),
        code_line(1, "why-code-in", "why-words-in"),
        code_line(1, "why-code-out", "why-words-out"),
        code_line(1, "why-code-level", "why-words-level"),
        code_line(0, "why-code-both", "why-words-both"),
    ];
    const WATCH: &'static [Watched] = &[
        Watched::List("borders"),
        Watched::Names(&["u_min", "u_max"]),
    ];
    const OPENING: Row = Row::new(Phase, 0, "why-strips-opening")
        .so(&["x = {x₁} + {(Δx)} u", "y = {y₁} + {(Δy)} u"]);

    table! { |event, step|
        enters: Shown { fact: Fact::In { .. }, .. } => Row::new(Test, 1, "why-strips-in").so(&["p{=p} < 0", "u{=u}"]);
        leaves: Shown { fact: Fact::Out { .. }, .. } => Row::new(Test, 2, "why-strips-out").so(&["p{=p} > 0", "u{=u}"]);
        level: Shown { fact: Fact::Level { .. }, .. } => Row::new(Test, 3, "why-strips-level").so(&["q{=u} ≥ 0"]);
        beyond: Shown { fact: Fact::Beyond { .. }, .. } =>
            Row::new(Reject, 3, "why-strips-beyond").so(&["q{=−u} < 0"]);
        from: Shown { fact: Fact::From, .. } => Row::new(Test, 4, "why-strips-from").so(&["u_min{=u}"]);
        empty: Shown { fact: Fact::To, .. } if step.held.get(Fact::From) > step.held.get(Fact::To) =>
            Row::new(Reject, 4, "why-strips-empty").so(&["u_min{=u_min} > u_max{=u_max}"]);
        to: Shown { fact: Fact::To, .. } =>
            Row::new(Accept, 4, "why-strips-to").so(&["{u_min} ≤ u ≤ {u_max}"]);
    }

    fn named(at: &At<'_, Self>, name: &str) -> Option<Named> {
        let WindowInput { segment, .. } = at.step.input;
        let ([x1, y1, x2, y2], held) = (segment.to_array(), at.step.held);
        Some(match name {
            "x₁" => x1.into(),
            "y₁" => y1.into(),
            "Δx" => (x2 - x1).into(),
            "Δy" => (y2 - y1).into(),
            "u_min" => held.get(Fact::From)?.into(),
            "u_max" => held.get(Fact::To)?.into(),
            "u" => at.step.event()?.number.into(),
            "edge" => side(edge_of(at.step.event()?.fact)?),
            "p" => {
                let edge = edge_of(at.step.event()?.fact)?;
                let delta = [x2 - x1, y2 - y1][axis_idx(edge)];
                if edge.is_max() { delta } else { -delta }.into()
            }
            _ => return None,
        })
    }

    fn listed(at: &At<'_, Self>, _: &str) -> Vec<Named> {
        let borders = Edge::ALL.into_iter().filter_map(|edge| {
            let u = [Fact::In { edge }, Fact::Out { edge }];
            let u = u.into_iter().find_map(|fact| at.step.held.get(fact))?;
            Some(
                Named::from(u)
                    .labelled(Value::Term(side_key(edge)))
                    .linked(edge_link(edge)),
            )
        });
        borders.collect()
    }

    fn views(at: &At<'_, Self>) -> Vec<View> {
        let segment = &at.step.input.segment;
        let marks = segment_marks(segment, [segment.p1, segment.p2], None);
        vec![View::plane(marks), plots(at)]
    }
}

const fn edge_of(fact: Fact) -> Option<Edge> {
    match fact {
        Fact::In { edge } | Fact::Out { edge } | Fact::Level { edge } | Fact::Beyond { edge } => {
            Some(edge)
        }
        Fact::From | Fact::To => None,
    }
}

const fn axis_idx(edge: Edge) -> usize {
    match edge.axis() {
        Axis::X => 0,
        Axis::Y => 1,
    }
}

/// One coordinate over u.
struct Plot {
    /// Left and right, or bottom and top.
    edges: [Edge; 2],
    borders: [f64; 2],
    ends: [f64; 2],
    /// What is drawn from the lowest to the highest value.
    shown: [f64; 2],
    base: f64,
}

impl Plot {
    fn new(input: &WindowInput, axis: usize) -> Self {
        let edges = [[Edge::Left, Edge::Right], [Edge::Bottom, Edge::Top]][axis];
        let borders = edges.map(|edge| input.window.border(edge));
        let ends = [input.segment.p1, input.segment.p2].map(|at| at.to_array()[axis]);
        let low = borders[0].min(ends[0]).min(ends[1]);
        let high = borders[1].max(ends[0]).max(ends[1]);
        let base = BASES[axis];
        Self {
            edges,
            borders,
            ends,
            shown: [low, high],
            base,
        }
    }

    fn place(&self, u: f64, value: f64) -> [f64; 2] {
        let [low, high] = self.shown;
        [
            WIDTH * u,
            self.base + HEIGHT * (value - low) / (high - low).max(f64::MIN_POSITIVE),
        ]
    }

    /// The strip, its borders, and the line.
    fn given(&self, symbol: &'static str) -> Vec<Mark> {
        let [low, high] = self.borders;
        let corners = [(0.0, low), (1.0, low), (1.0, high), (0.0, high)];
        let strip = corners.map(|(u, value)| self.place(u, value)).to_vec();
        let mut marks = vec![mark(Role::Ink, Shape::Fill(vec![strip]))];
        for (edge, border) in self.edges.into_iter().zip(self.borders) {
            let line = segment(
                Role::Accent,
                self.place(0.0, border),
                self.place(1.0, border),
            );
            let label = mark(Role::Accent, Shape::Label(self.place(0.0, border)));
            let label =
                label.labelled(Formula::default().term(side_key(edge)).sym(" ").num(border));
            marks.extend([line.linked(edge_link(edge)), label.toward([-1.0, 0.0])]);
        }
        let [from, to] = self.ends;
        let way = [self.place(0.0, from), self.place(1.0, to)];
        let equation = sym(symbol)
            .sym(" = ")
            .num(from)
            .sym(" + ")
            .operand(to - from)
            .sym(" u");
        let end = mark(Role::Ink, Shape::Label(way[1]))
            .labelled(equation)
            .toward([1.0, 0.0]);
        marks.extend([
            mark(Role::Ink, Shape::Segment(way)),
            mark(Role::Ink, Shape::Heading(way)),
            end,
        ]);
        marks
    }

    /// Where the line meets a border, and how that is read on the axis of u.
    fn crossing(&self, (border, word): (f64, &'static str), role: Role, u: f64) -> Vec<Mark> {
        if !(-BEYOND..=1.0 + BEYOND).contains(&u) {
            return Vec::new();
        }
        let (at, foot) = (self.place(u, border), [WIDTH * u, 0.0]);
        let ring = mark(role, Shape::Ring(at))
            .labelled(Value::Term(word))
            .strong();
        let tick = mark(role, Shape::Vertex(foot))
            .labelled(u)
            .toward([0.0, -1.0]);
        vec![
            segment(role, at, foot).dashed().weighing(Weight::of(1.0)),
            ring,
            tick,
        ]
    }
}

fn plots(at: &At<'_, Why<Strips>>) -> View {
    let plots = [0, 1].map(|axis| Plot::new(at.step.input, axis));
    let axis = segment(Role::Soft, [0.0, 0.0], [WIDTH, 0.0]);
    let name_of = mark(Role::Soft, Shape::Label([WIDTH, 0.0])).labelled(name("u"));
    let ends = [0.0, 1.0].map(|u| {
        mark(Role::Soft, Shape::Vertex([WIDTH * u, 0.0]))
            .labelled(u)
            .toward([0.0, -1.0])
    });
    let mut given = vec![axis, name_of.toward([1.0, 0.0])];
    given.extend(ends);
    for u in [0.0, 1.0] {
        let top = BASES[0] + HEIGHT;
        given.push(segment(Role::Faint, [WIDTH * u, 0.0], [WIDTH * u, top]));
    }
    given.extend(plots[0].given("x").into_iter().chain(plots[1].given("y")));
    let mut picture = Picture::new(&at.step, given);
    for plot in &plots {
        for (edge, border) in plot.edges.into_iter().zip(plot.borders) {
            let [enters, leaves] = [(border, "why-in"), (border, "why-out")];
            picture.once(Fact::In { edge }, Role::Accent, |role, u| {
                plot.crossing(enters, role, u)
            });
            picture.once(Fact::Out { edge }, Role::Accent, |role, u| {
                plot.crossing(leaves, role, u)
            });
        }
    }
    let low = at.step.held.get(Fact::From);
    picture.once(Fact::From, Role::Accent, |role, u| {
        [mark(role, Shape::Bound([[WIDTH * u, 0.0], [WIDTH, 0.0]]))]
    });
    picture.once(Fact::To, Role::Accepted, |role, to| {
        let ends = [low.unwrap_or(0.0), to].map(|u| [WIDTH * u, 0.0]);
        let is_empty = ends[0][0] > ends[1][0];
        let role = if is_empty { Role::Discarded } else { role };
        let between = segment(role, ends[0], ends[1]).weighing(Weight::of(6.0));
        let back = mark(role, Shape::Bound([ends[1], [0.0, 0.0]]));
        [between, back]
    });
    picture.view(
        "why-view-strips",
        [[-0.55, -0.3], [WIDTH + 0.75, BASES[0] + HEIGHT + 0.15]],
    )
}
