//! Words, formulas and marks that several methods share.

use crate::{
    algo::line::{End, Ratio, corner_between},
    figure::{Mark, Role, Shape},
    geom::{Axis, Edge, Point, Segment, Window},
    labs::{
        crossing_formulas::{taken, upright},
        telling::Named,
        words::{
            along, axis_symbol, border_equation, edge_link, edge_name, end_link, end_name,
            end_name_now,
        },
    },
    text::Formula,
};

/// A point by its coordinates, which are those of one.
pub fn point([x, y]: [f64; 2]) -> Point {
    Point::new(x, y).unwrap_or_default()
}

/// A side that a sentence names.
pub fn side(edge: Edge) -> Named {
    Named::from(edge_name(edge)).linked(edge_link(edge))
}

/// An end as it is now, in the watch table.
pub fn end_now(end: End, at: Point) -> Named {
    Named::from(at.to_array()).linked(end_link(end))
}

/// Both ends by their coordinates.
pub fn ends(segment: Segment) -> [[f64; 2]; 2] {
    [segment.p1, segment.p2].map(Point::to_array)
}

/// The original segment, what is left of it, and its ends.
///
/// Discarded parts are ghosted; what is left is accented while it is alive, green once accepted. A segment that is
/// rejected is dashed, but in ink: it carries the point.
pub fn segment_marks(original: &Segment, ends: [Point; 2], is_visible: Option<bool>) -> Vec<Mark> {
    let rejected = is_visible == Some(false);
    let role = match is_visible {
        None => Role::Accent,
        Some(false) => Role::Ink,
        Some(true) => Role::Accepted,
    };
    let mut marks = Vec::new();
    for end in End::BOTH {
        let (from, to) = (end.of(original), ends[end.idx()]);
        if from != to {
            let ghost = Shape::Segment([from.to_array(), to.to_array()]);
            marks.push(Mark::new(Role::Discarded, ghost));
        }
    }
    let left = Shape::Segment([ends[0].to_array(), ends[1].to_array()]);
    let left = Mark::new(role, left).linked("segment");
    marks.push(if rejected { left.dashed() } else { left });
    for end in End::BOTH {
        let (from, to) = (end.of(original), ends[end.idx()]);
        let moved = from != to;
        let given = match (moved, rejected) {
            (true, _) => Role::Discarded,
            (false, true) => Role::Ink,
            (false, false) => Role::Accent,
        };
        marks.push(
            Mark::new(given, Shape::Ring(from.to_array()))
                .labelled(end_name(end))
                .strong()
                .linked(end_link(end)),
        );
        if moved {
            marks.push(
                Mark::new(role, Shape::Dot(to.to_array()))
                    .labelled(end_name_now(end, true))
                    .strong()
                    .linked(end_link(end)),
            );
        }
    }
    marks
}

/// How an end came to its place on a side. Where the segment only touches the corner between the `sides` by which it
/// comes in and goes out, nothing is computed.
pub fn put_formulas(
    segment: &Segment,
    window: &Window,
    edge: Edge,
    at: Point,
    sides: Option<[Edge; 2]>,
) -> Vec<Formula> {
    let corner = sides.and_then(|sides| corner_between(window, sides));
    if corner == Some(at) {
        taken(edge.axis(), at)
    } else {
        upright(segment, edge.axis(), window.border(edge), at)
    }
}

/// `Δx = 0`: why there is no crossing.
pub fn parallel_formula(segment: &Segment, edge: Edge) -> Formula {
    let (symbol, axis) = match edge.axis() {
        Axis::X => ("x₁ = x₂ = ", Axis::X),
        Axis::Y => ("y₁ = y₂ = ", Axis::Y),
    };
    Formula::default()
        .sym(symbol)
        .num(along(segment.p1, axis)[0])
}

/// Catalogue key of a side's bare name.
pub const fn side_key(edge: Edge) -> &'static str {
    match edge {
        Edge::Left => "side-left",
        Edge::Right => "side-right",
        Edge::Bottom => "side-bottom",
        Edge::Top => "side-top",
    }
}

/// The line of a side, as this step's subject.
pub fn border_mark(window: &Window, edge: Edge) -> Mark {
    Mark::new(
        Role::Signal,
        Shape::Border(edge.axis(), window.border(edge)),
    )
    .labelled(border_equation(window, edge))
    .linked(edge_link(edge))
}

/// The line of a side with what holds inside it: `y ≤ 1`.
pub fn inside_mark(window: &Window, edge: Edge) -> Mark {
    let relation = if edge.is_max() { " ≤ " } else { " ≥ " };
    let [x, y] = outwards(edge);
    let border = Shape::Border(edge.axis(), window.border(edge));
    Mark::new(Role::Soft, border)
        .labelled(side_formula(window, edge, relation))
        .toward([-x, -y])
        .linked(edge_link(edge))
}

/// A side as this step's subject: its line with `y = 1`, and what lies beyond it with `y > 1`.
pub fn outside_marks(window: &Window, edge: Edge) -> [Mark; 2] {
    let c = window.border(edge);
    // What lies beyond is to the left of the line from the first point to the second.
    let line = match edge {
        Edge::Left => [[c, 0.0], [c, 1.0]],
        Edge::Right => [[c, 1.0], [c, 0.0]],
        Edge::Bottom => [[1.0, c], [0.0, c]],
        Edge::Top => [[0.0, c], [1.0, c]],
    };
    let relation = if edge.is_max() { " > " } else { " < " };
    let border = Mark::new(Role::Signal, Shape::Border(edge.axis(), c));
    [
        Mark::new(Role::Signal, Shape::HalfPlane(line))
            .labelled(border_equation(window, edge))
            .linked(edge_link(edge)),
        border
            .labelled(side_formula(window, edge, relation))
            .toward(outwards(edge)),
    ]
}

/// The direction out of the window across a side.
const fn outwards(edge: Edge) -> [f64; 2] {
    match edge {
        Edge::Left => [-1.0, 0.0],
        Edge::Right => [1.0, 0.0],
        Edge::Bottom => [0.0, -1.0],
        Edge::Top => [0.0, 1.0],
    }
}

/// `y > 1`
fn side_formula(window: &Window, edge: Edge, relation: &'static str) -> Formula {
    Formula::default()
        .sym(axis_symbol(edge.axis()))
        .sym(relation)
        .num(window.border(edge))
}

/// A crossing, as this step's subject: `t = 1/4`.
pub fn crossing_mark(at: Point, symbol: &'static str, u: Ratio) -> Mark {
    let label = Formula::default()
        .sym(symbol)
        .sym(" = ")
        .ratio(u.num, u.den);
    Mark::new(Role::Signal, Shape::Dot(at.to_array()))
        .labelled(label)
        .strong()
}

/// Catalogue key of the region of a point that lies beyond the sides for which `beyond` is true.
pub fn region_key(beyond: impl Fn(Edge) -> bool) -> &'static str {
    let column = usize::from(beyond(Edge::Right)) + 1 - usize::from(beyond(Edge::Left));
    let row = usize::from(beyond(Edge::Top)) + 1 - usize::from(beyond(Edge::Bottom));
    [
        ["region-below-left", "region-below", "region-below-right"],
        ["region-left", "region-inside", "region-right"],
        ["region-above-left", "region-above", "region-above-right"],
    ][row][column]
}
