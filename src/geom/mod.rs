//! Validated primitives: types that cannot hold nonsense, so that the algorithms need no checks. y is up; every window is closed
//! (on the border is inside); normals point inside; a front-facing outline runs counter-clockwise; space is right-handed, and a
//! camera looks down −z of its own axes. Coordinates are `f64` in world units.
#![warn(
    missing_docs,
    clippy::missing_errors_doc,
    clippy::must_use_candidate,
    clippy::return_self_not_must_use
)]

mod aligned_box;
mod camera;
mod determinant;
mod error;
mod long_sum;
mod matrix;
mod mesh;
mod orbit;
mod orientation;
mod plane;
mod point;
mod polygon;
mod power;
mod region;
mod rings;
mod simple_polygon;
mod solids;
mod sphere;
mod sweep;
mod texture;
mod view_volume;
mod wide;
mod window;

pub use aligned_box::{AlignedBox, VolumeSide};
pub use camera::Camera;
pub use determinant::{
    certain as certain_sign, extent as minor_extent, sign_of_four, sign_of_three,
};
pub use error::{Axis, GeomError, SpaceError};
pub use matrix::Matrix;
pub use mesh::{Mesh, MeshEdge, MeshError};
pub use orbit::Orbit;
pub use orientation::{doubtful_area, is_certain, lexicographic, orientation, winding};
pub use plane::{HalfPlane, Plane, meets};
pub use point::{Point, Segment, distance_to_segment, extent};
pub use polygon::{ConvexPolygon, Polygon};
pub use power::{exponent, times_power};
pub use region::Region;
pub use rings::{Location, Rings, locate, pairs_around};
pub use simple_polygon::SimplePolygon;
pub use solids::Solid;
pub use sphere::Sphere;
pub use texture::Texture;
pub use view_volume::{Sight, ViewVolume, planes_from_matrix};
pub use wide::Wide;
pub use window::{Edge, Window};

/// From 0 to 1: a part of a whole, such as an opacity.
#[must_use]
pub fn is_part(x: f64) -> bool {
    (0.0..=1.0).contains(&x)
}

/// Knuth's generator: the same numbers in every run of a test.
#[cfg(test)]
pub(crate) fn random_bits(mut state: u64) -> impl FnMut() -> u64 {
    move || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        state
    }
}
