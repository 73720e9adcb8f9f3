//! Words and formulas that several labs share.

use crate::{
    algo::line::Ratio,
    figure::Link,
    geom::{Axis, Edge, Point, Segment, Window},
    text::{Formula, Value},
};

/// Catalogue key of a side as a noun: "left edge".
pub const fn edge_key(edge: Edge) -> &'static str {
    match edge {
        Edge::Left => "edge-left",
        Edge::Right => "edge-right",
        Edge::Bottom => "edge-bottom",
        Edge::Top => "edge-top",
    }
}

/// The name of a side as it stands in a sentence.
pub const fn edge_name(edge: Edge) -> Value {
    Value::Term(edge_key(edge))
}

/// What marks, rows and ticks about a side have in common.
pub const fn edge_link(edge: Edge) -> Link {
    Link::to(edge.id())
}

/// A plain name.
pub fn name(text: impl Into<String>) -> Value {
    Value::Name(text.into())
}

/// `x` or `y`.
pub const fn axis_symbol(axis: Axis) -> &'static str {
    match axis {
        Axis::X => "x",
        Axis::Y => "y",
    }
}

/// `[coordinate along the axis, the other one]`.
pub const fn along(point: Point, axis: Axis) -> [f64; 2] {
    match axis {
        Axis::X => [point.x(), point.y()],
        Axis::Y => [point.y(), point.x()],
    }
}

/// `x = −1`: the equation of a side.
pub fn border_equation(window: &Window, edge: Edge) -> Formula {
    Formula::default()
        .sym(axis_symbol(edge.axis()))
        .sym(" = ")
        .num(window.border(edge))
}

/// `t = (−1 − (−2)) / (2 − (−2)) = 1/4`: where on a segment a side is crossed.
pub fn parameter_formula(
    symbol: &'static str,
    segment: &Segment,
    window: &Window,
    edge: Edge,
    u: Ratio,
) -> Formula {
    let [a1, _] = along(segment.p1, edge.axis());
    let [a2, _] = along(segment.p2, edge.axis());
    let from_a1 = |a: f64| Formula::default().num(a).sym(" − ").operand(a1);
    Formula::default()
        .sym(symbol)
        .sym(" = ")
        .over(from_a1(window.border(edge)), from_a1(a2))
        .equals_ratio(u.num, u.den)
}

/// `y = (−1 · 3 + 3/2 · 1) / 4 = −3/8`: the free coordinate of a crossing, as it is computed.
pub fn free_formula(segment: &Segment, window: &Window, edge: Edge, free: f64) -> Formula {
    let (axis, c) = (edge.axis(), window.border(edge));
    let [a1, o1] = along(segment.p1, axis);
    let [a2, o2] = along(segment.p2, axis);
    let other = match axis {
        Axis::X => "y",
        Axis::Y => "x",
    };
    let sum = Formula::default()
        .num(o1)
        .sym(" · ")
        .operand(a2 - c)
        .sym(" + ")
        .operand(o2)
        .sym(" · ")
        .operand(c - a1);
    Formula::default()
        .sym(other)
        .sym(" = ")
        .over(sum, Formula::default().num(a2 - a1))
        .equals(free)
}

/// `P₁ = (−2, −1)`.
pub fn point_formula(symbol: &'static str, point: Point) -> Formula {
    Formula::default()
        .sym(symbol)
        .sym(" = ")
        .point(point.to_array())
}

/// What says where a point lies along one axis: `x = −2 < −1` beyond a side, `−1 ≤ y = 0 ≤ 1` between both.
pub fn position_formula(
    axis: Axis,
    at: Point,
    window: &Window,
    beyond: impl Fn(Edge) -> bool,
) -> Formula {
    let [low, high] = match axis {
        Axis::X => [Edge::Left, Edge::Right],
        Axis::Y => [Edge::Bottom, Edge::Top],
    };
    let (symbol, [value, _]) = (axis_symbol(axis), along(at, axis));
    let coordinate = |f: Formula| f.sym(symbol).sym(" = ").num(value);
    if beyond(low) {
        coordinate(Formula::default())
            .sym(" < ")
            .num(window.border(low))
    } else if beyond(high) {
        coordinate(Formula::default())
            .sym(" > ")
            .num(window.border(high))
    } else {
        coordinate(Formula::default().num(window.border(low)).sym(" ≤ "))
            .sym(" ≤ ")
            .num(window.border(high))
    }
}

/// `12` as `₁₂`.
pub fn subscript(n: usize) -> String {
    const DIGITS: [char; 10] = ['₀', '₁', '₂', '₃', '₄', '₅', '₆', '₇', '₈', '₉'];
    n.to_string()
        .bytes()
        .map(|digit| DIGITS[usize::from(digit - b'0')])
        .collect()
}

/// `V₁`, `V₂`, …: vertices are numbered from 1 on screen.
#[must_use]
pub fn vertex_symbol(vertex_idx: usize) -> String {
    format!("V{}", subscript(vertex_idx + 1))
}

/// [`vertex_symbol`], for a sentence.
pub fn vertex_name(vertex_idx: usize) -> Value {
    name(vertex_symbol(vertex_idx))
}
