//! Triangles in clip space.

use clipscope::{
    algo::volume::{ClipVertex, HomogeneousTriangle, SideCode, clip_triangles},
    trace::{laws, silent},
};
use proptest::prelude::*;

/// Its attributes say how much of each corner is in it.
type Weighted = ClipVertex<[f64; 3]>;

fn triangle(corners: [[f64; 4]; 3]) -> [Weighted; 3] {
    std::array::from_fn(|i| {
        let mut attributes = [0.0; 3];
        attributes[i] = 1.0;
        ClipVertex {
            at: corners[i],
            attributes,
        }
    })
}

fn corner() -> impl Strategy<Value = [i64; 4]> {
    prop::array::uniform4(-6..7_i64)
}

fn numbers(at: [i64; 4]) -> [f64; 4] {
    at.map(|x| x as f64)
}

fn odd_number() -> impl Strategy<Value = f64> {
    prop_oneof![
        -3.0..3.0,
        Just(0.0),
        Just(1.0),
        Just(-1.0),
        Just(5e-324),
        Just(-1e-300),
        Just(1e300),
        Just(f64::MAX),
        Just(f64::MIN),
        Just(1.0 + f64::EPSILON),
    ]
}

/// The cuts of the edge between the first two corners: of the third there is nothing in them.
fn on_first_edge(polygon: &[Weighted]) -> Vec<[u64; 4]> {
    let on_edge = polygon.iter().filter(|v| v.attributes[2] == 0.0);
    let mut bits: Vec<[u64; 4]> = on_edge.map(|v| v.at.map(|x| (x + 0.0).to_bits())).collect();
    bits.sort_unstable();
    bits.dedup();
    bits
}

proptest! {
    #[test]
    fn laws_and_closedness(corners in prop::array::uniform3(corner())) {
        let input = triangle(corners.map(numbers));
        laws::check::<HomogeneousTriangle<[f64; 3]>>(&input);
        let polygon = silent::<HomogeneousTriangle<[f64; 3]>>(&input);
        for vertex in polygon.vertices() {
            prop_assert!(SideCode::of(vertex.at).is_inside(), "{vertex:?} of {corners:?}");
        }
        for fan in polygon.triangles() {
            let again = silent::<HomogeneousTriangle<[f64; 3]>>(&fan);
            prop_assert_eq!(again.vertices(), &fan[..], "clipped again it stays");
        }
    }

    #[test]
    fn many_triangles_are_clipped_as_each_by_itself(
        corners in prop::collection::vec(prop::array::uniform3(corner()), 0..20),
    ) {
        let given: Vec<_> = corners.iter().map(|corners| triangle(corners.map(numbers))).collect();
        let mut left = Vec::new();
        clip_triangles(&given, &mut left);
        let polygons = given.iter().map(silent::<HomogeneousTriangle<[f64; 3]>>);
        let one_by_one: Vec<_> = polygons.flat_map(|p| p.triangles().collect::<Vec<_>>()).collect();
        prop_assert_eq!(left, one_by_one);
    }

    #[test]
    fn no_number_is_too_odd(corners in prop::array::uniform3(prop::array::uniform4(odd_number()))) {
        let input = triangle(corners);
        laws::check::<HomogeneousTriangle<[f64; 3]>>(&input);
        let polygon = silent::<HomogeneousTriangle<[f64; 3]>>(&input);
        for vertex in polygon.vertices() {
            prop_assert!(vertex.at.iter().all(|x| x.is_finite()), "{vertex:?} of {corners:?}");
            prop_assert!(SideCode::of(vertex.at).is_inside(), "{vertex:?} of {corners:?}");
        }
    }

    /// Two triangles with a common edge, each walking it its own way.
    #[test]
    fn neighbours_share_their_cuts(
        corners in prop::array::uniform4(prop::array::uniform4(-3.0..3.0_f64)),
    ) {
        let [a, b, c, d] = corners;
        let one = silent::<HomogeneousTriangle<[f64; 3]>>(&triangle([a, b, c]));
        let other = silent::<HomogeneousTriangle<[f64; 3]>>(&triangle([b, a, d]));
        let cuts = [one, other].map(|polygon| on_first_edge(polygon.vertices()));
        if cuts.iter().all(|cuts| cuts.len() > 1) {
            prop_assert_eq!(&cuts[0], &cuts[1]);
        }
    }

    /// A point of the triangle, as whole shares of its corners, is in the polygon where it is in the volume.
    #[test]
    fn what_is_left_is_what_is_inside(
        corners in prop::array::uniform3(corner()),
        shares in prop::collection::vec(prop::array::uniform3(0..20_i64), 20),
    ) {
        let polygon = silent::<HomogeneousTriangle<[f64; 3]>>(&triangle(corners.map(numbers)));
        let outline: Vec<[f64; 2]> = polygon.vertices().iter().map(|v| [v.attributes[1], v.attributes[2]]).collect();
        for [i, j, k] in shares {
            let whole = i + j + k;
            if whole == 0 {
                continue;
            }
            let at: [i64; 4] = std::array::from_fn(|n| i * corners[0][n] + j * corners[1][n] + k * corners[2][n]);
            let [x, y, z, w] = at;
            let is_inside = [x, y, z].iter().all(|&a| -w <= a && a <= w);
            if is_inside && [x, y, z].iter().any(|&a| a.abs() == w) {
                // On the border: where that is all there is, a sliver as thin as rounding is left, or nothing.
                continue;
            }
            let p = [j as f64 / whole as f64, k as f64 / whole as f64];
            if let Some(found) = holds(&outline, p) {
                prop_assert_eq!(found, is_inside, "{:?} of {:?}", [i, j, k], corners);
            }
        }
    }
}

