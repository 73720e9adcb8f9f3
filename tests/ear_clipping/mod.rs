//! What `EarClipping` and `TriangulateAndClip` of `clipscope::algo::polygon` promise, held to it.
//!
//! - `cases`: named outlines, with the triangles that they give.
//! - `properties`: random simple outlines, most of them on small grids, where degenerate ones are common.
//! - `pieces`: triangulated, then clipped.
//! - `rivals`: who blocks a candidate.
//! - `outlines`: where the random ones come from.

mod cases;
mod outlines;
mod pieces;
mod properties;
mod rivals;

use std::collections::HashSet;

use clipscope::{
    algo::polygon::{EarClipping, Triangle},
    geom::{Point, SimplePolygon},
    trace::silent,
};

/// On a grid, where every area is exact.
type Outline = Vec<[i64; 2]>;

fn polygon(outline: &[[i64; 2]]) -> SimplePolygon {
    let floats: Vec<[f64; 2]> = outline.iter().map(|p| p.map(|x| x as f64)).collect();
    SimplePolygon::new(&floats).expect("simple")
}

/// Twice the signed area.
fn double_area(outline: &[[i64; 2]]) -> i64 {
    let n = outline.len();
    (0..n)
        .map(|i| {
            let ([x1, y1], [x2, y2]) = (outline[i], outline[(i + 1) % n]);
            x1 * y2 - x2 * y1
        })
        .sum()
}

/// Triangulates, and checks what makes it a triangulation.
fn triangulated(outline: &[[i64; 2]]) -> Vec<Triangle> {
    let polygon = polygon(outline);
    let triangles = silent::<EarClipping>(&polygon).triangles().to_vec();
    let corners = |triangle: &Triangle| triangle.map(|i| outline[i]);
    for triangle in &triangles {
        assert!(
            double_area(&corners(triangle)) > 0,
            "{triangle:?} of {outline:?} runs counter-clockwise"
        );
    }
    let sum: i64 = triangles.iter().map(|t| double_area(&corners(t))).sum();
    assert_eq!(sum, double_area(outline), "the area of {outline:?}");
    assert_tiles(polygon.vertices(), &triangles);
    triangles
}

/// Each edge of the outline belongs to one triangle, each other side is shared by two that walk it in opposite
/// directions. So the triangles' sides add up to the outline; and as every triangle runs counter-clockwise, a
/// point lies in as many of them as the outline runs around it: in one if it is inside, in none outside.
fn assert_tiles(outline: &[Point], triangles: &[Triangle]) {
    let n = outline.len();
    assert_eq!(triangles.len(), n - 2, "triangles of {outline:?}");
    let mut sides = HashSet::new();
    for [a, b, c] in triangles {
        for side in [[*a, *b], [*b, *c], [*c, *a]] {
            assert!(sides.insert(side), "side {side:?} twice in {outline:?}");
        }
    }
    for vertex_idx in 0..n {
        let edge = [vertex_idx, (vertex_idx + 1) % n];
        assert!(sides.remove(&edge), "edge {edge:?} of {outline:?}");
    }
    for [a, b] in &sides {
        assert!(
            sides.contains(&[*b, *a]),
            "nothing on the other side of {a}–{b} in {outline:?}"
        );
    }
}
