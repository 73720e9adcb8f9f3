//! The six spaces that a vertex goes through, each with the object that it belongs to.
//!
//! All are drawn right-handed: clip space over x, y and −w, normalised device coordinates over x, y and −z, so that far is
//! away from the viewer everywhere. A parallel camera has w = 1, and its clip space is drawn as the device's.

mod marks;
mod picture_space;
mod pictures;
mod space_places;

pub use picture_space::{Followed, PictureSpace};
pub use space_places::SpacePlaces;
