//! Matrices of four rows for column vectors.

use super::{SpaceError, error::finite};

/// Four rows of four: `to = matrix · from`.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Matrix([[f64; 4]; 4]);

impl Matrix {
    /// Leaves everything where it is.
    pub const IDENTITY: Self = Self([
        [1.0, 0.0, 0.0, 0.0],
        [0.0, 1.0, 0.0, 0.0],
        [0.0, 0.0, 1.0, 0.0],
        [0.0, 0.0, 0.0, 1.0],
    ]);

    /// # Errors
    /// [`SpaceError::NotFinite`]
    pub fn new(rows: [[f64; 4]; 4]) -> Result<Self, SpaceError> {
        finite(rows.as_flattened()).map(|()| Self(rows))
    }

    /// From finite rows of which the last is 0 0 0 1. It may be singular.
    ///
    /// # Errors
    /// [`SpaceError::NotFinite`]; [`SpaceError::NotAffine`].
    pub fn affine(rows: [[f64; 4]; 4]) -> Result<Self, SpaceError> {
        let matrix = Self::new(rows)?;
        if rows[3] == Self::IDENTITY.0[3] {
            Ok(matrix)
        } else {
            Err(SpaceError::NotAffine)
        }
    }

    /// Of rows that the caller knows to be finite.
    pub(super) const fn from_rows(rows: [[f64; 4]; 4]) -> Self {
        Self(rows)
    }

    /// The rows.
    #[must_use]
    pub const fn rows(&self) -> [[f64; 4]; 4] {
        self.0
    }

    /// First `other`, then this.
    #[must_use]
    pub fn after(&self, other: &Self) -> Self {
        let row = |row: &[f64; 4]| {
            let terms = |column: usize| {
                row.iter()
                    .zip(&other.0)
                    .map(move |(a, from)| a * from[column])
            };
            std::array::from_fn(|column| terms(column).sum())
        };
        Self(self.0.each_ref().map(row))
    }

    /// Of a vector of four.
    #[inline]
    #[must_use]
    pub fn times(&self, [x, y, z, w]: [f64; 4]) -> [f64; 4] {
        // Row by row, without a copy of the matrix.
        let [p, q, r, s] = &self.0;
        [p, q, r, s].map(|[a, b, c, d]| a * x + b * y + c * z + d * w)
    }

    /// Of a point; `matrix` is affine.
    #[inline]
    #[must_use]
    pub fn point(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        let [x, y, z, _] = self.times([x, y, z, 1.0]);
        [x, y, z]
    }

    /// Moves by this much.
    #[must_use]
    pub const fn translation([x, y, z]: [f64; 3]) -> Self {
        Self([
            [1.0, 0.0, 0.0, x],
            [0.0, 1.0, 0.0, y],
            [0.0, 0.0, 1.0, z],
            [0.0, 0.0, 0.0, 1.0],
        ])
    }

    /// Makes everything larger by this factor, from the origin.
    #[must_use]
    pub const fn scale(factor: f64) -> Self {
        Self([
            [factor, 0.0, 0.0, 0.0],
            [0.0, factor, 0.0, 0.0],
            [0.0, 0.0, factor, 0.0],
            [0.0, 0.0, 0.0, 1.0],
        ])
    }

    /// Turns about x, then y, then z, by angles in radians, counter-clockwise as seen from where an axis points to.
    #[must_use]
    pub fn rotation([about_x, about_y, about_z]: [f64; 3]) -> Self {
        let about = |axis: usize, angle: f64| {
            let (sin, cos) = libm::sincos(angle);
            let [i, j] = [(axis + 1) % 3, (axis + 2) % 3];
            let mut rows = Self::IDENTITY.0;
            rows[i][i] = cos;
            rows[i][j] = -sin;
            rows[j][i] = sin;
            rows[j][j] = cos;
            Self(rows)
        };
        about(2, about_z)
            .after(&about(1, about_y))
            .after(&about(0, about_x))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_after_the_other() {
        let moved = Matrix::translation([1.0, 2.0, 3.0]);
        let larger = Matrix::scale(2.0);
        let at = [1.0, 0.0, -1.0];
        assert_eq!(larger.after(&moved).point(at), [4.0, 4.0, 4.0]);
        assert_eq!(moved.after(&larger).point(at), [3.0, 2.0, 1.0]);
        assert_eq!(Matrix::IDENTITY.after(&moved), moved);
    }

    #[test]
    fn a_quarter_turn_leads_from_each_axis_to_the_next() {
        let quarter = std::f64::consts::FRAC_PI_2;
        let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        for about in 0..3 {
            let mut angles = [0.0; 3];
            angles[about] = quarter;
            let turned = Matrix::rotation(angles).point(axes[(about + 1) % 3]);
            for (found, expected) in turned.iter().zip(axes[(about + 2) % 3]) {
                assert!((found - expected).abs() < 1e-15, "{about}: {turned:?}");
            }
        }
    }
}
