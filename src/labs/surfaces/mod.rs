//! The surfaces lab: of all that a camera sees, which surface is in front.

mod costs;
mod methods;
mod registry;
mod verdict;

pub use costs::{SurfaceCounting, SurfaceCounts, fitted_slope};
pub use methods::with_occluders;
pub use registry::{LAB, METHODS, SURFACES, first_scene};
