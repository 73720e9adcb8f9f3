//! The clip window: a closed, ordered, axis-aligned rectangle.

use std::hint::select_unpredictable;

use serde::{Deserialize, Serialize};

use super::{Axis, GeomError, HalfPlane, Point, point::finite};

/// A side of the window.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Edge {
    /// x = xmin
    Left,
    /// x = xmax
    Right,
    /// y = ymin
    Bottom,
    /// y = ymax
    Top,
}

impl Edge {
    /// In the order in which Liang and Barsky number them, k = 1 … 4.
    pub const ALL: [Self; 4] = [Self::Left, Self::Right, Self::Bottom, Self::Top];

    /// The coordinate that is constant along this side.
    #[must_use]
    pub const fn axis(self) -> Axis {
        match self {
            Self::Left | Self::Right => Axis::X,
            Self::Bottom | Self::Top => Axis::Y,
        }
    }

    /// True for the two sides at which the coordinate is largest.
    #[must_use]
    pub const fn is_max(self) -> bool {
        matches!(self, Self::Right | Self::Top)
    }

    /// `left`, `right`, `bottom` or `top`: as JSON and lesson files spell it.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Left => "left",
            Self::Right => "right",
            Self::Bottom => "bottom",
            Self::Top => "top",
        }
    }
}

/// A closed window `xmin ≤ x ≤ xmax`, `ymin ≤ y ≤ ymax`, with `xmin < xmax` and `ymin < ymax`.
#[derive(Clone, Copy, PartialEq, Debug, Serialize, Deserialize)]
#[serde(try_from = "[f64; 4]", into = "[f64; 4]")]
pub struct Window {
    min: Point,
    max: Point,
}

impl Window {
    /// # Errors
    /// [`GeomError::NotFinite`], or [`GeomError::EmptyWindow`] where a minimum is not below its maximum.
    pub fn new(xmin: f64, ymin: f64, xmax: f64, ymax: f64) -> Result<Self, GeomError> {
        finite(&[xmin, ymin, xmax, ymax])?;
        for (axis, min, max) in [(Axis::X, xmin, xmax), (Axis::Y, ymin, ymax)] {
            if min >= max {
                return Err(GeomError::EmptyWindow { axis, min, max });
            }
        }
        Ok(Self {
            min: Point::from_finite(xmin, ymin),
            max: Point::from_finite(xmax, ymax),
        })
    }

    /// Lower left corner.
    #[must_use]
    pub const fn min(&self) -> Point {
        self.min
    }

    /// Upper right corner.
    #[must_use]
    pub const fn max(&self) -> Point {
        self.max
    }

    /// The constant coordinate of a side.
    #[inline]
    #[must_use]
    pub fn border(&self, edge: Edge) -> f64 {
        // Of four sides none is likelier: a branch would be guessed wrong too often.
        let corner = select_unpredictable(edge.is_max(), self.max, self.min);
        select_unpredictable(edge.axis() == Axis::X, corner.x(), corner.y())
    }

    /// The half-plane that a side bounds.
    #[must_use]
    pub fn half_plane(&self, edge: Edge) -> HalfPlane {
        let (min, max) = (self.min, self.max);
        match edge {
            Edge::Left => HalfPlane::axis_aligned([1.0, 0.0], min),
            Edge::Right => HalfPlane::axis_aligned([-1.0, 0.0], max),
            Edge::Bottom => HalfPlane::axis_aligned([0.0, 1.0], min),
            Edge::Top => HalfPlane::axis_aligned([0.0, -1.0], max),
        }
    }

    /// On the border is inside.
    #[must_use]
    pub fn contains(&self, p: Point) -> bool {
        (self.min.x()..=self.max.x()).contains(&p.x())
            && (self.min.y()..=self.max.y()).contains(&p.y())
    }

    /// Counter-clockwise from the lower left.
    #[must_use]
    pub fn corners(&self) -> [Point; 4] {
        let (min, max) = (self.min, self.max);
        [
            min,
            Point::from_finite(max.x(), min.y()),
            max,
            Point::from_finite(min.x(), max.y()),
        ]
    }

    /// `[xmin, ymin, xmax, ymax]`.
    #[must_use]
    pub const fn to_array(&self) -> [f64; 4] {
        [self.min.x(), self.min.y(), self.max.x(), self.max.y()]
    }
}

impl TryFrom<[f64; 4]> for Window {
    type Error = GeomError;
    fn try_from([xmin, ymin, xmax, ymax]: [f64; 4]) -> Result<Self, GeomError> {
        Self::new(xmin, ymin, xmax, ymax)
    }
}

impl From<Window> for [f64; 4] {
    fn from(window: Window) -> Self {
        window.to_array()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn refused_unless_finite_and_ordered() {
        use GeomError::{EmptyWindow, NotFinite};
        let infinity = f64::INFINITY;
        let empty = |axis, min, max| EmptyWindow { axis, min, max };
        let (index, value) = (2, infinity);
        let not_finite = NotFinite { index, value };
        let cases = [
            ([1.0, 0.0, -1.0, 1.0], empty(Axis::X, 1.0, -1.0)),
            ([0.0, 2.0, 1.0, 2.0], empty(Axis::Y, 2.0, 2.0)),
            ([0.0, -0.0, 0.0, 1.0], empty(Axis::X, 0.0, 0.0)),
            ([0.0, 0.0, infinity, 1.0], not_finite),
        ];
        for (numbers, expected) in cases {
            assert_eq!(Window::try_from(numbers), Err(expected), "{numbers:?}");
        }
        let refused = Window::new(0.0, f64::NAN, 1.0, 1.0).unwrap_err();
        assert!(matches!(refused, NotFinite { index: 1, .. }), "{refused}");
    }

    #[test]
    fn its_border_is_inside() {
        let window = Window::new(-1.0, -2.0, 3.0, 4.0).unwrap();
        for corner in window.corners() {
            assert!(window.contains(corner), "{corner:?}");
        }
        let beyond = Point::new(3.0_f64.next_up(), 0.0).unwrap();
        assert!(!window.contains(beyond), "{beyond:?}");
    }

    #[test]
    fn every_normal_points_inside() {
        let window = Window::new(-1.0, -2.0, 3.0, 4.0).unwrap();
        for edge in Edge::ALL {
            let plane = window.half_plane(edge);
            let ([nx, ny], origin) = (plane.normal(), plane.origin());
            let distance = nx * (1.0 - origin.x()) + ny * (1.0 - origin.y());
            assert!(distance > 0.0, "{} has {distance}", edge.id());
        }
    }
}
