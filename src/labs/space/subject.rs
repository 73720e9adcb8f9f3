//! What the labs' methods ask about.

use crate::geom::SpaceError;

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Subject {
    /// Objects of the scene, or the one in focus.
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
        match self {
            Self::Object | Self::Face | Self::Vertex | Self::Point | Self::Surfaces => true,
            Self::Segment | Self::BoxedSegment | Self::Triangle => false,
        }
    }

    pub const fn shows_camera(self) -> bool {
        match self {
            Self::Object
            | Self::Face
            | Self::Vertex
            | Self::Point
            | Self::Segment
            | Self::Triangle
            | Self::Surfaces => true,
            Self::BoxedSegment => false,
        }
    }
}

/// What can be asked about besides objects: places in the world, all finite.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Places {
    point: [f64; 3],
    segment: [[f64; 3]; 2],
    triangle: [[f64; 3]; 3],
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
    pub const fn point(&self) -> [f64; 3] {
        self.point
    }

    /// Both ends of a segment, which may be one place.
    pub const fn segment(&self) -> [[f64; 3]; 2] {
        self.segment
    }

    pub const fn triangle(&self) -> [[f64; 3]; 3] {
        self.triangle
    }

    /// The same with another point.
    ///
    /// # Errors
    /// [`SpaceError::NotFinite`]
    pub fn with_point(self, point: [f64; 3]) -> Result<Self, SpaceError> {
        Self { point, ..self }.checked()
    }

    /// The same with another segment.
    ///
    /// # Errors
    /// [`SpaceError::NotFinite`]
    pub fn with_segment(self, segment: [[f64; 3]; 2]) -> Result<Self, SpaceError> {
        Self { segment, ..self }.checked()
    }

    /// The same with another triangle.
    ///
    /// # Errors
    /// [`SpaceError::NotFinite`]
    pub fn with_triangle(self, triangle: [[f64; 3]; 3]) -> Result<Self, SpaceError> {
        Self { triangle, ..self }.checked()
    }

    fn checked(self) -> Result<Self, SpaceError> {
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
