//! What the labs' methods ask about.

use crate::geom::SpaceError;

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Subject {
    /// All objects of the scene.
    Objects,
    /// The one in focus.
    Object,
    Face,
    Vertex,
    Point,
    /// The scene's segment; objects are left out of the picture.
    Segment,
    /// The scene's segment in the box from −1 to 1; neither objects nor the camera are in the picture.
    BoxedSegment,
    /// The scene's triangle; objects are left out of the picture.
    Triangle,
    Surfaces,
}

impl Subject {
    pub const fn shows_objects(self) -> bool {
        !matches!(self, Self::Segment | Self::BoxedSegment | Self::Triangle)
    }

    /// The key of what is said over the methods that ask about it, where a lab has others, too.
    pub const fn group_key(self) -> Option<&'static str> {
        match self {
            Self::Objects | Self::Object | Self::Face | Self::Point => Some("methods-objects"),
            Self::Segment | Self::BoxedSegment => Some("methods-segments"),
            Self::Triangle => Some("methods-triangles"),
            Self::Vertex => Some("methods-vertices"),
            Self::Surfaces => None,
        }
    }

    /// Does its run depend on which object is looked at, and on which part of the object?
    pub const fn is_looked_at(self) -> bool {
        matches!(self, Self::Object | Self::Face | Self::Vertex)
    }

    pub const fn shows_camera(self) -> bool {
        !matches!(self, Self::BoxedSegment)
    }
}

/// What can be asked about besides objects: places in the world, in a scene all finite.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Places {
    pub point: [f64; 3],
    /// Both ends, which may be one place.
    pub segment: [[f64; 3]; 2],
    pub triangle: [[f64; 3]; 3],
}

impl Default for Places {
    /// A segment and a triangle that the first scene's volume cuts.
    fn default() -> Self {
        Self {
            point: [0.0; 3],
            segment: [[-5.0, 0.5, 1.0], [3.0, 2.5, -4.0]],
            triangle: [[-5.5, 0.5, 0.0], [3.0, 0.5, 1.0], [0.0, 4.5, -4.0]],
        }
    }
}

impl Places {
    /// The same, if they are finite.
    ///
    /// # Errors
    /// [`SpaceError::NotFinite`]
    pub fn checked(self) -> Result<Self, SpaceError> {
        let places = [&self.point].into_iter();
        let places = places.chain(&self.segment).chain(&self.triangle);
        for (index, &value) in places.flatten().enumerate() {
            if !value.is_finite() {
                return Err(SpaceError::NotFinite { index, value });
            }
        }
        Ok(self)
    }
}
