//! The sentences of ear clipping, with the numbers of their step.

use crate::{
    algo::polygon::{Corner, EarClippingEvent as Event, EarClippingState as State, Triangle},
    figure::Caption,
    labs::{
        polygons::methods::triangles::triangle_name,
        words::{name, vertex_name, vertex_symbol},
    },
    text::{Formula, Message, Value},
};

pub fn opening(n: usize) -> Caption {
    let message = Message::new("ear-opening").with("n", n);
    Caption::new(message).so(count_formula(n))
}

pub fn caption(event: &Event, before: &State) -> Caption {
    match *event {
        Event::Classify {
            vertex_idx,
            prev_idx,
            next_idx,
            double_area,
            corner,
        } => {
            let message = classified(vertex_idx, corner, before);
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

fn classified(vertex_idx: usize, corner: Corner, before: &State) -> Message {
    let key = match before.corners[vertex_idx] {
        None => "ear-classify",
        Some(_) => "ear-classify-again",
    };
    Message::new(key)
        .with("vertex", vertex_name(vertex_idx))
        .with("corner", corner_name(corner))
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

pub const fn corner_name(corner: Corner) -> Value {
    Value::Term(match corner {
        Corner::Convex => "ear-convex",
        Corner::Straight => "ear-straight",
        Corner::Reflex => "ear-reflex",
    })
}

/// `V₁V₂…`.
pub fn vertices_name(vertices: impl IntoIterator<Item = usize>) -> String {
    vertices.into_iter().map(vertex_symbol).collect()
}
