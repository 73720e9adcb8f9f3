//! A closed half-space: a plane in space, with its normal pointing inside.

use super::{SpaceError, space_error::finite};

/// All points `p` with `n·p + d ≥ 0`.
///
/// The numbers stay as they are given, so that the sign of `n·p + d` is exact wherever products and sum are; a distance is
/// that divided by |n|.
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
    /// `[nx, ny, nz, d]`.
    ///
    /// # Errors
    /// [`SpaceError::NotFinite`]; [`SpaceError::ZeroNormal`].
    pub fn new([x, y, z, d]: [f64; 4]) -> Result<Self, SpaceError> {
        finite(&[x, y, z, d])?;
        if [x, y, z] == [0.0; 3] {
            return Err(SpaceError::ZeroNormal);
        }
        // The plain root is exact wherever the squares' sum is a square.
        let squared = x * x + y * y + z * z;
        let length = if (1e-200..1e200).contains(&squared) {
            squared.sqrt()
        } else {
            libm::hypot(libm::hypot(x, y), z)
        };
        let normal = [x, y, z];
        Ok(Self { normal, d, length })
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
