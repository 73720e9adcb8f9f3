//! The polygons lab's cases: a polygon against a window or another polygon, or a polygon alone.

mod reader;
mod solve;
mod verdict;

use crate::algo::polygon::{
    EarClipping, Pipeline, SutherlandHodgman, Textured, TriangulateAndClip,
    weiler_atherton::WeilerAtherton,
};

use super::{Fields, Refusal, Solvable, Solver, solver::read_problem};

/// The lab's methods, those that are wrong on purpose left out.
pub(super) static SOLVERS: [Solver; 5] = [
    Solver::of::<SutherlandHodgman>().reading(read_sutherland_hodgman),
    Solver::of::<Pipeline>(),
    Solver::told::<WeilerAtherton>(),
    Solver::told::<EarClipping>(),
    Solver::of::<TriangulateAndClip>(),
];

/// With texture coordinates at the vertices where they are given.
fn read_sutherland_hodgman(fields: &Fields<'_>) -> Result<Box<dyn Solvable>, Refusal> {
    match fields.get("uv") {
        None => read_problem::<SutherlandHodgman>(fields),
        Some(_) => read_problem::<SutherlandHodgman<Textured>>(fields),
    }
}
