//! Cohen–Sutherland, shown.

use crate::{
    algo::{
        line::{
            BitOrder, CohenSutherlandEvent as Event, CohenSutherlandInput as Input, Outcode,
            faulty::{LooksOnce, RejectsTwoOutside},
        },
        ring::Right,
        segment::{CodeClip, CodeRules},
    },
    labs::{
        segments::{
            CodeStep, LineVariant,
            code_step::{ACCEPT, CodeKeys, CodeLook, LINES, REJECT},
        },
        words::position_formula,
    },
};

use super::{
    cuts::{cut_marks, cut_table},
    prelude::*,
    shared::{
        self, border, crossing_mark, outside_marks, point, region_key, segment_marks, side_key,
    },
};

type Shown<'a> = CodeStep<'a, 2, Input>;

impl<L: CodeRules<2, Input> + LineVariant<2, Input>> LineTelling for CodeClip<2, Input, L> {
    const WRITES_CODES: bool = true;

    fn input(scene: &Scene, segment: Segment) -> Input {
        Input {
            window: scene.window,
            segment,
            bit_order: scene.bit_order,
        }
    }

    fn cuts(event: &Event, segment: &Segment) -> Option<(End, f64)> {
        if let Event::Cut { end, to, .. } = *event {
            Some((end, nearest_along(segment, to)))
        } else {
            None
        }
    }
}

impl LineVariant<2, Input> for Right {
    const ID: &'static str = "cohen-sutherland";
    const NAME_KEY: &'static str = "alg-cohen-sutherland";
    const CODE: &'static [CodeLine] = &LINES;
}

mistakes! { LineVariant<2, Input>:
    LooksOnce {
        "faulty-looks-once", "alg-faulty-looks-once", "faulty-looks-once-differs";
        CODE = LINES but ACCEPT: "code-faulty-looks-once" "words-faulty-looks-once";
    }
    RejectsTwoOutside {
        "faulty-two-outside", "alg-faulty-two-outside", "faulty-two-outside-differs";
        CODE = LINES but REJECT: "code-faulty-two-outside" "words-faulty-two-outside";
    }
}

impl CodeLook<2> for Input {
    type Scenery = ();

    const SOURCE: &'static str = "D. Cohen, I. Sutherland, 1967; Newman & Sproull, 1973";
    const KEYS: CodeKeys = CodeKeys {
        opening: "line-opening",
        codes: ["cs-code"; 4],
        or: ["cs-or-accept", "cs-or-open"],
        and: ["cs-and-open", "cs-and-reject"],
        choose: "cs-choose",
        reject: "cs-reject",
        one_point: ["line-touch", "line-point"],
    };

    fn written(&self) -> Vec<Edge> {
        self.bit_order.written().to_vec()
    }

    fn side(edge: Edge) -> Named {
        shared::side(edge)
    }

    fn column(edge: Edge) -> Value {
        Value::Term(side_key(edge))
    }

    fn shared(&self, and: Outcode) -> Option<Edge> {
        and.edges(self.bit_order).next()
    }

    fn named(&self, code: Outcode, name: &str) -> Option<Value> {
        (name == "region").then(|| region(code, self.bit_order))
    }

    fn position(&self, axis: usize, at: [f64; 2], code: Outcode) -> Formula {
        let beyond = |edge| code.has(edge, self.bit_order);
        position_formula([Axis::X, Axis::Y][axis], point(at), &self.window, beyond)
    }

    fn border(&self, edge: Edge) -> Formula {
        border_equation(&self.window, edge)
    }

    fn crossing_formulas(&self, edge: Edge, at: [f64; 2]) -> Vec<Formula> {
        let border = self.window.border(edge);
        upright(&self.segment, edge.axis(), border, point(at))
    }

    fn note(&self, code: Outcode, is_of_end: bool) -> Option<Value> {
        Some(match (is_of_end, code.is_inside()) {
            (true, _) => region(code, self.bit_order),
            (false, true) => name("= 0"),
            (false, false) => name("≠ 0"),
        })
    }

    /// Where codes are written in another order than most books', what the code is in theirs.
    fn rule(&self, code: Option<Outcode>) -> Message {
        let (order, usual) = (self.bit_order, BitOrder::default());
        match code {
            Some(code) if order != usual => {
                let edges: Vec<Edge> = code.edges(order).collect();
                let other = Outcode::from_edges(&edges, usual).to_string();
                Message::new("cs-note-order").with("other", name(other))
            }
            Some(_) | None => Message::new("cs-note-code"),
        }
    }

    fn rows(shown: &Shown<'_>) -> Option<Table> {
        cut_table(shown)
    }

    fn beyond(&self, edge: Edge) -> Option<Mark> {
        let wash = Shape::Wash(shared::beyond(&self.window, edge));
        Some(Mark::new(Role::Accent, wash))
    }

    fn drawing(shown: &Shown<'_>, _: Option<&()>) -> Option<View> {
        let Input {
            window, segment, ..
        } = shown.input;
        let mut marks = regions(shown);
        if let Some(edge) = shown.deciding() {
            marks.extend(outside_marks(window, edge));
        }
        marks.extend(cut_marks(shown));
        let verdict = shown.verdict.map(|visible| visible.is_some());
        marks.extend(segment_marks(segment, shown.ends.map(point), verdict));
        match shown.event {
            Some(Event::Code { end, at, .. }) => {
                marks.push(Mark::new(Role::Signal, Shape::Ring(at)).linked(end_link(end)));
            }
            Some(Event::Cut { end, u, to, .. }) => {
                marks.push(crossing_mark(point(to), "t", u).linked(end_link(end)));
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
        Some(View::plane(marks))
    }
}

fn region(code: Outcode, order: BitOrder) -> Value {
    Value::Term(region_key(|edge| code.has(edge, order)))
}

fn regions(shown: &Shown<'_>) -> Vec<Mark> {
    let Input {
        window,
        bit_order: order,
        ..
    } = *shown.input;
    let [xmin, ymin, xmax, ymax] = window.to_array();
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
    let mut marks = Edge::ALL
        .map(|edge| Mark::new(Role::Faint, border(&window, edge)).linked(edge_link(edge)))
        .to_vec();
    let deciding = shown.deciding();
    let column = deciding.and_then(|edge| order.written().iter().position(|&e| e == edge));
    let beyond = |code: Outcode| deciding.is_some_and(|edge| code.has(edge, order));
    for (x0, x1, x_edge) in columns {
        for (y0, y1, y_edge) in rows {
            let edges: Vec<Edge> = x_edge.into_iter().chain(y_edge).collect();
            let code = Outcode::from_edges(&edges, order);
            let taken = shown.codes.contains(&Some(code));
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
