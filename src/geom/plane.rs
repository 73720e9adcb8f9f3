//! Closed half-planes and half-spaces, with normals pointing inside; and whether half-spaces have a point in common.

use std::{cmp::Ordering, ops::Range};

use super::{
    AlignedBox, Point, SpaceError,
    determinant::{sign_of_four, sign_of_three},
    error::finite,
    power::{exponent, times_power},
    wide::Wide,
};

/// All points `p` with `normal·(p − origin) ≥ 0`. Along an axis the normal is a unit vector, so that a signed distance is a
/// difference of coordinates and costs one rounding; elsewhere it is the edge turned by 90°, not normalised, so that it is exact
/// wherever the difference of the vertices is; but times a power of two where products with it could leave the range of f64.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct HalfPlane {
    normal: [f64; 2],
    origin: Point,
}

impl HalfPlane {
    /// With a normal of the form (±1, 0) or (0, ±1).
    pub(super) const fn axis_aligned(normal: [f64; 2], origin: Point) -> Self {
        Self { normal, origin }
    }

    /// The half-plane to the left of the edge `from → to` of a counter-clockwise outline.
    pub(super) fn left_of(from: Point, to: Point) -> Self {
        /// 2⁻¹⁰⁰ to 2¹⁰⁰
        const MODERATE: Range<f64> = 7.888_609_052_210_118e-31..1.267_650_600_228_229_4e30;
        let [mut dx, mut dy] = [to.x() - from.x(), to.y() - from.y()];
        if !MODERATE.contains(&dx.abs().max(dy.abs())) {
            [dx, dy] = direction(from, to);
        }
        let normal = if dx == 0.0 {
            [-dy.signum(), 0.0]
        } else if dy == 0.0 {
            [0.0, dx.signum()]
        } else {
            [-dy, dx]
        };
        Self {
            normal,
            origin: from,
        }
    }

    /// Points inside.
    #[must_use]
    pub const fn normal(&self) -> [f64; 2] {
        self.normal
    }

    /// A point of the border line.
    #[must_use]
    pub const fn origin(&self) -> Point {
        self.origin
    }
}

/// From a point to another one, times the power of two that brings it near length 1.
#[cold]
fn direction(from: Point, to: Point) -> [f64; 2] {
    let [from, to] = [from, to].map(|p| p.to_array().map(Wide::new));
    Wide::near_one([to[0] - from[0], to[1] - from[1]]).0
}

/// All points `p` with `n·p + d ≥ 0`. The numbers stay as they are given, so that this sign is exact wherever products and sum are;
/// but where the length of the normal is larger than any number, or has lost bits, all four are kept over a power of two.
///
/// ```
/// use clipscope::geom::Plane;
/// let plane = Plane::new([3.0, 4.0, 0.0, 5.0])?;
/// assert_eq!((plane.normal(), plane.d(), plane.length()), ([3.0, 4.0, 0.0], 5.0, 5.0));
/// # Ok::<(), clipscope::geom::SpaceError>(())
/// ```
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Plane {
    normal: [f64; 3],
    d: f64,
    length: f64,
}

impl Plane {
    /// # Errors
    /// [`SpaceError::NotFinite`]; [`SpaceError::ZeroNormal`].
    pub fn new([x, y, z, d]: [f64; 4]) -> Result<Self, SpaceError> {
        finite(&[x, y, z, d])?;
        if [x, y, z] == [0.0; 3] {
            return Err(SpaceError::ZeroNormal);
        }
        let normal = [x, y, z];
        let length = length(normal);
        // Of a plane that would be too far away for any number the normal stays as short as it is.
        if length.is_normal() || length < 1.0 && d.abs() > 1e200 {
            return Ok(Self { normal, d, length });
        }
        let exponent = if length > 1.0 { -2 } else { 100 };
        Self::new(times_power([x, y, z, d], exponent))
    }

    /// With a normal that is of length 1 but for rounding.
    pub(super) const fn unit(normal: [f64; 3], d: f64) -> Self {
        let length = 1.0;
        Self { normal, d, length }
    }

    /// n/|n|
    #[must_use]
    pub fn unit_normal(&self) -> [f64; 3] {
        self.normal.map(|x| x / self.length)
    }

    /// The other side of it.
    #[must_use]
    pub fn turned(&self) -> Self {
        Self {
            normal: self.normal.map(|x| -x),
            d: -self.d,
            ..*self
        }
    }

    /// n, pointing inside.
    #[must_use]
    pub const fn normal(&self) -> [f64; 3] {
        self.normal
    }

    /// d of n·p + d.
    #[must_use]
    pub const fn d(&self) -> f64 {
        self.d
    }

    /// |n|
    #[must_use]
    pub const fn length(&self) -> f64 {
        self.length
    }

    /// `[nx, ny, nz, d]`
    #[must_use]
    pub const fn to_array(&self) -> [f64; 4] {
        let [x, y, z] = self.normal;
        [x, y, z, self.d]
    }
}

/// The plain root is exact wherever the squares' sum is a square.
fn length(v @ [x, y, z]: [f64; 3]) -> f64 {
    let squared = x * x + y * y + z * z;
    if (1e-200..1e200).contains(&squared) {
        squared.sqrt()
    } else {
        let exponent = exponent(&v);
        let [x, y, z] = times_power(v, -exponent);
        let [length] = times_power([(x * x + y * y + z * z).sqrt()], exponent);
        length
    }
}

/// Has the box a point that lies inside all planes? Touching counts. Exact: what half-spaces have in common, if it is bounded and not
/// empty, has a vertex, on a line where two of their planes meet. No more than 2·n³ signs for n planes, the box's six counted too.
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
    (1..rows.len()).any(|i| {
        rows[..i]
            .iter()
            .any(|first| holds_a_point(&rows, first, &rows[i]))
    })
}

/// Do two planes meet in one line, and has this a point inside all of the half-spaces? The first six are those of a box.
fn holds_a_point(rows: &[[f64; 4]], a: &[f64; 4], b: &[f64; 4]) -> bool {
    // Along a × b: does a half-space begin there, or end?
    let along = |c: &[f64; 4]| sign_of_three([a, b, c].map(|&[x, y, z, _]| [x, y, z]));
    // Moved so that a, b and c meet in the origin, only the last column of the other is left: its side of that point.
    let holds =
        |c: &[f64; 4], other: &[f64; 4]| sign_of_four([*a, *b, *c, *other]) != along(c).reverse();
    let sides = [[0, 1], [2, 3], [4, 5]].map(|sides| sides.map(|side| &rows[side]));
    let crossed = sides.into_iter().find(|[lower, _]| along(lower).is_ne());
    let Some([lower, upper]) = crossed else {
        return false;
    };
    let [mut begin, mut end] = if along(lower).is_gt() {
        [lower, upper]
    } else {
        [upper, lower]
    };
    rows.iter().all(|row| {
        match along(row) {
            Ordering::Equal => return holds(begin, row),
            Ordering::Greater if !holds(begin, row) => begin = row,
            Ordering::Less if !holds(end, row) => end = row,
            Ordering::Greater | Ordering::Less => return true,
        }
        holds(begin, end)
    }) && holds(begin, end)
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
        let volume = ViewVolume::perspective(90.0, 1.0, 1.0, 10.0).unwrap();
        let planes = volume.planes().map(|plane| plane.to_array());
        assert!(!met([10.5, -1.0, -11.0, 40.0, 1.0, 20.0], &planes));
        let touches_an_edge = [10.0, -1.0, -11.0, 40.0, 1.0, 20.0];
        assert!(met(touches_an_edge, &planes));
    }
}
