//! The polygons lab's cases: a polygon against a window or another polygon, or a polygon alone.

mod reader;
mod solve;
mod verdict;

use serde_json::Value as Json;

use crate::{
    algo::polygon::{
        EarClipping, Pipeline, SutherlandHodgman, Textured, TriangulateAndClip,
        weiler_atherton::WeilerAtherton,
    },
    figure::Run,
    labs::{Answer, MethodCard, record},
    text::Message,
    trace::{Counted, Counts, silent},
};

use super::{Field, Fields, Given, Problem, Refusal, Solver};

use self::{reader::Reader, solve::Solve};

/// The lab's methods, those that are wrong on purpose left out.
pub(super) fn solvers() -> impl Iterator<Item = &'static dyn Solver> {
    SOLVERS.iter().map(|solver| solver as &dyn Solver)
}

static SOLVERS: [PolygonSolver; 5] = [
    PolygonSolver {
        read: read_sutherland_hodgman,
        ..PolygonSolver::of::<SutherlandHodgman>()
    },
    PolygonSolver::of::<Pipeline>(),
    PolygonSolver::of::<WeilerAtherton>(),
    PolygonSolver::of::<EarClipping>(),
    PolygonSolver::of::<TriangulateAndClip>(),
];

struct PolygonSolver {
    card: MethodCard,
    fields: &'static [Field],
    read: fn(&Fields<'_>) -> Result<Box<dyn Problem>, Refusal>,
}

impl PolygonSolver {
    const fn of<A: Solve>() -> Self {
        Self {
            card: MethodCard::of::<A>(),
            fields: A::FIELDS,
            read: read::<A>,
        }
    }
}

fn read<A: Solve>(fields: &Fields<'_>) -> Result<Box<dyn Problem>, Refusal> {
    let mut reader = Reader::new(fields);
    let input = A::read(&mut reader)?;
    let given = reader.given;
    Ok(Box::new(PolygonCase::<A> { input, given }))
}

/// With texture coordinates at the vertices where they are given.
fn read_sutherland_hodgman(fields: &Fields<'_>) -> Result<Box<dyn Problem>, Refusal> {
    match fields.get("uv") {
        None => read::<SutherlandHodgman>(fields),
        Some(_) => read::<SutherlandHodgman<Textured>>(fields),
    }
}

impl Solver for PolygonSolver {
    fn id(&self) -> &'static str {
        self.card.id
    }

    fn name_key(&self) -> &'static str {
        self.card.name_key
    }

    fn source(&self) -> &'static str {
        self.card.source
    }

    fn fields(&self) -> &'static [Field] {
        self.fields
    }

    fn read(&self, fields: &Fields<'_>) -> Result<Box<dyn Problem>, Refusal> {
        (self.read)(fields)
    }
}

struct PolygonCase<A: Solve> {
    input: A::Input,
    given: Vec<Given>,
}

impl<A: Solve> Problem for PolygonCase<A> {
    fn given(&self) -> Vec<Given> {
        self.given.clone()
    }

    fn output(&self) -> Json {
        silent::<A>(&self.input).json()
    }

    fn cost(&self) -> (Json, Counts) {
        let (output, counts) = Counts::of(|| A::run::<Counted>(&self.input, |_| {}));
        (output.json(), counts)
    }

    fn run(&self) -> Box<dyn Run> {
        record::<A>(self.input.clone())
    }

    fn verdict(&self) -> Message {
        A::verdict(&silent::<A>(&self.input))
    }
}
