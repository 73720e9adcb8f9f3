//! The view volume: what a camera sees, in its own axes, of which it looks down −z.

use super::{Matrix, Plane, SpaceError, VolumeSide, error::finite, power::times_power};

/// How sight lines run.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Sight {
    /// Through the eye: far things look smaller.
    Perspective,
    /// Side by side, along −z.
    Parallel,
}

/// What a camera sees, in its own axes: a frustum, or a box for a parallel camera.
///
/// ```
/// use clipscope::geom::ViewVolume;
/// let volume = ViewVolume::perspective(90.0, 2.0, 1.0, 5.0)?;
/// assert_eq!(volume.half_size(), [2.0, 1.0]);
/// assert_eq!(volume.corners()[7], [10.0, 5.0, -5.0]);
/// # Ok::<(), clipscope::geom::SpaceError>(())
/// ```
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ViewVolume {
    sight: Sight,
    half_size: [f64; 2],
    near: f64,
    far: f64,
}

impl ViewVolume {
    /// From the field of view from bottom to top in degrees, width over height, and the distances of near and far plane.
    ///
    /// # Errors
    /// `NotFinite`, `FieldOfView`, `Aspect`, `Near`, `Far` of [`SpaceError`], in this order.
    pub fn perspective(
        fov_y_deg: f64,
        aspect: f64,
        near: f64,
        far: f64,
    ) -> Result<Self, SpaceError> {
        finite(&[fov_y_deg, aspect, near, far])?;
        if !(fov_y_deg > 0.0 && fov_y_deg < 180.0) {
            return Err(SpaceError::FieldOfView(fov_y_deg));
        }
        let tan = tan_half(fov_y_deg);
        let volume = Self::checked(Sight::Perspective, tan, aspect, near, far)?;
        if near <= 0.0 {
            return Err(SpaceError::Near(near));
        }
        volume.ordered()
    }

    /// Of a parallel camera, from its height; the eye may lie within.
    ///
    /// # Errors
    /// `NotFinite`, `Height`, `Aspect`, `Far` of [`SpaceError`], in this order.
    pub fn parallel(height: f64, aspect: f64, near: f64, far: f64) -> Result<Self, SpaceError> {
        finite(&[height, aspect, near, far])?;
        if height <= 0.0 {
            return Err(SpaceError::Height(height));
        }
        Self::checked(Sight::Parallel, 0.5 * height, aspect, near, far)?.ordered()
    }

    fn checked(
        sight: Sight,
        half_height: f64,
        aspect: f64,
        near: f64,
        far: f64,
    ) -> Result<Self, SpaceError> {
        let half_size = [half_height * aspect, half_height];
        // Neither may a width vanish, nor be larger than any number.
        if aspect > 0.0 && half_size.iter().all(|x| x.is_normal()) {
            Ok(Self {
                sight,
                half_size,
                near,
                far,
            })
        } else {
            Err(SpaceError::Aspect(aspect))
        }
    }

    fn ordered(self) -> Result<Self, SpaceError> {
        let Self { near, far, .. } = self;
        let is_usable = far > near && (far - near).is_finite();
        is_usable
            .then_some(self)
            .ok_or(SpaceError::Far { near, far })
    }

    /// How sight lines run.
    #[must_use]
    pub const fn sight(&self) -> Sight {
        self.sight
    }

    /// Half of width and height: of a frustum at the distance 1, where they are the tangents of half the angles.
    #[must_use]
    pub const fn half_size(&self) -> [f64; 2] {
        self.half_size
    }

    /// As wide as it is high.
    pub(super) const fn square(&self) -> Self {
        let [_, height] = self.half_size;
        Self {
            half_size: [height; 2],
            ..*self
        }
    }

    /// Everything in it times 2 to the power of an exponent, by which no number becomes infinite.
    pub(crate) fn times_power(&self, exponent: i32) -> Self {
        let [near, far] = times_power([self.near, self.far], exponent);
        let half_size = match self.sight {
            Sight::Perspective => self.half_size,
            Sight::Parallel => times_power(self.half_size, exponent),
        };
        Self {
            half_size,
            near,
            far,
            ..*self
        }
    }

