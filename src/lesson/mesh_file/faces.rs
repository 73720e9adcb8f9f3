//! Faces of any number of corners as triangles.

use glam::DVec3;

use crate::{
    algo::polygon::EarClipping,
    geom::{Point, SimplePolygon, orientation},
    trace::silent,
};

/// The triangles of a face, by the places of their corners in its list; `None` where the face, seen along its normal, has no
/// area or meets itself.
///
/// Three corners are one triangle, of four that turn one way the fan is taken; everything else is cut by ear clipping, seen
/// along the axis that its normal is nearest to.
pub(super) fn triangles(corners: &[[f32; 3]]) -> Option<Vec<[usize; 3]>> {
    if corners.len() == 3 {
        return Some(vec![[0, 1, 2]]);
    }
    let points = corners.iter().map(|p| DVec3::from(p.map(f64::from)));
    let points: Vec<DVec3> = points.collect();
    let normal: DVec3 = (2..points.len())
        .map(|i| (points[i - 1] - points[0]).cross(points[i] - points[0]))
        .sum();
    let [x, y, z] = normal.abs().to_array();
    let axis = if x >= y && x >= z {
        0
    } else if y >= z {
        1
    } else {
        2
    };
    let [across, up] = if normal[axis] > 0.0 {
        [(axis + 1) % 3, (axis + 2) % 3]
    } else {
        [(axis + 2) % 3, (axis + 1) % 3]
    };
    let flat: Vec<[f64; 2]> = points.iter().map(|p| [p[across], p[up]]).collect();
    if flat.len() == 4 && turns_one_way(&flat) {
        return Some(vec![[0, 1, 2], [0, 2, 3]]);
    }
    let polygon = SimplePolygon::new(&flat).ok()?;
    let cut = silent::<EarClipping>(&polygon);
    let place = |p: [f64; 2]| flat.iter().position(|&corner| corner == p);
    cut.triangles()
        .iter()
        .map(|&triangle| {
            let [a, b, c] = cut.corners(triangle).map(|p| place(p.to_array()));
            Some([a?, b?, c?])
        })
        .collect()
}

/// Do its corners not lie on one line?
pub(super) fn has_area(triangle: [[f32; 3]; 3]) -> bool {
    let [a, b, c] = triangle.map(|p| DVec3::from(p.map(f64::from)));
    (b - a).cross(c - a) != DVec3::ZERO
}

/// Is every corner of four a turn to the left? Then they go round once.
fn turns_one_way(corners: &[[f64; 2]]) -> bool {
    let points = corners.iter().map(|&[x, y]| Point::new(x, y).ok());
    let Some(points) = points.collect::<Option<Vec<Point>>>() else {
        return false;
    };
    let n = points.len();
    let turn = |i: usize| orientation(points[i], points[(i + 1) % n], points[(i + 2) % n]);
    (0..n).all(|i| turn(i).is_gt())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn concave_faces_keep_their_shape_and_their_side() {
        // An L in the plane x = 1, counter-clockwise as seen from +x, and the same from the other side.
        let corners = [[0, 0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2]];
        let mut corners: Vec<[f32; 3]> = corners.map(|[y, z]| [1.0, y as f32, z as f32]).to_vec();
        for side in [1.0, -1.0] {
            let found = triangles(&corners).unwrap();
            assert_eq!(found.len(), 4);
            let area: f64 = found
                .iter()
                .map(|face| {
                    let [a, b, c] = face.map(|i| DVec3::from(corners[i].map(f64::from)));
                    0.5 * (b - a).cross(c - a).x
                })
                .sum();
            assert_eq!(area, 3.0 * side);
            corners.reverse();
        }
    }

    /// In the plane z = 5.
    fn flat<const N: usize>(corners: [[f32; 2]; N]) -> Option<Vec<[usize; 3]>> {
        triangles(&corners.map(|[x, y]| [x, y, 5.0]))
    }

    #[test]
    fn what_meets_itself_or_has_no_area_is_none() {
        assert_eq!(flat([[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]]), None);
        assert_eq!(triangles(&[[0.0; 3], [1.0; 3], [2.0; 3], [3.0; 3]]), None);
    }

    #[test]
    fn four_corners_are_fanned_where_they_turn_one_way() {
        let square = flat([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
        assert_eq!(square, Some(vec![[0, 1, 2], [0, 2, 3]]));
        // A dart's fan from its first corner would leave it.
        let dart = flat([[0.0, 0.0], [2.0, 1.0], [0.0, 2.0], [0.5, 1.0]]);
        let mut cut = dart.expect("a dart").concat();
        cut.sort_unstable();
        let from_the_last = [0, 1, 1, 2, 3, 3];
        assert_eq!(cut, from_the_last, "cut from the corner that turns back");
    }
}
