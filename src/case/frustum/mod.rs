//! The frustum lab's cases: a point, a sphere or a box against planes, a triangle against whoever looks at it.

mod reader;
mod solve;
mod volume;

use crate::{
    algo::cull::{BackFace, BoxCull, PointPlanes, SphereCull},
    labs::frustum::OnScene,
};

use super::Solver;

/// The lab's methods that have one case each; the funnel and those that are wrong on purpose left out.
pub(super) static SOLVERS: [Solver; 4] = [
    Solver::of::<OnScene<PointPlanes>>(),
    Solver::of::<OnScene<SphereCull>>(),
    Solver::of::<OnScene<BoxCull>>(),
    Solver::of::<OnScene<BackFace>>(),
];
