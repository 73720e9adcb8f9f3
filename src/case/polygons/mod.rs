//! The polygons lab's cases: a polygon against a window or another polygon, or a polygon alone.

mod reader;
mod solve;
mod verdict;

use crate::algo::polygon::{
    EarClipping, Pipeline, SutherlandHodgman, Textured, TriangulateAndClip,
    weiler_atherton::WeilerAtherton,
};

use super::{Fields, Refusal, Solvable, Solver, solver::read_told};

/// The lab's methods, those that are wrong on purpose left out.
pub(super) static SOLVERS: [Solver; 5] = [
    Solver::told::<SutherlandHodgman>().reading(read_sutherland_hodgman),
    Solver::told::<Pipeline>(),
    Solver::told::<WeilerAtherton>(),
    Solver::told::<EarClipping>(),
    Solver::told::<TriangulateAndClip>(),
];

/// With texture coordinates at the vertices where they are given.
fn read_sutherland_hodgman(fields: &Fields<'_>) -> Result<Box<dyn Solvable>, Refusal> {
    match fields.get("uv") {
        None => read_told::<SutherlandHodgman>(fields),
        Some(_) => read_told::<SutherlandHodgman<Textured>>(fields),
    }
}
