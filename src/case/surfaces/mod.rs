//! The surfaces lab's cases: triangles in view space on a raster.

mod reader;
mod solve;

use crate::algo::surface::{Bsp, DepthBuffer, Painter, RayCasting};

use super::Solver;

/// The lab's methods that have one case each; those that are wrong on purpose left out.
pub(super) static SOLVERS: [Solver; 4] = [
    Solver::told::<DepthBuffer>(),
    Solver::told::<RayCasting>(),
    Solver::told::<Painter>(),
    Solver::told::<Bsp>(),
];
