//! The camera that a scene is about, with its numbers as they were given.

use crate::geom::{Camera, SpaceError, ViewVolume};

#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Opening {
    /// In perspective: the angle from bottom to top, in degrees.
    FovY(f64),
    /// Parallel: from bottom to top.
    Height(f64),
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

    /// Elsewhere.
    ///
    /// # Errors
    /// As for [`TaughtCamera::new`].
    pub fn placed(&self, places: [[f64; 3]; 3]) -> Result<Self, SpaceError> {
        Self::new(places, self.opening, self.aspect, self.depths())
    }

    /// Open as wide as this.
    ///
    /// # Errors
    /// As for [`TaughtCamera::new`].
    pub fn opened(&self, opening: Opening) -> Result<Self, SpaceError> {
        Self::new(self.places(), opening, self.aspect, self.depths())
    }

    /// Of this shape.
    ///
    /// # Errors
    /// As for [`TaughtCamera::new`].
    pub fn shaped(&self, aspect: f64) -> Result<Self, SpaceError> {
        Self::new(self.places(), self.opening, aspect, self.depths())
    }

    /// With its planes at these distances.
    ///
    /// # Errors
    /// As for [`TaughtCamera::new`].
    pub fn deep(&self, depths: [f64; 2]) -> Result<Self, SpaceError> {
        Self::new(self.places(), self.opening, self.aspect, depths)
    }
}
