//! The frustum lab's cases: a point, a sphere or a box against planes, a triangle against whoever looks at it, a segment
//! in a box, against planes or in clip space.

mod pipeline;
mod reader;
mod segment;
mod solve;
mod solve_line;
mod triangles;

use crate::{
    algo::{
        cull::{BackFace, BoxCull, PointPlanes, SphereCull},
        pipeline::{LineToPixels, ViewingPipeline},
        volume::{
            CohenSutherland3d, HomogeneousLine, HomogeneousTriangle, IntersectionPolygon,
            LiangBarsky3d, PlaneAtATime, PlaneLine,
        },
    },
    labs::space::OnScene,
};

use super::Solver;

/// The lab's methods that have one case each; the funnel and those that are wrong on purpose left out.
pub(super) static SOLVERS: [Solver; 13] = [
    Solver::told::<PointPlanes>(),
    Solver::told::<SphereCull>(),
    Solver::told::<BoxCull>(),
    Solver::told::<BackFace>(),
    Solver::of::<OnScene<CohenSutherland3d>>(),
    Solver::of::<OnScene<LiangBarsky3d>>(),
    Solver::of::<OnScene<PlaneLine>>(),
    Solver::of::<OnScene<HomogeneousLine>>(),
    Solver::of::<OnScene<PlaneAtATime>>(),
    Solver::of::<OnScene<IntersectionPolygon>>(),
    Solver::of::<OnScene<HomogeneousTriangle<Option<[f64; 2]>>>>(),
    Solver::told::<ViewingPipeline>(),
    Solver::told::<LineToPixels>(),
];
