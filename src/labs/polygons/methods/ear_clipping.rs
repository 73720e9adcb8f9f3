//! Ear clipping, shown.

use crate::{
    algo::polygon::{
        Corner, EarClipping, EarClippingEvent as Event, EarClippingState as State, Triangle,
        Triangulation,
    },
    figure::{Caption, Link, Mark, Role, Shape, Tick, View, Watch, WatchRow, WatchSection},
    geom::{Point, SimplePolygon},
    labs::{
        Answer, CodeLine, Demo, Step, code_line,
        polygons::{Part, PolygonDemo, Refusal, Scene},
        words::{name, vertex_name, vertex_symbol},
    },
    text::{Formula, Message, Value},
};

use super::triangles::{
    cut_off_marks, points_of, triangle_name, triangles_json, triangles_section, vertex_mark,
};

const CLASSIFY: usize = 0;
const ROUND: usize = 1;
const CONVEX: usize = 3;
const EMPTY: usize = 4;
const CUT: usize = 5;
const RECLASSIFY: usize = 6;
const LAST: usize = 7;

/// Rows of the table of vertices.
const MAX_ROWS: usize = 12;
/// Up to this number of vertices each has its mark.
const FEW_ENOUGH: usize = 60;

impl PolygonDemo for EarClipping {
    const CLIPS: bool = false;

    fn input(scene: &Scene) -> Result<SimplePolygon, Refusal> {
        SimplePolygon::try_from(&scene.subject).map_err(|error| Refusal::new(Part::Subject, error))
    }
}

impl Answer for Triangulation {
    fn json(&self) -> serde_json::Value {
        triangles_json(self)
    }
}

impl Demo for EarClipping {
    const ID: &'static str = "ear-clipping";
    const NAME_KEY: &'static str = "alg-ear-clipping";
    const SOURCE: &'static str = "G. H. Meisters, 1975; ElGindy, Everett & Toussaint, 1993";
    const CODE: &'static [CodeLine] = &[
        code_line(0, "code-ear-classify", "words-ear-classify"),
        code_line(0, "code-ear-round", "words-ear-round"),
        code_line(1, "code-ear-each", "words-ear-each"),
        code_line(2, "code-ear-convex", "words-ear-convex"),
        code_line(3, "code-ear-empty", "words-ear-empty"),
        code_line(4, "code-ear-cut", "words-ear-cut"),
        code_line(4, "code-ear-again", "words-ear-again"),
        code_line(0, "code-ear-last", "words-ear-last"),
    ];

    fn tick(event: &Event) -> Tick {
        match event {
            Event::Classify { .. }
            | Event::Pass { .. }
            | Event::Candidate { .. }
            | Event::Blocked { .. }
            | Event::Ear { .. } => Tick::Test,
            Event::Round { .. } => Tick::Phase,
            Event::Cut { .. } | Event::Last { .. } => Tick::Cut,
            Event::Done { .. } => Tick::Accept,
        }
    }

    fn code_line(event: &Event, before: &State) -> usize {
        match event {
            Event::Classify { vertex_idx, .. } if before.corners[*vertex_idx].is_some() => {
                RECLASSIFY
            }
            Event::Classify { .. } => CLASSIFY,
            Event::Round { .. } => ROUND,
            Event::Pass { .. } | Event::Candidate { .. } => CONVEX,
            Event::Blocked { .. } | Event::Ear { .. } => EMPTY,
            Event::Cut { .. } => CUT,
            Event::Last { .. } | Event::Done { .. } => LAST,
        }
    }

    fn opening(input: &SimplePolygon) -> Caption {
        let n = input.vertices().len();
        let message = Message::new("ear-opening").with("n", n);
        Caption::new(message).so(count_formula(n))
    }

    fn caption(event: &Event, before: &State, _: &SimplePolygon) -> Caption {
        match *event {
            Event::Classify {
                vertex_idx,
                prev_idx,
                next_idx,
                double_area,
                corner,
            } => {
                let key = match before.corners[vertex_idx] {
                    None => "ear-classify",
                    Some(_) => "ear-classify-again",
                };
                let message = Message::new(key)
                    .with("vertex", vertex_name(vertex_idx))
                    .with("corner", corner_name(corner));
                let corners = [prev_idx, vertex_idx, next_idx];
                Caption::new(message).so(turn_formula(corners, before, double_area))
            }
            Event::Round { round_idx, n_left } => Caption::new(
                Message::new("ear-round")
                    .with("round", round_idx + 1)
                    .with("n", n_left),
            ),
            Event::Pass { vertex_idx, corner } => Caption::new(
                Message::new("ear-pass")
                    .with("vertex", vertex_name(vertex_idx))
                    .with("corner", corner_name(corner)),
            ),
            Event::Candidate { triangle } => Caption::new(
                Message::new("ear-candidate")
                    .with("vertex", vertex_name(triangle[1]))
                    .with("triangle", triangle_name(triangle)),
            ),
            Event::Blocked {
                vertex_idx,
                by_idx,
                double_areas,
            } => blocked(vertex_idx, by_idx, double_areas, before),
            Event::Ear { vertex_idx } => {
                let triangle = before.ring.corner(vertex_idx);
                Caption::new(
                    Message::new("ear-ear")
                        .with("vertex", vertex_name(vertex_idx))
                        .with("triangle", triangle_name(triangle)),
                )
            }
            Event::Cut { triangle, n_left } => Caption::new(
                Message::new("ear-cut")
                    .with("triangle", triangle_name(triangle))
                    .with("diagonal", name(vertices_name([triangle[0], triangle[2]])))
                    .with("n", n_left),
            ),
            Event::Last { triangle } => {
                Caption::new(Message::new("ear-last").with("triangle", triangle_name(triangle)))
            }
            Event::Done { n_triangles } => {
                Caption::new(Message::new("ear-done").with("n", n_triangles))
                    .so(count_formula(n_triangles + 2))
            }
        }
    }

    fn views(step: &Step<'_, Self>) -> Vec<View> {
        vec![View::plane(marks(step))]
    }

    fn watch(step: &Step<'_, Self>) -> Watch {
        let state = step.state;
        let rows = vec![
            WatchRow::new(Value::Term("ear-left"), Some(ring_name(state))),
            WatchRow::new(
                Value::Term("ear-n-left"),
                Some(Value::Count(state.ring.len())),
            ),
            WatchRow::new(
                Value::Term("ear-n-triangles"),
                Some(Value::Count(state.cut_off.triangles().len())),
            ),
        ];
        let vertices = around_stand(state).into_iter().map(|i| {
            let at = Value::Point(state.cut_off.at(i).to_array());
            let row = WatchRow::new(vertex_name(i), Some(at)).linked(vertex_link(i));
            match state.corners[i] {
                Some(corner) => row.noted(corner_name(corner)),
                None => row,
            }
        });
        let mut watch = vec![
            WatchSection::list(rows),
            WatchSection::list(vertices.collect()),
        ];
        watch.extend(triangles_section(&state.cut_off));
        watch
    }
}

