//! Validated primitives: types that cannot hold nonsense, so that the algorithms need no checks.
//!
//! Conventions: y is up; every window is closed (on the border is inside); every half-plane's normal
//! points inside; a front-facing outline runs counter-clockwise. Coordinates are `f64` in world units. Space is
//! right-handed; a camera looks down −z of its own axes.
#![warn(
    missing_docs,
    clippy::must_use_candidate,
    clippy::return_self_not_must_use
)]

mod aligned_box;
mod camera;
mod convex_polygon;
mod determinant;
mod distance;
mod error;
mod exact;
mod expansion;
mod half_plane;
mod half_spaces;
mod matrix;
mod mesh;
mod orbit;
mod orientation;
mod plane;
mod point;
mod polygon;
mod region;
mod rings;
mod simple_polygon;
mod solids;
mod space_error;
mod sphere;
mod sweep;
mod texture;
mod view_volume;
mod window;

pub use aligned_box::AlignedBox;
pub use camera::Camera;
pub use convex_polygon::ConvexPolygon;
pub use determinant::{sign_of_four, sign_of_three};
pub use distance::distance_to_segment;
pub use error::{Axis, GeomError};
pub use half_plane::HalfPlane;
pub use half_spaces::meets;
pub use matrix::Matrix;
pub use mesh::{Mesh, MeshEdge, MeshError};
pub use orbit::Orbit;
pub use orientation::{is_certain, lexicographic, orientation, winding};
pub use plane::Plane;
pub use point::{Point, Segment, extent};
pub use polygon::Polygon;
pub use region::Region;
pub use rings::{Location, Rings, locate};
pub use simple_polygon::SimplePolygon;
pub use solids::Solid;
pub use space_error::SpaceError;
pub use sphere::Sphere;
pub use texture::Texture;
pub use view_volume::{Sight, ViewVolume, VolumeSide, planes_from_matrix};
pub use window::{Edge, Window};
