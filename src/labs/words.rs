//! Words and formulas that several labs share.

use crate::{
    algo::parameter::End,
    figure::Link,
    geom::{Axis, Edge, Point, Window},
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

/// `[7, 6]`: column and row, from the top left.
pub fn pixel_formula(pixel: [u32; 2]) -> Formula {
    let formula = Formula::decimals().sym("[");
    formula.list(&pixel.map(f64::from)).sym("]")
}

/// A plain name.
pub fn name(text: impl Into<String>) -> Value {
    Value::Name(text.into())
}

/// `P₁` or `P₂`.
pub const fn end_symbol(end: End) -> &'static str {
    match end {
        End::P1 => "P₁",
        End::P2 => "P₂",
    }
}

/// `P₁` or `P₂`, for a sentence.
pub fn end_name(end: End) -> Value {
    Value::Name(end_symbol(end).to_owned())
}

/// `P₁` or `P₂`, after a cut `P₁′` or `P₂′`.
pub fn end_name_now(end: End, moved: bool) -> Value {
    Value::Name(format!(
        "{}{}",
        end_symbol(end),
        if moved { "′" } else { "" }
    ))
}

/// What marks, rows and lines about an end have in common.
pub const fn end_link(end: End) -> Link {
    match end {
        End::P1 => Link::to("p1"),
        End::P2 => Link::to("p2"),
    }
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
pub fn vertex_symbol(vertex_idx: usize) -> String {
    format!("V{}", subscript(vertex_idx + 1))
}

/// `H₁`, `H₂`, …: planes that have no name are called by their half-spaces.
pub fn plane_symbol(plane_idx: usize) -> String {
    format!("H{}", subscript(plane_idx + 1))
}

/// [`vertex_symbol`], for a sentence.
pub fn vertex_name(vertex_idx: usize) -> Value {
    name(vertex_symbol(vertex_idx))
}
