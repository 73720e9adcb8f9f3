//! Triangles as names, marks, rows and JSON: what ear clipping and clipping triangle by triangle share.

use serde_json::{Value as Json, json};

use crate::{
    algo::polygon::{Triangle, Triangulation},
    figure::{Link, Mark, Role, Shape},
    geom::Point,
    labs::{
        telling::Named,
        words::{name, subscript, vertex_symbol},
    },
    text::Value,
};

/// Rows of the table of triangles: the last ones.
const MAX_ROWS: usize = 8;
/// Up to this number of triangles each is filled.
const FEW_ENOUGH: usize = 200;

/// `V₁V₂V₃`.
pub fn triangle_name(triangle: Triangle) -> Value {
    name(triangle.map(vertex_symbol).concat())
}

/// What marks and rows about a triangle have in common.
pub const fn triangle_link(triangle_idx: usize) -> Link {
    Link::nth("triangle", triangle_idx)
}

/// Where its vertices are.
pub fn points_of(whole: &Triangulation, triangle: Triangle) -> Vec<[f64; 2]> {
    whole.corners(triangle).map(Point::to_array).to_vec()
}

/// A dot for a convex vertex, a ring for any other.
pub fn vertex_mark(role: Role, is_convex: bool, at: Point) -> Mark {
    let at = at.to_array();
    let shape = if is_convex {
        Shape::Dot(at)
    } else {
        Shape::Ring(at)
    };
    Mark::new(role, shape)
}

/// What has been cut off: filled, or only the diagonals where there are many.
pub fn cut_off_marks(whole: &Triangulation) -> Vec<Mark> {
    let triangles = whole.triangles();
    if triangles.len() > FEW_ENOUGH {
        let diagonals = triangles.iter().map(|&triangle| {
            let [from, _, to] = whole.corners(triangle).map(Point::to_array);
            [from, to]
        });
        return vec![Mark::new(Role::Accepted, Shape::Crowd(diagonals.collect()))];
    }
    let mark = |(triangle_idx, &triangle)| {
        let area = Shape::Area(vec![points_of(whole, triangle)]);
        Mark::new(Role::Accepted, area).linked(triangle_link(triangle_idx))
    };
    triangles.iter().enumerate().map(mark).collect()
}

/// The last triangles that were cut off, for the watch table.
pub fn named_triangles(whole: &Triangulation) -> Vec<Named> {
    let triangles = whole.triangles();
    let named = |(triangle_idx, &triangle)| {
        let label = name(format!("T{}", subscript(triangle_idx + 1)));
        let triangle = Named::from(triangle_name(triangle)).labelled(label);
        triangle.linked(triangle_link(triangle_idx))
    };
    let shown = triangles.iter().enumerate();
    shown.skip(part_of(whole)[0]).map(named).collect()
}

/// How many triangles come before those of the watch table, and how many there are.
pub fn part_of(whole: &Triangulation) -> [usize; 2] {
    let n = whole.triangles().len();
    [n.saturating_sub(MAX_ROWS), n]
}

/// Corners, and the numbers of the vertices that they are.
pub fn triangles_json(whole: &Triangulation) -> Json {
    let triangles = whole.triangles();
    let corners: Vec<[Point; 3]> = triangles.iter().map(|&t| whole.corners(t)).collect();
    json!({ "triangles": corners, "vertices": triangles })
}
