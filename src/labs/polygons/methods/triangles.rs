//! Triangles as names, marks, rows and JSON: what ear clipping and clipping triangle by triangle share.

use crate::algo::polygon::{Triangle, Triangulation};

use super::prelude::*;

const MAX_ROWS: usize = 8;
const FEW_ENOUGH: usize = 200;

/// `V₁V₂V₃`.
pub fn triangle_name(triangle: Triangle) -> Value {
    name(triangle.map(vertex_symbol).concat())
}

pub const fn triangle_link(triangle_idx: usize) -> Link {
    Link::nth("triangle", triangle_idx)
}

pub fn points_of(whole: &Triangulation, triangle: Triangle) -> Vec<[f64; 2]> {
    whole.corners(triangle).map(Point::to_array).to_vec()
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

pub fn named_triangles(whole: &Triangulation) -> Vec<Named> {
    let triangles = whole.triangles();
    let named = |(triangle_idx, &triangle)| {
        let label = name(numbered('T', triangle_idx));
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
