//! Have closed half-spaces a point in common? Decided exactly, on the planes' numbers as they are.
//!
//! What half-spaces have in common, if it is bounded and not empty, has a vertex: a point where three of their planes
//! meet. So it is enough to ask, of each three planes that meet in a point, whether that point lies inside all the others:
//! the sign of a determinant of four rows over that of three.

use std::cmp::Ordering;

use super::{
    AlignedBox, Plane,
    determinant::{sign_of_four, sign_of_three},
};

/// Has the box a point that lies inside all planes? Touching counts.
///
/// Exact for numbers whose products of four neither overflow nor vanish, say between 10⁻⁷⁰ and 10⁷⁰. About n⁴/6 signs
/// for n planes and the box's six: meant for the few planes of a volume.
#[must_use]
pub fn meets(bounds: &AlignedBox, planes: &[Plane]) -> bool {
    let mut rows: Vec<[f64; 4]> = Vec::with_capacity(planes.len() + 6);
    for axis in 0..3 {
        for (sign, border) in [(1.0, bounds.min()[axis]), (-1.0, bounds.max()[axis])] {
            let mut row = [0.0, 0.0, 0.0, -sign * border];
            row[axis] = sign;
            rows.push(row);
        }
    }
    rows.extend(planes.iter().map(Plane::to_array));
    let n = rows.len();
    let mut triples =
        (0..n).flat_map(|i| (i + 1..n).flat_map(move |j| (j + 1..n).map(move |k| [i, j, k])));
    triples.any(|triple| holds_a_vertex(&rows, triple))
}

/// Do three planes meet in one point, and does it lie inside all the others?
fn holds_a_vertex(rows: &[[f64; 4]], triple: [usize; 3]) -> bool {
    let [a, b, c] = triple.map(|i| rows[i]);
    let across = sign_of_three([a, b, c].map(|[x, y, z, _]| [x, y, z]));
    if across == Ordering::Equal {
        return false;
    }
    // Moved so that the three meet in the origin, only the last column of the fourth is left: its side of that point.
    (0..rows.len())
        .filter(|i| !triple.contains(i))
        .all(|i| sign_of_four([a, b, c, rows[i]]) != across.reverse())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geom::ViewVolume;

    fn met(bounds: [f64; 6], planes: &[[f64; 4]]) -> bool {
        let planes: Vec<Plane> = planes.iter().map(|&p| Plane::new(p).unwrap()).collect();
        meets(&AlignedBox::new(bounds).unwrap(), &planes)
    }

    #[test]
    fn touching_counts_and_an_ulp_beyond_does_not() {
        let cube = [-1.0, -1.0, -1.0, 1.0, 1.0, 1.0];
        let corner = |d: f64| met(cube, &[[0.1, 0.1, 0.1, d]]);
        // Three times the stored 0.1 lies between two numbers; rounding takes the upper one.
        let upper = 0.1 + 0.1 + 0.1;
        assert!(corner(-f64::next_down(upper)));
        assert!(!corner(-upper));
        assert!(met(cube, &[]));
        let point = [1.0, 2.0, 3.0, 1.0, 2.0, 3.0];
        assert!(met(point, &[[1.0, 0.0, 0.0, -1.0], [0.0, -1.0, 0.0, 2.0]]));
        assert!(!met(point, &[[1.0, 0.0, 0.0, -1.0_f64.next_up()]]));
    }

    #[test]
    fn two_planes_that_the_box_straddles_may_leave_nothing() {
        // A flat wedge that ends before the box.
        let planes = [[1.0, 4.0, 0.0, -4.0], [1.0, -4.0, 0.0, -4.0]];
        assert!(!met([-3.0, -3.0, 0.0, 3.0, 3.0, 1.0], &planes));
        assert!(met([-3.0, -3.0, 0.0, 4.0, 3.0, 1.0], &planes), "its edge");
    }

    #[test]
    fn the_large_box_beside_a_frustum() {
        let planes = ViewVolume::perspective(90.0, 1.0, 1.0, 10.0)
            .unwrap()
            .planes();
        let meets = |bounds| meets(&AlignedBox::new(bounds).unwrap(), &planes);
        assert!(!meets([10.5, -1.0, -11.0, 40.0, 1.0, 20.0]));
        assert!(
            meets([10.0, -1.0, -11.0, 40.0, 1.0, 20.0]),
            "it touches an edge"
        );
    }
}
