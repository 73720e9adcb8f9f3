//! Words and formulas that several labs share.

use std::borrow::Cow;

use crate::{
    algo::parameter::{End, Ratio},
    figure::Link,
    geom::{Axis, Edge, Point, Window},
    text::{Formula, Value},
};

pub const fn edge_key(edge: Edge) -> &'static str {
    match edge {
        Edge::Left => "edge-left",
        Edge::Right => "edge-right",
        Edge::Bottom => "edge-bottom",
        Edge::Top => "edge-top",
    }
}

pub const fn edge_name(edge: Edge) -> Value {
    Value::Term(edge_key(edge))
}

pub const fn edge_link(edge: Edge) -> Link {
    Link::to(edge.id())
}

pub fn sym(symbol: impl Into<Cow<'static, str>>) -> Formula {
    Formula::default().sym(symbol)
}

/// `t = 1/4`
pub fn equal_to(symbol: impl Into<Cow<'static, str>>, Ratio { num, den }: Ratio) -> Formula {
    sym(symbol).sym(" = ").ratio(num, den)
}

/// `3 · 11 + (−2) · 4`: numbers, each with what it is multiplied by; `times` writes that.
pub fn sum_of<T>(
    formula: Formula,
    terms: impl IntoIterator<Item = (f64, T)>,
    times: impl Fn(Formula, T) -> Formula,
) -> Formula {
    let mut is_first = true;
    terms.into_iter().fold(formula, |formula, (n, factor)| {
        let formula = if std::mem::take(&mut is_first) {
            formula.num(n)
        } else {
            formula.sym(" + ").operand(n)
        };
        times(formula, factor)
    })
}

pub fn times(formula: Formula, factor: f64) -> Formula {
    formula.sym(" · ").operand(factor)
}

/// `[7, 6]`: column and row, from the top left.
pub fn pixel_formula(pixel: [u32; 2]) -> Formula {
    let formula = Formula::decimals().sym("[");
    formula.list(&pixel.map(f64::from)).sym("]")
}

pub fn name(text: impl Into<String>) -> Value {
    Value::Name(text.into())
}

pub const fn end_symbol(end: End) -> &'static str {
    match end {
        End::P1 => "P₁",
        End::P2 => "P₂",
    }
}

pub fn end_name(end: End) -> Value {
    Value::Name(end_symbol(end).to_owned())
}

pub fn end_name_now(end: End, moved: bool) -> Value {
    Value::Name(format!(
        "{}{}",
        end_symbol(end),
        if moved { "′" } else { "" }
    ))
}

pub const fn end_link(end: End) -> Link {
    match end {
        End::P1 => Link::to("p1"),
        End::P2 => Link::to("p2"),
    }
}

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

pub fn border_equation(window: &Window, edge: Edge) -> Formula {
    sym(axis_symbol(edge.axis()))
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

/// `I₁`, `I₂`, …: whatever there are many of is numbered from 1 on screen.
pub fn numbered(letter: char, idx: usize) -> String {
    format!("{letter}{}", subscript(idx + 1))
}

pub fn vertex_symbol(vertex_idx: usize) -> String {
    numbered('V', vertex_idx)
}

/// The edge of a polygon that clips.
pub fn polygon_edge_name(edge_idx: usize) -> Value {
    name(numbered('e', edge_idx))
}

pub const fn polygon_edge_link(edge_idx: usize) -> Link {
    Link::nth("edge", edge_idx)
}

/// `H₁`, `H₂`, …: planes that have no name are called by their half-spaces.
pub fn plane_symbol(plane_idx: usize) -> String {
    numbered('H', plane_idx)
}

pub fn vertex_name(vertex_idx: usize) -> Value {
    name(vertex_symbol(vertex_idx))
}
