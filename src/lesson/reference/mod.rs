//! References: what stands in braces in a lesson's text is a value of a run or of a scene, filled in with the numbers of that very
//! run, in the reader's language.
//!
//! ```text
//!   {u_min}                 a name of the step: those of its watch table, its sentence and its formulas
//!   {event.r}               a field of the step's event          {scene.window[2]}   a field of its scene, as files spell it
//!   {output.segment[0]}     a field of the run's answer          {cost.mul}          operations up to the step; {steps} of the run
//!   {P₁.x}  {list[2]}       a coordinate, an entry               {"n·e"}  {len(…)}   a name with signs in it; a length
//!   {"r = q/p".value}       what a formula comes to
//!   {x₁ - 2 * (a + b)}      arithmetic; min, max, abs, sqrt, sin, cos, tan, acos, atan (in degrees); len, sum and count of a list
//!   {r @ leave right}       at another moment of the run         {r of further}      in another scene of the lesson
//!   {cost.div by brute-force @ end}     of a method that stands beside the first
//!   {differs by sh-corner}  the first step at which a mistake does something else than it should
//!   {events(cut left)}      how many events of the whole run have these words
//!   {d : 2}                 two decimals; also : fraction, : decimal, : grouped
//! ```

mod braces;
mod condition;
mod expression;
mod parse;
mod resolve;
mod written;

pub(super) use braces::Braces;
pub(super) use condition::Condition;
pub(super) use expression::{Expression, Form, Operator, Part, Reference, Root};
pub(super) use resolve::{Runs, Scenes};
pub(super) use written::{WrittenStep, WrittenText};
