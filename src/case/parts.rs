//! Parts of a case that several labs read: windows and convex polygons.

use crate::{
    geom::{ConvexPolygon, Edge, Point, Window},
    text::{Formula, Value},
};

use super::{Detail, Given, Node, Refusal};

/// A report of a clip polygon with more vertices than this is refused: a step's table of values has a row an edge, and
/// a report a step an edge, so that its length grows with the square.
const MAX_VERTICES: usize = 1024;

pub(super) fn read_window(node: &Node<'_>) -> Result<Window, Refusal> {
    let [xmin, ymin, xmax, ymax] = node.numbers()?;
    Window::new(xmin, ymin, xmax, ymax).map_err(|error| Refusal::geometry(&node.path, error))
}

pub(super) fn read_clip(node: &Node<'_>, detail: Detail) -> Result<ConvexPolygon, Refusal> {
    let outline: Vec<[f64; 2]> = node.points(detail.limit(MAX_VERTICES))?;
    ConvexPolygon::new(&outline).map_err(|error| Refusal::geometry(&node.path, error))
}

/// The clip polygon's corners.
pub(super) fn given_clip(vertices: &[Point]) -> Given {
    let values = vertices.iter().map(|p| p.to_array().into());
    Given::new("object-clip-polygon", values)
}

/// `−1 ≤ x ≤ 1`, `−1 ≤ y ≤ 1`: closed.
pub(super) fn given_window(window: &Window) -> Given {
    let range = |low, symbol, high| {
        let formula = Formula::default().num(window.border(low));
        Value::Formula(formula.sym(symbol).num(window.border(high)))
    };
    let ranges = [
        range(Edge::Left, " ≤ x ≤ ", Edge::Right),
        range(Edge::Bottom, " ≤ y ≤ ", Edge::Top),
    ];
    Given::new("object-window", ranges.into_iter())
}