    /// Distance of the near plane.
    #[must_use]
    pub const fn near(&self) -> f64 {
        self.near
    }

    /// Distance of the far plane.
    #[must_use]
    pub const fn far(&self) -> f64 {
        self.far
    }

    /// Its planes in view space, in the order of [`VolumeSide::ALL`], with normals of length 1: of a frustum
    /// (0, 0, −1, −near), (0, 0, 1, far), (±cos, 0, −sin, 0), (0, ±cos, −sin, 0) by half the angles.
    #[must_use]
    pub fn planes(&self) -> [Plane; 6] {
        let side = |axis: usize, sign: f64| {
            let half = self.half_size[axis];
            let mut normal = [0.0; 3];
            match self.sight {
                Sight::Parallel => {
                    normal[axis] = sign;
                    Plane::unit(normal, half)
                }
                Sight::Perspective => {
                    let hypotenuse = libm::hypot(1.0, half);
                    normal[axis] = sign / hypotenuse;
                    normal[2] = -half / hypotenuse;
                    Plane::unit(normal, 0.0)
                }
            }
        };
        [
            Plane::unit([0.0, 0.0, -1.0], -self.near),
            Plane::unit([0.0, 0.0, 1.0], self.far),
            side(0, 1.0),
            side(0, -1.0),
            side(1, 1.0),
            side(1, -1.0),
        ]
    }

    /// To clip space, where −w ≤ x, y, z ≤ w is inside; w is the distance before the eye, and 1 for a parallel camera.
    #[must_use]
    pub fn clip_from_view(&self) -> Matrix {
        let Self { near, far, .. } = *self;
        let [x, y] = self.half_size.map(|half| 1.0 / half);
        let depth = far - near;
        let sum = far + near;
        let middle = if sum.is_finite() {
            -(sum / depth)
        } else {
            -((0.5 * far + 0.5 * near) / (0.5 * depth))
        };
        let (scale, offset, last) = match self.sight {
            Sight::Perspective => (middle, -2.0 * (far * (near / depth)), [0.0, 0.0, -1.0, 0.0]),
            Sight::Parallel => (-2.0 / depth, middle, [0.0, 0.0, 0.0, 1.0]),
        };
        Matrix::from_rows([
            [x, 0.0, 0.0, 0.0],
            [0.0, y, 0.0, 0.0],
            [0.0, 0.0, scale, offset],
            last,
        ])
    }

    /// All eight: bit 0 of a corner's number says right rather than left, bit 1 top, bit 2 far.
    #[must_use]
    pub fn corners(&self) -> [[f64; 3]; 8] {
        std::array::from_fn(|i| {
            let distance = if i & 4 == 0 { self.near } else { self.far };
            let widen = match self.sight {
                Sight::Perspective => distance,
                Sight::Parallel => 1.0,
            };
            let signed = |axis: usize| if i >> axis & 1 == 1 { widen } else { -widen };
            let [x, y] = [0, 1].map(|axis| signed(axis) * self.half_size[axis]);
            [x, y, -distance]
        })
    }
}

/// The planes of −w ≤ x, y, z ≤ w in the space that `clip_from` leads out of, in the order of [`VolumeSide::ALL`]: the last
/// row of the matrix, plus or minus one of the others (G. Gribb and K. Hartmann, "Fast extraction of viewing frustum planes
/// from the world-view-projection matrix", 2001).
///
/// # Errors
/// [`SpaceError::ZeroNormal`] where the matrix is singular so that a side has no direction.
pub fn planes_from_matrix(clip_from: &Matrix) -> Result<[Plane; 6], SpaceError> {
    let rows = clip_from.rows();
    let mut planes = [Plane::unit([0.0, 0.0, 1.0], 0.0); 6];
    for (plane, side) in planes.iter_mut().zip(VolumeSide::ALL) {
        let row = rows[side.axis()];
        let sign = if side.is_high() { -1.0 } else { 1.0 };
        *plane = Plane::new(std::array::from_fn(|i| rows[3][i] + sign * row[i]))?;
    }
    Ok(planes)
}