/// The drawing.
pub fn marks(step: &Step<'_, EarClipping>) -> Vec<Mark> {
    let state = step.state;
    let mut marks = cut_off_marks(&state.cut_off);
    if !state.is_done && state.ring.len() > 2 {
        let left = state.ring.iter().map(|i| state.cut_off.at(i).to_array());
        marks.push(Mark::new(Role::Accent, Shape::Outline(left.collect())));
    }
    marks.extend(event_marks(step));
    marks.extend(vertex_marks(step));
    marks
}

/// Three of the given points and the vertex that was asked about: `V₄ = (3, 2)`, `turn(V₁, V₂, V₄) = 12 ≥ 0` …
fn blocked(vertex_idx: usize, by_idx: usize, double_areas: [f64; 3], before: &State) -> Caption {
    let triangle = before.ring.corner(vertex_idx);
    let message = Message::new("ear-blocked")
        .with("by", vertex_name(by_idx))
        .with("triangle", triangle_name(triangle))
        .with("vertex", vertex_name(vertex_idx));
    let by = Formula::default()
        .sym(vertex_symbol(by_idx))
        .sym(" = ")
        .point(before.cut_off.at(by_idx).to_array());
    (0..3).fold(Caption::new(message).so(by), |caption, side| {
        let corners = [triangle[side], triangle[(side + 1) % 3], by_idx];
        let turn = Formula::default()
            .sym(turn_name(corners))
            .equals(double_areas[side])
            .sym(" ≥ 0");
        caption.so(turn)
    })
}

/// `turn(V₁, V₂, V₃) = (6 − 0) · (6 − 0) − (0 − 0) · (6 − 6) = 36 > 0`.
fn turn_formula(corners: Triangle, before: &State, double_area: f64) -> Formula {
    let [[xa, ya], [xb, yb], [xc, yc]] = corners.map(|i| before.cut_off.at(i).to_array());
    let difference = |f: Formula, to: f64, from: f64| f.sym("(").num(to).sym(" − ").operand(from);
    let formula = Formula::default().sym(turn_name(corners)).sym(" = ");
    let formula = difference(formula, xb, xa).sym(") · ");
    let formula = difference(formula, yc, yb).sym(") − ");
    let formula = difference(formula, yb, ya).sym(") · ");
    let formula = difference(formula, xc, xb).sym(")").equals(double_area);
    if double_area > 0.0 {
        formula.sym(" > 0")
    } else if double_area < 0.0 {
        formula.sym(" < 0")
    } else {
        formula
    }
}

