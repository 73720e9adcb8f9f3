//! Validated primitives: types that cannot hold nonsense, so that the algorithms need no checks.
//!
//! Conventions: y is up; every window is closed (on the border is inside); every half-plane's normal
//! points inside; a front-facing outline runs counter-clockwise. Coordinates are `f64` in world units.

mod convex_polygon;
mod distance;
mod error;
mod exact;
mod half_plane;
mod orbit;
mod orientation;
mod point;
mod polygon;
mod region;
mod rings;
mod simple_polygon;
mod sweep;
mod window;

pub use convex_polygon::ConvexPolygon;
pub use distance::distance_to_segment;
pub use error::{Axis, GeomError};
pub use half_plane::HalfPlane;
pub use orbit::Orbit;
pub use orientation::{is_certain, lexicographic, orientation, winding};
pub use point::{Point, Segment, extent};
pub use polygon::Polygon;
pub use region::Region;
pub use rings::{Location, Rings, locate};
pub use simple_polygon::SimplePolygon;
pub use window::{Edge, Window};
