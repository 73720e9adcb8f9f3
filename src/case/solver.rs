//! How a lab's algorithms join, and what they make of a case.

use serde_json::Value as Json;

use crate::{
    figure::Run,
    text::{Message, Value},
    trace::Counts,
};

use super::{Field, Fields, Refusal, lines, polygons};

/// An algorithm that a case can name.
pub trait Solver: Sync {
    /// As the command line and JSON spell it.
    fn id(&self) -> &'static str;
    /// Catalogue key of its name.
    fn name_key(&self) -> &'static str;
    /// Author and year.
    fn source(&self) -> &'static str;
    /// What a case gives besides `id` and `algorithm`, in the order in which it is checked.
    fn fields(&self) -> &'static [Field];
    /// The problem that checked fields describe.
    ///
    /// # Errors
    /// The first field whose value is refused.
    fn read(&self, fields: &Fields<'_>) -> Result<Box<dyn Problem>, Refusal>;
}

/// A case that can be solved.
pub trait Problem {
    /// What is given, for people.
    fn given(&self) -> Vec<Given>;
    /// The answer as a program would ask for it: nothing counted, nothing recorded.
    fn output(&self) -> Json;
    /// The answer and its cost, without recording the steps.
    fn cost(&self) -> (Json, Counts);
    /// Every step.
    fn run(&self) -> Box<dyn Run>;
    /// The answer in one sentence.
    fn verdict(&self) -> Message;
}

/// One thing that a problem gives: "clip window: −1 ≤ x ≤ 1, −1 ≤ y ≤ 1".
#[derive(Clone, PartialEq, Debug)]
pub struct Given {
    /// Catalogue key of its name.
    pub name_key: &'static str,
    /// Set one after the other.
    pub values: Vec<Value>,
}

/// Every algorithm, in the order in which they are taught. A lab joins here.
pub fn solvers() -> impl Iterator<Item = &'static dyn Solver> {
    lines::solvers().chain(polygons::solvers())
}

/// The algorithm of this name.
#[must_use]
pub fn solver(id: &str) -> Option<&'static dyn Solver> {
    solvers().find(|solver| solver.id() == id)
}