/// `turn(V₁, V₂, V₃)`.
fn turn_name([a, b, c]: Triangle) -> String {
    let [a, b, c] = [a, b, c].map(vertex_symbol);
    format!("turn({a}, {b}, {c})")
}

/// `5 − 2 = 3`.
fn count_formula(n: usize) -> Formula {
    Formula::default()
        .num(n as f64)
        .sym(" − 2")
        .equals(n as f64 - 2.0)
}

const fn corner_name(corner: Corner) -> Value {
    Value::Term(match corner {
        Corner::Convex => "ear-convex",
        Corner::Straight => "ear-straight",
        Corner::Reflex => "ear-reflex",
    })
}

/// `V₁V₂…`.
fn vertices_name(vertices: impl IntoIterator<Item = usize>) -> String {
    vertices.into_iter().map(vertex_symbol).collect()
}

const fn vertex_link(vertex_idx: usize) -> Link {
    Link::nth("vertex", vertex_idx)
}

/// Up to [`MAX_ROWS`] vertices of what is left, those about the one that is asked.
fn around_stand(state: &State) -> Vec<usize> {
    let n = state.ring.len();
    if n <= MAX_ROWS {
        return state.ring.iter().collect();
    }
    let stand = state.stand.filter(|&i| state.ring.contains(i));
    let mut from = stand.unwrap_or(state.ring.first());
    if stand.is_some() {
        for _ in 0..MAX_ROWS / 2 {
            from = state.ring.prev(from);
        }
    }
    let after = |&i: &usize| Some(state.ring.next(i));
    std::iter::successors(Some(from), after)
        .take(MAX_ROWS)
        .collect()
}

/// `V₁V₂V₄V₅`, with dots where there are too many.
fn ring_name(state: &State) -> Value {
    let shown = vertices_name(around_stand(state));
    if state.ring.len() > MAX_ROWS {
        name(format!("…{shown}…"))
    } else {
        name(shown)
    }
}

/// What this step is about.
fn event_marks(step: &Step<'_, EarClipping>) -> Vec<Mark> {
    let state = step.state;
    let points = |triangle: Triangle| points_of(&state.cut_off, triangle);
    let candidate = |role| {
        let area = |triangle| Mark::new(role, Shape::Area(vec![points(triangle)]));
        state.candidate.map(area).into_iter().collect()
    };
    match step.event {
        Some(Event::Classify {
            vertex_idx,
            prev_idx,
            next_idx,
            ..
        }) => {
            let corner = points([prev_idx, vertex_idx, next_idx]);
            vec![Mark::new(Role::Signal, Shape::Path(corner))]
        }
        Some(Event::Candidate { .. } | Event::Last { .. }) => candidate(Role::Signal),
        Some(Event::Blocked { .. }) => candidate(Role::Discarded),
        Some(Event::Ear { .. }) => candidate(Role::Accepted),
        Some(Event::Cut { triangle, .. }) => {
            let [from, _, to] = state.cut_off.corners(triangle).map(Point::to_array);
            vec![Mark::new(Role::Signal, Shape::Segment([from, to]))]
        }
        Some(Event::Round { .. } | Event::Pass { .. } | Event::Done { .. }) | None => Vec::new(),
    }
}

/// A dot for a convex vertex, a ring for any other, grey where it has been cut off. Where there are many only this
/// step's have one.
fn vertex_marks(step: &Step<'_, EarClipping>) -> Vec<Mark> {
    let state = step.state;
    let this_step: Vec<usize> = match step.event {
        Some(
            Event::Classify { vertex_idx, .. }
            | Event::Pass { vertex_idx, .. }
            | Event::Ear { vertex_idx },
        ) => vec![vertex_idx],
        Some(Event::Blocked {
            vertex_idx, by_idx, ..
        }) => vec![vertex_idx, by_idx],
        Some(Event::Candidate { triangle }) => vec![triangle[1]],
        _ => Vec::new(),
    };
    let cut_off = state.cut_off.triangles().iter().map(|triangle| triangle[1]);
    let shown: Vec<usize> = if state.corners.len() <= FEW_ENOUGH {
        let cut_off = cut_off.filter(|&i| !state.ring.contains(i));
        state.ring.iter().chain(cut_off).collect()
    } else {
        this_step.clone()
    };
    let mark = |i: usize| {
        let role = if this_step.contains(&i) {
            Role::Signal
        } else if state.ring.contains(i) {
            Role::Ink
        } else {
            Role::Soft
        };
        let is_convex = state.corners[i].is_none_or(|corner| corner == Corner::Convex);
        vertex_mark(role, is_convex, state.cut_off.at(i))
            .labelled(vertex_name(i))
            .linked(vertex_link(i))
    };
    shown.into_iter().map(mark).collect()
}
