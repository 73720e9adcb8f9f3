//! The surfaces lab's cases: triangles in view space on a raster.

use super::Solver;

/// The lab's methods that have one case each; those that are wrong on purpose left out.
pub(super) static SOLVERS: [Solver; 0] = [];
