//! A closed half-plane: the plane of 2D clipping, with its normal pointing inside.

use super::Point;

/// All points `p` with `normal·(p − origin) ≥ 0`.
///
/// Along an axis the normal is a unit vector, so that a signed distance is a plain difference of
/// coordinates and costs one rounding; elsewhere it is the edge turned by 90°, not normalised, so that
/// it is exact wherever the difference of the vertices is.
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
        let [mut dx, mut dy] = [to.x() - from.x(), to.y() - from.y()];
        if !(dx.is_finite() && dy.is_finite()) {
            // Only the direction counts: half of each cannot overflow.
            [dx, dy] = [0.5 * to.x() - 0.5 * from.x(), 0.5 * to.y() - 0.5 * from.y()];
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
