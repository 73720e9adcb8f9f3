//! Finite points and the segments between them.

use glam::DVec2;
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

    /// Of coordinates that the caller knows to be finite.
    #[inline]
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
        finite(&[x1, y1, x2, y2]).map(|()| Self::from_finite([x1, y1, x2, y2]))
    }

    /// Of coordinates that the caller knows to be finite.
    #[inline]
    pub(crate) fn from_finite([x1, y1, x2, y2]: [f64; 4]) -> Self {
        let (p1, p2) = (Point::from_finite(x1, y1), Point::from_finite(x2, y2));
        Self { p1, p2 }
    }

    /// Of any numbers, NaN included: a value that is thrown away where they are not finite.
    #[inline]
    pub(crate) const fn from_any([x1, y1, x2, y2]: [f64; 4]) -> Self {
        let (p1, p2) = (Point { x: x1, y: y1 }, Point { x: x2, y: y2 });
        Self { p1, p2 }
    }

    /// Are both ends the same?
    #[must_use]
    pub fn is_point(&self) -> bool {
        self.p1 == self.p2
    }

    /// The same segment walked the other way.
    #[must_use]
    pub const fn reversed(self) -> Self {
        let (p1, p2) = (self.p2, self.p1);
        Self { p1, p2 }
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
    let [mut min, mut max] = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
    for p in points {
        for (axis, x) in p.to_array().into_iter().enumerate() {
            min[axis] = min[axis].min(x);
            max[axis] = max[axis].max(x);
        }
    }
    [min, max]
}

/// Distance of a point from the segment between two others.
#[must_use]
pub fn distance_to_segment(at: [f64; 2], ends: [[f64; 2]; 2]) -> f64 {
    let [at, a, b] = [at, ends[0], ends[1]].map(DVec2::from);
    let along = b - a;
    let length_sq = along.length_squared();
    let t = if length_sq > 0.0 {
        ((at - a).dot(along) / length_sq).clamp(0.0, 1.0)
    } else {
        0.0
    };
    at.distance(a + along * t)
}

pub(super) fn finite(numbers: &[f64]) -> Result<(), GeomError> {
    match numbers.iter().position(|x| !x.is_finite()) {
        Some(index) => Err(GeomError::NotFinite {
            index,
            value: numbers[index],
        }),
        None => Ok(()),
    }
}