/// Is p in the convex outline, which runs counter-clockwise? `None` too near to an edge to tell.
fn holds(outline: &[[f64; 2]], p: [f64; 2]) -> Option<bool> {
    let next = outline.iter().cycle().skip(1);
    let turns = outline.iter().zip(next).filter_map(|(a, b)| {
        let edge = [b[0] - a[0], b[1] - a[1]];
        let length = edge[0].hypot(edge[1]);
        // An edge as short as rounding has any direction.
        (length > 1e-6).then(|| (edge[0] * (p[1] - a[1]) - edge[1] * (p[0] - a[0])) / length)
    });
    let least = turns.fold(f64::INFINITY, f64::min);
    if outline.len() < 3 {
        // Nothing, or a touch: every other point is outside.
        let near = |a: &[f64; 2]| (a[0] - p[0]).abs() + (a[1] - p[1]).abs() < 1e-9;
        return (outline.is_empty() || !outline.iter().any(near) && outline.len() == 1)
            .then_some(false);
    }
    (least.is_finite() && least.abs() > 1e-8).then_some(least > 0.0)
}

#[test]
fn clipped_coordinates_are_assigned() {
    let polygon = silent::<HomogeneousTriangle<[f64; 3]>>(&triangle([
        [0.1, 0.2, 0.3, 1.0],
        [7.3, 0.4, 0.1, 1.7],
        [0.3, 9.1, 0.2, -0.7],
    ]));
    let cut = polygon
        .vertices()
        .iter()
        .filter(|v| !v.attributes.contains(&1.0));
    let mut n = 0;
    for vertex in cut {
        let [x, y, z, w] = vertex.at;
        assert!([x, y, z].iter().any(|a| a.abs() == w), "{vertex:?}");
        n += 1;
    }
    assert!(n >= 2);
}

#[test]
fn a_triangle_without_area_is_left_out() {
    let line = triangle([
        [0.0, 0.0, 0.0, 1.0],
        [0.5, 0.5, 0.0, 1.0],
        [1.0, 1.0, 0.0, 2.0],
    ]);
    let polygon = silent::<HomogeneousTriangle<[f64; 3]>>(&line);
    assert_eq!(polygon.vertices().len(), 3, "it is kept whole");
    assert_eq!(polygon.triangles().count(), 0, "and has nothing to fill");
    let edge_on = triangle([
        [0.0, 0.0, 0.0, 1.0],
        [0.0, 0.5, 0.0, 1.0],
        [0.0, 0.5, 0.5, 1.0],
    ]);
    assert_eq!(
        silent::<HomogeneousTriangle<[f64; 3]>>(&edge_on)
            .triangles()
            .count(),
        1,
        "edge-on it still has an area in space"
    );
}
