//! The camera that a scene is about, with its numbers as they were given.

use crate::geom::{Camera, SpaceError, ViewVolume};

#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Opening {
    /// In perspective: the angle from bottom to top, in degrees.
    FovY(f64),
    /// Parallel: from bottom to top.
    Height(f64),
}

/// What a camera is made of; see [`TaughtCamera::new`].
#[derive(Debug)]
pub struct CameraNumbers {
    pub places: [[f64; 3]; 3],
    pub opening: Opening,
    pub aspect: f64,
    pub depths: [f64; 2],
}

/// A camera, and the numbers that it was made of: always valid.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct TaughtCamera {
    camera: Camera,
    opening: Opening,
    aspect: f64,
}

impl TaughtCamera {
    /// At `position`, looking at `target`; `aspect` is width over height.
    ///
    /// # Errors
    /// [`SpaceError`], of the opening and the planes first.
    pub fn new(
        [position, target, up]: [[f64; 3]; 3],
        opening: Opening,
        aspect: f64,
        [near, far]: [f64; 2],
    ) -> Result<Self, SpaceError> {
        let volume = match opening {
            Opening::FovY(degrees) => ViewVolume::perspective(degrees, aspect, near, far),
            Opening::Height(height) => ViewVolume::parallel(height, aspect, near, far),
        }?;
        Ok(Self {
            camera: Camera::new(position, target, up, volume)?,
            opening,
            aspect,
        })
    }

    pub const fn camera(&self) -> &Camera {
        &self.camera
    }

    pub const fn opening(&self) -> Opening {
        self.opening
    }

    /// Width over height.
    pub const fn aspect(&self) -> f64 {
        self.aspect
    }

    pub const fn depths(&self) -> [f64; 2] {
        let volume = self.camera.volume();
        [volume.near(), volume.far()]
    }

    /// Position, target, and the way up.
    pub fn places(&self) -> [[f64; 3]; 3] {
        let camera = &self.camera;
        [camera.position(), camera.target(), camera.up()]
    }

    /// The same but for some of its numbers.
    ///
    /// # Errors
    /// As for [`TaughtCamera::new`].
    pub fn with(&self, change: impl FnOnce(&mut CameraNumbers)) -> Result<Self, SpaceError> {
        let mut numbers = CameraNumbers {
            places: self.places(),
            opening: self.opening,
            aspect: self.aspect,
            depths: self.depths(),
        };
        change(&mut numbers);
        let CameraNumbers {
            places,
            opening,
            aspect,
            depths,
        } = numbers;
        Self::new(places, opening, aspect, depths)
    }
}
