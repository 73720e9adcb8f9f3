//! The taught camera: part of a scene. The viewer's eye is [`super::Orbit`].

use glam::DVec3;

use super::{
    Matrix, Plane, SpaceError, ViewVolume,
    error::finite,
    power::{exponent, times_power},
};

/// Where a camera stands, what it looks at, and what it sees of it.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Camera {
    position: DVec3,
    target: DVec3,
    up: DVec3,
    volume: ViewVolume,
}

/// Squared sine of the smallest angle between the way up and the way back.
const MIN_SINE_SQUARED: f64 = 1e-24;

impl Camera {
    /// At `position`, looking at `target`, with `up` upwards on its picture.
    ///
    /// # Errors
    /// `NotFinite` (of the nine numbers in this order), `TargetAtPosition`, `UpAlongView` of [`SpaceError`].
    pub fn new(
        position: [f64; 3],
        target: [f64; 3],
        up: [f64; 3],
        volume: ViewVolume,
    ) -> Result<Self, SpaceError> {
        finite([position, target, up].as_flattened())?;
        let [position, target, up] = [position, target, up].map(DVec3::from);
        let camera = Self {
            position,
            target,
            up,
            volume,
        };
        let [up, back] = camera.directions();
        if back == DVec3::ZERO {
            return Err(SpaceError::TargetAtPosition);
        }
        let across = up.cross(back).length_squared();
        let least = MIN_SINE_SQUARED * up.length_squared() * back.length_squared();
        if across > least {
            Ok(camera)
        } else {
            Err(SpaceError::UpAlongView)
        }
    }

    /// Upwards and back from what is seen, of any length whose square is a number.
    fn directions(&self) -> [DVec3; 2] {
        let back = self.position - self.target;
        let back = if back.is_finite() {
            back
        } else {
            0.5 * self.position - 0.5 * self.target
        };
        [self.up, back].map(moderate)
    }

    /// The eye.
    #[must_use]
    pub fn position(&self) -> [f64; 3] {
        self.position.into()
    }

    /// The middle of its picture.
    #[must_use]
    pub fn target(&self) -> [f64; 3] {
        self.target.into()
    }

    /// As it was given.
    #[must_use]
    pub fn up(&self) -> [f64; 3] {
        self.up.into()
    }

    /// What it sees, in its own axes.
    #[must_use]
    pub const fn volume(&self) -> &ViewVolume {
        &self.volume
    }

    /// The same with the angle from bottom to top taken for that from left to right, too.
    pub(crate) const fn with_one_angle(&self) -> Self {
        Self {
            volume: self.volume.square(),
            ..*self
        }
    }

    /// To the right, upwards and back from what is seen, each of length 1.
    #[must_use]
    pub fn axes(&self) -> [[f64; 3]; 3] {
        self.basis().map(Into::into)
    }

    fn basis(&self) -> [DVec3; 3] {
        let [up, back] = self.directions();
        let back = back.normalize();
        let right = up.cross(back).normalize();
        [right, back.cross(right), back]
    }

    /// From the world to the camera's own axes.
    #[must_use]
    pub fn view_from_world(&self) -> Matrix {
        let row = |axis: DVec3| [axis.x, axis.y, axis.z, -axis.dot(self.position)];
        let [right, up, back] = self.basis().map(row);
        Matrix::from_rows([right, up, back, [0.0, 0.0, 0.0, 1.0]])
    }

    /// A point in the camera's own axes, in the world.
    #[must_use]
    pub fn world_from_view(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        let [right, up, back] = self.basis();
        (self.position + right * x + up * y + back * z).into()
    }

    /// From the world to clip space.
    #[must_use]
    pub fn clip_from_world(&self) -> Matrix {
        self.volume.clip_from_view().after(&self.view_from_world())
    }

    /// The corners of its volume in the world, numbered as [`ViewVolume::corners`] has them.
    #[must_use]
    pub fn corners_in_world(&self) -> [[f64; 3]; 8] {
        let corners = self.volume.corners();
        corners.map(|corner| self.world_from_view(corner))
    }

    /// The planes of its volume in the world, in the order of [`super::VolumeSide::ALL`].
    #[must_use]
    pub fn planes_in_world(&self) -> [Plane; 6] {
        let basis = self.basis();
        self.volume.planes().map(|plane| {
            let [x, y, z] = plane.normal();
            let normal = basis[0] * x + basis[1] * y + basis[2] * z;
            Plane::unit(normal.into(), plane.d() - normal.dot(self.position))
        })
    }
}

/// Times a power of two where it is much longer than 1, or much shorter.
fn moderate(v: DVec3) -> DVec3 {
    let by = exponent(&v.to_array());
    if (-100..100).contains(&by) {
        v
    } else {
        times_power(v.to_array(), -by).into()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn camera() -> Camera {
        let volume = ViewVolume::perspective(50.0, 1.5, 0.5, 20.0).unwrap();
        Camera::new([7.0, 4.0, 5.0], [-1.0, 0.5, 1.0], [0.0, 2.0, 0.1], volume).unwrap()
    }

    #[test]
    fn there_and_back() {
        let camera = camera();
        let [x, y, z] = camera.view_from_world().point(camera.target());
        assert!(x.abs() < 1e-14 && y.abs() < 1e-14 && z < 0.0, "{x} {y} {z}");
        for at in [[0.0, 0.0, 0.0], [3.0, -2.0, 8.0]] {
            let again = camera.world_from_view(camera.view_from_world().point(at));
            for i in 0..3 {
                assert!((again[i] - at[i]).abs() < 1e-13, "{again:?}");
            }
        }
    }

    #[test]
    fn planes_in_the_world_hold_the_corners() {
        let camera = camera();
        for corner in camera.volume().corners() {
            let [x, y, z] = camera.world_from_view(corner);
            for plane in camera.planes_in_world() {
                let [a, b, c, d] = plane.to_array();
                let distance = a * x + b * y + c * z + d;
                assert!(distance > -1e-12, "{corner:?} {plane:?}");
            }
        }
    }

    #[test]
    fn its_axes_are_the_same_however_large_everything_is() {
        let camera = camera();
        let places = [camera.position(), camera.target(), camera.up()];
        for power in (-1000..=1000).step_by(100) {
            let [position, target, up] = places.map(|at| times_power(at, power));
            let scaled = Camera::new(position, target, up, *camera.volume()).unwrap();
            assert_eq!(scaled.axes(), camera.axes(), "2^{power}");
        }
        let (far, up) = ([f64::MAX, 0.0, 0.0], [0.0, 0.0, 5e-324]);
        let across = Camera::new(far, far.map(|x| -x), up, *camera.volume()).unwrap();
        assert_eq!(across.axes()[1..], [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0]]);
    }

    #[test]
    fn a_camera_without_a_way_up_is_refused() {
        let volume = *camera().volume();
        let at = |target, up| Camera::new([0.0; 3], target, up, volume).err();
        let (down, y) = ([0.0, -2.0, 0.0], [0.0, 1.0, 0.0]);
        assert_eq!(at([0.0; 3], y), Some(SpaceError::TargetAtPosition));
        for (target, up) in [([0.0, 0.0, -1.0], [0.0; 3]), (down, y)] {
            assert_eq!(at(target, up), Some(SpaceError::UpAlongView));
        }
        assert_eq!(at(down, [0.0, 0.0, 1.0]), None);
    }
}
