//! Validated primitives: types that cannot hold nonsense, so that the algorithms need no checks.
//!
//! Conventions: y is up; every window is closed (on the border is inside); every half-plane's normal
//! points inside; a front-facing outline runs counter-clockwise. Coordinates are `f64` in world units.

mod convex_polygon;
mod error;
mod half_plane;
mod point;
mod polygon;
mod window;

pub use convex_polygon::ConvexPolygon;
pub(crate) use convex_polygon::orientation;
pub use error::{Axis, GeomError};
pub use half_plane::HalfPlane;
pub use point::{Point, Segment, extent};
pub use polygon::Polygon;
pub use window::{Edge, Window};