/// Of half an angle in degrees; exactly 1 for 90°.
fn tan_half(angle_deg: f64) -> f64 {
    if angle_deg == 90.0 {
        1.0
    } else {
        libm::tan((0.5 * angle_deg).to_radians())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn volumes() -> [ViewVolume; 4] {
        [
            ViewVolume::perspective(90.0, 1.0, 1.0, 5.0).unwrap(),
            ViewVolume::perspective(41.5, 16.0 / 9.0, 0.1, 100.0).unwrap(),
            ViewVolume::parallel(4.0, 1.5, 1.0, 9.0).unwrap(),
            ViewVolume::parallel(0.5, 0.25, -3.0, 2.0).unwrap(),
        ]
    }

    fn distance(plane: &Plane, at: [f64; 3]) -> f64 {
        let [x, y, z] = plane.normal();
        (x * at[0] + y * at[1] + z * at[2] + plane.d()) / plane.length()
    }

    #[test]
    fn each_corner_lies_on_its_three_planes_and_inside_the_others() {
        for volume in volumes() {
            for (i, corner) in volume.corners().into_iter().enumerate() {
                for (side, plane) in VolumeSide::ALL.into_iter().zip(volume.planes()) {
                    let found = distance(&plane, corner);
                    let is_on = (i >> side.axis() & 1 == 1) == side.is_high();
                    let is_right = (found.abs() < 1e-12) == is_on && found > -1e-12;
                    assert!(is_right, "{volume:?} {i} {side:?}: {found}");
                }
            }
        }
    }

    #[test]
    fn planes_from_angles_and_from_the_matrix_are_the_same() {
        for volume in volumes() {
            let from_matrix = planes_from_matrix(&volume.clip_from_view()).unwrap();
            for (one, other) in volume.planes().iter().zip(&from_matrix) {
                for at in [[0.3, -0.2, -1.5], [7.0, 2.0, 3.0], [-1.0, 0.0, -40.0]] {
                    let [a, b] = [one, other].map(|plane| distance(plane, at));
                    let is_near = (a - b).abs() < 1e-11 * a.abs().max(1.0);
                    assert!(is_near, "{volume:?}: {a} {b}");
                }
            }
        }
    }

    #[test]
    fn a_right_angle_is_exact() {
        let [.., left, right, _, _] = volumes()[0].planes();
        for (plane, x) in [(left, -3.0), (right, 3.0)] {
            assert_eq!(distance(&plane, [x, 0.5, -3.0]), 0.0);
        }
    }

    #[test]
    fn what_sees_nothing_is_refused_where_it_is_wrong() {
        let refused = ViewVolume::perspective(60.0, f64::NAN, 1.0, 2.0).unwrap_err();
        assert!(matches!(refused, SpaceError::NotFinite { index: 1, .. }));
        let near = 2.0;
        let cases = [
            ([0.0, 1.0, 1.0, 2.0], SpaceError::FieldOfView(0.0)),
            ([180.0, 1.0, 1.0, 2.0], SpaceError::FieldOfView(180.0)),
            ([60.0, 0.0, 1.0, 2.0], SpaceError::Aspect(0.0)),
            ([60.0, 1.0, 0.0, 2.0], SpaceError::Near(0.0)),
            ([60.0, 1.0, 2.0, 2.0], SpaceError::Far { near, far: near }),
        ];
        for ([fov, aspect, near, far], expected) in cases {
            let refused = ViewVolume::perspective(fov, aspect, near, far).err();
            assert_eq!(refused, Some(expected));
        }
        let flat = ViewVolume::parallel(0.0, 1.0, 1.0, 2.0);
        assert_eq!(flat, Err(SpaceError::Height(0.0)));
        assert!(ViewVolume::parallel(1.0, 1.0, -1.0, 2.0).is_ok());
    }
}
