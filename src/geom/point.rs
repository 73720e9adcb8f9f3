//! Finite points and the segments between them.

use serde::{Deserialize, Serialize};

use super::GeomError;

/// A point of the plane. Both coordinates are finite.
#[derive(Clone, Copy, PartialEq, Debug, Default, Serialize, Deserialize)]
#[serde(try_from = "[f64; 2]", into = "[f64; 2]")]
pub struct Point {
    x: f64,
    y: f64,
}

impl Point {
    /// # Errors
    /// [`GeomError::NotFinite`] where a coordinate is NaN or infinite.
    pub fn new(x: f64, y: f64) -> Result<Self, GeomError> {
        finite(&[x, y]).map(|()| Self { x, y })
    }

    /// A point from coordinates that the caller knows to be finite: clamped copies of finite numbers.
    pub(crate) fn from_finite(x: f64, y: f64) -> Self {
        debug_assert!(x.is_finite() && y.is_finite(), "({x}, {y}) is not finite");
        Self { x, y }
    }

    /// Horizontal coordinate.
    #[must_use]
    pub const fn x(self) -> f64 {
        self.x
    }

    /// Vertical coordinate, up.
    #[must_use]
    pub const fn y(self) -> f64 {
        self.y
    }

    /// `[x, y]`.
    #[must_use]
    pub const fn to_array(self) -> [f64; 2] {
        [self.x, self.y]
    }
}

impl TryFrom<[f64; 2]> for Point {
    type Error = GeomError;
    fn try_from([x, y]: [f64; 2]) -> Result<Self, GeomError> {
        Self::new(x, y)
    }
}

impl From<Point> for [f64; 2] {
    fn from(point: Point) -> Self {
        point.to_array()
    }
}

/// A directed segment from `p1` to `p2`. Both may be the same point.
#[derive(Clone, Copy, PartialEq, Debug, Default, Serialize, Deserialize)]
#[serde(try_from = "[f64; 4]", into = "[f64; 4]")]
pub struct Segment {
    /// The first end, P₁: u = 0.
    pub p1: Point,
    /// The second end, P₂: u = 1.
    pub p2: Point,
}

impl Segment {
    /// # Errors
    /// [`GeomError::NotFinite`] where a coordinate is NaN or infinite.
    pub fn new(x1: f64, y1: f64, x2: f64, y2: f64) -> Result<Self, GeomError> {
        finite(&[x1, y1, x2, y2])?;
        Ok(Self {
            p1: Point { x: x1, y: y1 },
            p2: Point { x: x2, y: y2 },
        })
    }

    /// Are both ends the same?
    #[must_use]
    pub fn is_point(&self) -> bool {
        self.p1 == self.p2
    }

    /// The same segment walked the other way.
    #[must_use]
    pub const fn reversed(self) -> Self {
        Self {
            p1: self.p2,
            p2: self.p1,
        }
    }

    /// `[x1, y1, x2, y2]`.
    #[must_use]
    pub const fn to_array(self) -> [f64; 4] {
        [self.p1.x, self.p1.y, self.p2.x, self.p2.y]
    }
}

impl TryFrom<[f64; 4]> for Segment {
    type Error = GeomError;
    fn try_from([x1, y1, x2, y2]: [f64; 4]) -> Result<Self, GeomError> {
        Self::new(x1, y1, x2, y2)
    }
}

impl From<Segment> for [f64; 4] {
    fn from(segment: Segment) -> Self {
        segment.to_array()
    }
}

/// The smallest rectangle around some points, as its lower left and upper right corner.
#[must_use]
pub fn extent(points: impl IntoIterator<Item = Point>) -> [[f64; 2]; 2] {
    points.into_iter().fold(
        [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]],
        |[min, max], p| {
            [
                [min[0].min(p.x), min[1].min(p.y)],
                [max[0].max(p.x), max[1].max(p.y)],
            ]
        },
    )
}

/// Refuses the first number that is not finite.
pub(super) fn finite(numbers: &[f64]) -> Result<(), GeomError> {
    match numbers.iter().position(|x| !x.is_finite()) {
        Some(index) => Err(GeomError::NotFinite {
            index,
            value: numbers[index],
        }),
        None => Ok(()),
    }
}
