//! The taught camera: part of a scene. The viewer's eye is [`super::Orbit`].

use glam::DVec3;

use super::{Matrix, Plane, SpaceError, ViewVolume, error::finite};

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
        let back = position - target;
        if back == DVec3::ZERO {
            return Err(SpaceError::TargetAtPosition);
        }
        let across = up.cross(back).length_squared();
        let least = MIN_SINE_SQUARED * up.length_squared() * back.length_squared();
        // What is no number is refused too: of numbers too large for their squares.
        if across > least {
            Ok(Self {
                position,
                target,
                up,
                volume,
            })
        } else {
            Err(SpaceError::UpAlongView)
        }
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
        let back = (self.position - self.target).normalize();
        let right = self.up.cross(back).normalize();
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
